//! The masonry cases in their short variants: large blocks, loads that come and go fast.

mod support;

support::test_cases! {
    Bridges | MasonryWall =>
    bridges_are_symmetric_under_self_weight: "self-weight";
    symmetry_needs_a_symmetric_mesh: "mesh-symmetry";
    a_point_load_arrives_at_the_ground: "point-load";
    a_distributed_load_arrives_at_the_ground: "distributed-load";
    deflection_and_arch_compression_under_the_train_grow_with_the_arch: "train";
    settling_supports_crack_the_ring_on_both_sides: "settlement";
    stresses_go_with_a_wave_of_load: "sine-load";
    the_weight_of_a_convoy_is_constant_and_bears_where_it_stands: "convoy";
    abrupt_loads_open_the_ring_at_key_and_flanks: "abrupt-load";
    the_shear_wall_is_linear_first: "tu-eindhoven";
}
