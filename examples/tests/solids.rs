//! The cases in space, in their short variants.

mod support;

support::test_cases! {
    Solids =>
    simple_shear: "simple-shear-3d";
    uniaxial: "uniaxial-3d";
    pressure: "pressure-3d";
    rotation: "rotation-3d";
    two_bars: "two-bars-3d";
    sliding_block: "sliding-block-3d";
    inelastic_impact: "inelastic-impact-3d";
    elastic_impact: "elastic-impact-3d";
    damping: "damping-3d";
    contact_laws: "contact-laws-3d";
    wall: "wall-3d";
}
