//! Cases with analytic and published answers, in their short variants.

mod support;

support::test_cases! {
    Validation | Classical =>
    simple_shear: "simple-shear";
    uniaxial: "uniaxial";
    pressure: "pressure";
    rotation: "rotation";
    two_bars: "two-bars";
    one_bar: "one-bar";
    sliding_block: "sliding-block";
    inelastic_impact: "inelastic-impact";
    elastic_impact: "elastic-impact";
    damping: "damping";
    semicircular_arch: "semicircular-arch";
    rocking_block: "rocking-block";
    incline: "incline";
    dominoes: "dominoes";
}
