//! Databases YDP (element properties) and YDB (boundary sets) of the `.Y3D` lineage.

use super::{Extent, Keyword, integer, integers, of, reals};

const SETS: &[Extent] = &[Extent::Size("MPROP")];
const BOUNDARIES: &[Extent] = &[Extent::Size("MBCON")];

/// Longer names stand before the names that begin them.
pub(super) static YDP: &[Keyword] = &of(
    "YDP",
    [
        integer("MPROP", 0, "capacity: number of property sets that the arrays hold").required(),
        integer("NPROP", 0, "number of property sets").required(),
        integers(
            "I1PTYP",
            SETS,
            "type: 11 10-node, 13 4-node tetrahedron, 15 joint; others are refused",
        )
        .required(),
        reals("D1PELA", SETS, "Pa", "Lamé constant λ").required(),
        reals("D1PEMU", SETS, "Pa", "Lamé constant μ").required(),
        reals("D1PERO", SETS, "kg/m³", "density").required(),
        reals("D1PEKS", SETS, "Pa·s", "viscous damping"),
        reals("D1PEPSF", SETS, "Pa", "pressure scale of friction (disabled)").no_effect(),
        reals("D1PEPF", SETS, "-", "pressure friction (disabled)").no_effect(),
        reals("D1PEPE", SETS, "Pa", "contact penalty; stiffness of joints"),
        reals("D1PEFR", SETS, "-", "sliding friction coefficient"),
        reals("D1PESF", SETS, "-", "static friction (disabled)").no_effect(),
        reals("D1PEVF", SETS, "s/m", "velocity factor of friction (disabled)").no_effect(),
        reals("D1PEFT", SETS, "Pa", "tensile strength of joints"),
        reals("D1PEFS", SETS, "Pa", "shear strength of joints").no_effect(),
        reals("D1PCOH", SETS, "Pa", "cohesion of joints"),
        reals("D1PICF", SETS, "-", "tangent of the friction angle of joints"),
        reals("D1PEGFN", SETS, "J/m²", "fracture energy of mode I"),
        reals("D1PEGFS", SETS, "J/m²", "fracture energy of mode II"),
        reals("D1PEGF", SETS, "J/m²", "fracture energy of both modes (old decks)"),
        integers(
            "I1PEJP",
            SETS,
            "property set of the joints inserted between elements of this set",
        )
        .fill(0.0),
        integers("I1PEMN", SETS, "mesh code: 0, or 3, which inserts joints; others are refused")
            .fill(0.0),
        integers("I1PSDE", SETS, "state index").fill(0.0).no_effect(),
        integers("I1INDEX", SETS, "material group (Solidity)").ignored(),
        reals("D1TCON", SETS, "W/(m·K)", "conductivity (VGW)").ignored(),
        reals("D1CAPA", SETS, "J/(kg·K)", "heat capacity (VGW)").ignored(),
        reals("D1CTEX", SETS, "1/K", "thermal expansion (VGW)").refused("thermal expansion (VGW)"),
        reals("D1PEMR", SETS, "-", "mass scaling (Solidity)").refused("mass scaling (Solidity)"),
        reals("D1PEM0", SETS, "-", "damage parameter (Solidity)").ignored(),
        reals("D1PEMF", SETS, "-", "damage parameter (Solidity)").ignored(),
        reals("D1PEDM", SETS, "-", "damage parameter (Solidity)").ignored(),
    ],
);

pub(super) static YDB: &[Keyword] = &of(
    "YDB",
    [
        integer("MBCON", 0, "capacity: number of boundary sets that the arrays hold").required(),
        integer("NBCON", 0, "number of boundary sets").required(),
        integers(
            "I1BNVX",
            BOUNDARIES,
            "in x: 0 free, 1 given velocity; others, as 2 harmonic velocity (VGW), are refused",
        )
        .fill(0.0),
        integers(
            "I1BNVY",
            BOUNDARIES,
            "in y: 0 free, 1 given velocity; others, as 2 harmonic velocity (VGW), are refused",
        )
        .fill(0.0),
        integers(
            "I1BNVZ",
            BOUNDARIES,
            "in z: 0 free, 1 given velocity; others, as 2 harmonic velocity (VGW), are refused",
        )
        .fill(0.0),
        reals("D1BNVX", BOUNDARIES, "m/s", "velocity in x"),
        reals("D1BNVY", BOUNDARIES, "m/s", "velocity in y"),
        reals("D1BNVZ", BOUNDARIES, "m/s", "velocity in z"),
        reals("D1BNFX", BOUNDARIES, "N", "force per node in x (with code 2 a frequency)"),
        reals("D1BNFY", BOUNDARIES, "N", "force per node in y (with code 2 a frequency)"),
        reals("D1BNFZ", BOUNDARIES, "N", "force per node in z (with code 2 a frequency)"),
        reals("D1BNAX", BOUNDARIES, "m/s²", "acceleration in x, added to gravity"),
        reals("D1BNAY", BOUNDARIES, "m/s²", "acceleration in y, added to gravity"),
        reals("D1BNAZ", BOUNDARIES, "m/s²", "acceleration in z, added to gravity"),
        reals("D1BNAP", BOUNDARIES, "Pa", "nodal pressure (VGW)").refused("nodal pressures (VGW)"),
        integers("I1BNTP", BOUNDARIES, "temperature given (VGW)")
            .fill(0.0)
            .refused("temperatures (VGW)"),
        reals("D1BNTP", BOUNDARIES, "K", "temperature (VGW)").ignored(),
        integers("I1BNHF", BOUNDARIES, "heat flux given (VGW)")
            .fill(0.0)
            .refused("heat fluxes (VGW)"),
        reals("D1BNHF", BOUNDARIES, "W/m²", "heat flux (VGW)").ignored(),
        integers("I1BCVT", BOUNDARIES, "convection given (VGW)")
            .fill(0.0)
            .refused("convection (VGW)"),
        reals("D1BCVT", BOUNDARIES, "-", "convection datum (VGW)").ignored(),
        reals("D1BCVC", BOUNDARIES, "-", "convection datum (VGW)").ignored(),
    ],
);
