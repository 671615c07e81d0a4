//! Database YDP of the classic dialect: one table for triangles, joints and node sets, told apart
//! by I1PTYP.

use super::{Extent, Keyword, integer, integers, of, reals};

const SETS: &[Extent] = &[Extent::Size("MPROP")];

pub(super) static YDP: &[Keyword] = &of(
    "YDP",
    [
        integer("MPROP", 0, "capacity: number of property sets that the arrays hold").required(),
        integer("NPROP", 0, "number of property sets").required(),
        reals(
            "D1PBIF",
            SETS,
            "-",
            "contact friction between different sets (the smaller of the two)",
        )
        .required(),
        reals("D1PCOH", SETS, "Pa", "cohesion of joints").required(),
        reals("D1PECA", SETS, "-", "unused: procreation").no_effect(),
        reals("D1PECL", SETS, "-", "unused: procreation").no_effect(),
        reals(
            "D1PEFR",
            SETS,
            "-",
            "friction within a set (types 1, 2), residual friction (type 3)",
        )
        .required(),
        reals("D1PEFT", SETS, "Pa", "tensile strength of joints").required(),
        reals("D1PEGS", SETS, "J/m²", "fracture energy of mode II").required(),
        reals("D1PEGT", SETS, "J/m²", "fracture energy of mode I").required(),
        reals("D1PEKS", SETS, "Pa·s", "viscous damping").required(),
        reals("D1PELA", SETS, "Pa", "Lamé constant λ (acts twice its nominal value)").required(),
        reals("D1PEMU", SETS, "Pa", "Lamé constant μ").required(),
        reals("D1PEPC", SETS, "Pa", "contact penalty").required(),
        reals("D1PEPE", SETS, "Pa", "joint penalty").required(),
        reals("D1PEPF", SETS, "Pa", "fluid pressure in fractures").required(),
        reals("D1PERA", SETS, "m", "unused: radius of a sphere").no_effect(),
        reals("D1PERO", SETS, "kg/m³", "density").required(),
        reals("D1PEVI", SETS, "Pa·s", "viscosity").no_effect(),
        reals("D1PICF", SETS, "-", "internal friction coefficient of joints").required(),
        reals("D1PJCS", SETS, "MPa", "joint wall strength JCS of the sample").required(),
        reals("D1PJRC", SETS, "-", "joint roughness coefficient JRC of the sample").required(),
        reals("D1PJSL", SETS, "m", "sample length").required(),
        reals("D1PNAF", SETS, "-", "factor on pressure and traction").required(),
        reals("D1PNAI", SETS, "1/step", "growth of D1PNAF per step").required(),
        reals("D1PNAP", SETS, "Pa", "pressure on edges whose two nodes have one").required(),
        reals("D1PNAT", SETS, "Pa", "traction along the counter-clockwise edge").required(),
        reals("D1PNAX", SETS, "N, m/s², m/s", "amplitude in local x").required(),
        reals("D1PNAY", SETS, "N, m/s², m/s", "amplitude in local y").required(),
        reals("D1PNAZ", SETS, "N, m/s², m/s", "amplitude in local z").no_effect(),
        reals("D1PNXX", SETS, "-", "x of the local x axis").required(),
        reals("D1PNXY", SETS, "-", "y of the local x axis").required(),
        reals("D1PNXZ", SETS, "-", "z of the local x axis").no_effect(),
        reals("D1PNYX", SETS, "-", "x of the local y axis").required(),
        reals("D1PNYY", SETS, "-", "y of the local y axis").required(),
        reals("D1PNYZ", SETS, "-", "z of the local y axis").no_effect(),
        reals("D1PNZX", SETS, "-", "x of the local z axis").no_effect(),
        reals("D1PNZY", SETS, "-", "y of the local z axis").no_effect(),
        reals("D1PNZZ", SETS, "-", "z of the local z axis").no_effect(),
        reals("D1PSEM", SETS, "-", "largest tensile stretch of type 4"),
        integers("I1PECN", SETS, "unused: procreation").no_effect(),
        integers("I1PECP", SETS, "unused: procreation").no_effect(),
        integers("I1PECT", SETS, "unused: procreation").no_effect(),
        integers("I1PEFR", SETS, "above 0: elements of type 4 may fracture"),
        integers("I1PEJP", SETS, "property set of the joints that mesh code 3 inserts").required(),
        integers(
            "I1PEMB",
            SETS,
            "below 1: mesh codes 1 and 2 flag every node of refined elements as boundary",
        ),
        integers("I1PEMN", SETS, "mesh code: digits 1, 2 refine, 3 inserts joints, 4 separates")
            .required(),
        integers("I1PNFX", SETS, "in local x: 1 force, 2 acceleration, 3 velocity, else fixed")
            .required(),
        integers("I1PNFY", SETS, "in local y: 1 force, 2 acceleration, 3 velocity, else fixed")
            .required(),
        integers("I1PNFZ", SETS, "stored into I1PEMN by a slip of the original")
            .stores_into("I1PEMN")
            .no_effect(),
        integers("I1PNIB", SETS, "unused: borehole flag").no_effect(),
        integers("I1PTYP", SETS, "type of set: -1 node set, 1 elastic, 2 rigid, 3 joint")
            .required(),
        integers("I1PSDE", SETS, "row of D2ELST that holds the damage").required(),
    ],
);
