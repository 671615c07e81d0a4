//! Rows whose fields are lists in the deck, one list per field.

/// How a field of a row is found, and the keyword of its list.
#[derive(Debug)]
pub(super) struct Column<R, T> {
    /// Name such as `YDJ/D1JKNI`.
    pub(super) keyword: &'static str,
    pub(super) get: fn(&R) -> T,
    pub(super) set: fn(&mut R, T),
}

/// A struct of reals and integers, with the columns in the order of the deck.
macro_rules! row {
    (
        $(#[$meta:meta])*
        $name:ident {
            reals {
                $($(#[$real_meta:meta])* $real_keyword:literal $real:ident,)*
            }
            integers {
                $($(#[$integer_meta:meta])* $integer_keyword:literal $integer:ident,)*
            }
        }
    ) => {
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, PartialEq, Default)]
        pub struct $name {
            $($(#[$real_meta])* pub $real: f64,)*
            $($(#[$integer_meta])* pub $integer: i64,)*
        }

        impl $name {
            /// Its reals.
            pub(super) const REALS: &'static [Column<Self, f64>] = &[$(Column {
                keyword: $real_keyword,
                get: |row| row.$real,
                set: |row, value| row.$real = value,
            },)*];
            /// Its integers.
            pub(super) const INTEGERS: &'static [Column<Self, i64>] = &[$(Column {
                keyword: $integer_keyword,
                get: |row| row.$integer,
                set: |row, value| row.$integer = value,
            },)*];
        }
    };
}

row! {
    /// What the program remembers of one joint. (deck.md 3.3)
    JointState {
        reals {
            /// Initial normal stiffness, Pa/m.
            "YDJ/D1JKNI" initial_normal_stiffness,
            /// Present normal stiffness, Pa/m.
            "YDJ/D1JKNC" normal_stiffness,
            /// Present shear stiffness, Pa/m.
            "YDJ/D1JKSC" shear_stiffness,
            /// Normal stress, Pa, compression positive.
            "YDJ/D1JNST" normal_stress,
            /// Shear stress, Pa.
            "YDJ/D1JSST" shear_stress,
            /// Initial mechanical aperture, m.
            "YDJ/D1JAPI" initial_aperture,
            /// Present mechanical aperture, m.
            "YDJ/D1JAPC" aperture,
            /// Hydraulic aperture, m.
            "YDJ/D1JAPH" hydraulic_aperture,
            /// Residual mechanical aperture, m.
            "YDJ/D1JAPR" residual_aperture,
            /// Shear displacement, m.
            "YDJ/D1JSDC" shear_displacement,
            /// Dilation, m.
            "YDJ/D1JDLC" dilation,
            /// Peak shear displacement, m.
            "YDJ/D1JSDP" peak_shear_displacement,
            /// Effective fracture length, m.
            "YDJ/D1JEFL" fracture_length,
            /// Scaled roughness coefficient.
            "YDJ/D1JJRC" roughness,
            /// Scaled wall strength, MPa.
            "YDJ/D1JJCS" wall_strength,
            /// Mobilised asperity angle, degrees.
            "YDJ/D1JPHI" asperity_angle,
            /// 0 none or pre-existing, 1 tension, 2 shear, between mixed.
            "YDJ/D1JFMD" failure_mode,
            /// Fluid pressure, Pa.
            "YDJ/D1JFPR" fluid_pressure,
            /// When the fluid entered, s.
            "YDJ/D1JFET" fluid_entry_time,
        }
        integers {
            /// Its element, from 0.
            "YDJ/I1JTID" element,
        }
    }
}

row! {
    /// A property set: of triangles, joints or nodes, as its kind says. (deck.md 3.7)
    PropertySet {
        reals {
            /// Tensile strength, Pa.
            "YDP/D1PEFT" tensile_strength,
            /// Fracture energy of mode I, J/m².
            "YDP/D1PEGT" fracture_energy_tension,
            /// Fracture energy of mode II, J/m².
            "YDP/D1PEGS" fracture_energy_shear,
            /// Viscous damping, Pa·s.
            "YDP/D1PEKS" viscosity,
            /// Lamé constant λ, Pa.
            "YDP/D1PELA" lame_lambda,
            /// Lamé constant μ, Pa.
            "YDP/D1PEMU" lame_mu,
            /// Joint penalty, Pa.
            "YDP/D1PEPE" joint_penalty,
            /// Contact penalty, Pa.
            "YDP/D1PEPC" contact_penalty,
            /// Fluid pressure in fractures, Pa.
            "YDP/D1PEPF" fluid_pressure,
            /// Friction against other sets.
            "YDP/D1PBIF" interface_friction,
            /// Cohesion, Pa.
            "YDP/D1PCOH" cohesion,
            /// Internal friction coefficient.
            "YDP/D1PICF" internal_friction,
            /// Friction within the set, residual friction of joints.
            "YDP/D1PEFR" friction,
            /// Density, kg/m³.
            "YDP/D1PERO" density,
            /// Roughness coefficient of the sample.
            "YDP/D1PJRC" joint_roughness,
            /// Wall strength of the sample, MPa.
            "YDP/D1PJCS" joint_wall_strength,
            /// Length of the sample, m.
            "YDP/D1PJSL" joint_sample_length,
            /// Factor on pressure and traction.
            "YDP/D1PNAF" load_factor,
            /// Growth of that factor per step.
            "YDP/D1PNAI" load_factor_increment,
            /// Pressure on edges, Pa.
            "YDP/D1PNAP" pressure,
            /// Traction along edges, Pa.
            "YDP/D1PNAT" traction,
            /// Amplitude in local x.
            "YDP/D1PNAX" amplitude_x,
            /// Amplitude in local y.
            "YDP/D1PNAY" amplitude_y,
            /// x of the local x axis.
            "YDP/D1PNXX" axis_x_x,
            /// y of the local x axis.
            "YDP/D1PNXY" axis_x_y,
            /// x of the local y axis.
            "YDP/D1PNYX" axis_y_x,
            /// y of the local y axis.
            "YDP/D1PNYY" axis_y_y,
            /// Largest tensile stretch of softening triangles.
            "YDP/D1PSEM" largest_stretch,
        }
        integers {
            /// Above 0: softening triangles may fracture.
            "YDP/I1PEFR" may_fracture,
            /// Set of the joints between its triangles.
            "YDP/I1PEJP" joint_set,
            /// Whether refinement flags the boundary.
            "YDP/I1PEMB" flag_boundary,
            /// Mesh code; 0 once the mesh is made.
            "YDP/I1PEMN" mesh_code,
            /// What is prescribed in local x.
            "YDP/I1PNFX" condition_x,
            /// What is prescribed in local y.
            "YDP/I1PNFY" condition_y,
            /// Row of the damage among the element states.
            "YDP/I1PSDE" damage_row,
            /// -1 nodes, 1 elastic, 2 rigid, 3 joint, 4 softening.
            "YDP/I1PTYP" kind,
        }
    }
}

row! {
    /// A history and where it stands. (deck.md 3.6)
    HistoryState {
        reals {
            /// Value at the last refresh.
            "YDO/D1OHYS" value,
            /// Factor on the time.
            "YDO/D1OHYC" time_factor,
            /// Factor on the value.
            "YDO/D1OHYF" value_factor,
            /// Time of the last refresh, s.
            "YDO/D1OHYT" time,
            /// x of the point, m.
            "YDO/D1OHYX" x,
            /// y of the point, m.
            "YDO/D1OHYY" y,
        }
        integers {
            /// Quantity: 15 kinetic energy.
            "YDO/I1OHYT" quantity,
        }
    }
}
