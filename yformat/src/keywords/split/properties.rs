//! Databases YDPE, YDPN and YDPJ of the split dialect: element, node and joint sets.

use super::{Extent, Fixed, Keyword, OutsideTo, integer, integers, of, reals};

const ELEMENT_SETS: &[Extent] = &[Extent::Size("MPROP")];
const NODE_SETS: &[Extent] = &[Extent::Size("MPNSET")];
const JOINT_SETS: &[Extent] = &[Extent::Size("MPJSET")];

pub(super) static YDPE: &[Keyword] = &of(
    "YDPE",
    [
        integer("MPROP", 0, "capacity: number of element sets that the arrays hold").required(),
        integer("NPROP", 0, "number of element sets").required(),
        reals("D1PECA", ELEMENT_SETS, "-", "unused: procreation").no_effect(),
        reals("D1PECL", ELEMENT_SETS, "-", "unused: procreation").no_effect(),
        reals("D1PEKS", ELEMENT_SETS, "Pa·s", "viscous damping").created_by("MPROP", 0.0),
        reals("D1PELA", ELEMENT_SETS, "Pa", "Lamé constant λ").required(),
        reals("D1PEMU", ELEMENT_SETS, "Pa", "Lamé constant μ").required(),
        reals("D1PEPE", ELEMENT_SETS, "Pa", "normal contact penalty").required(),
        // in the plane by the square of an edge, in space (an option) by the root of an area
        reals(
            "D1PEPT",
            ELEMENT_SETS,
            "Pa/m², in 3D Pa",
            "tangential contact penalty, needed for contact in 2D",
        ),
        reals(
            "D1PEFR",
            ELEMENT_SETS,
            "-",
            "Coulomb friction coefficient; in 3D with --contact-friction only",
        )
        .created_by("MPROP", 0.0),
        reals("D1PERA", ELEMENT_SETS, "m", "unused: radius of a sphere").no_effect(),
        reals("D1PERO", ELEMENT_SETS, "kg/m³", "density").required(),
        reals("D1PEVI", ELEMENT_SETS, "Pa·s", "viscosity").no_effect(),
        reals(
            "D1PSEM",
            ELEMENT_SETS,
            "-",
            "largest tensile stretch of type 4; must be present in 2D",
        ),
        integers("I1PECN", ELEMENT_SETS, "unused: procreation").no_effect(),
        integers("I1PECP", ELEMENT_SETS, "unused: procreation").no_effect(),
        integers("I1PECT", ELEMENT_SETS, "unused: procreation").no_effect(),
        integers("I1PEFR", ELEMENT_SETS, "above 0: elements of type 4 may fracture"),
        integers("I1PEJP", ELEMENT_SETS, "joint set of type 4; overwritten by I2PMIJ at meshing"),
        integers(
            "I1PEMB",
            ELEMENT_SETS,
            "below 1: mesh codes 1 and 2 flag every node of refined elements as boundary",
        )
        .created_by("MPROP", 0.0),
        integers("I1PEMN", ELEMENT_SETS, "mesh code of the classic dialect").no_effect(),
        integers("I1PNIB", ELEMENT_SETS, "unused: borehole flag").no_effect(),
        integers(
            "I1PTYP",
            ELEMENT_SETS,
            "element type: 1 elastic, 2 rigid, 4 softening triangle, 21 tetrahedron",
        )
        .required(),
        integers("I1PSDE", ELEMENT_SETS, "row of D2ELST that holds the damage")
            .created_by("MPROP", 0.0),
        reals("D1SHFN", ELEMENT_SETS, "-", "shell element, normal (Windows program only)")
            .fill(0.01)
            .created_by("MPROP", 0.01),
        reals("D1SHFS", ELEMENT_SETS, "-", "shell element, shear (Windows program only)")
            .fill(1.0)
            .created_by("MPROP", 1.0),
    ],
);

pub(super) static YDPN: &[Keyword] = &of(
    "YDPN",
    [
        integer("MPNSET", 0, "capacity: number of node sets that the arrays hold").required(),
        integer("NPNSET", 0, "number of node sets").required(),
        integer("MPNFACT", 0, "capacity: number of points of the factor table"),
        integer("NPNFACT", 0, "number of points of the factor table"),
        reals(
            "D3PNFAC",
            &[Fixed(2), Extent::Size("MPNSET"), Extent::Size("MPNFACT")],
            "s, -",
            "time and factor per set and point, usually in order 231; the factor is 1 outside the table",
        ),
        integers(
            "I1PNFX",
            NODE_SETS,
            "in local x: 1 force, 2 acceleration, 3 velocity, else fixed (2D) or free (3D)",
        )
        .created_by("MPNSET", -1.0),
        integers(
            "I1PNFY",
            NODE_SETS,
            "in local y: 1 force, 2 acceleration, 3 velocity, else fixed (2D) or free (3D)",
        )
        .created_by("MPNSET", -1.0),
        integers("I1PNFZ", NODE_SETS, "in local z: 1 force, 2 acceleration, 3 velocity, else free")
            .created_by("MPNSET", -1.0)
            .only_3d(),
        reals(
            "D1PNAF",
            NODE_SETS,
            "-",
            "factor on pressure and traction; overwritten by 1, then by D3PNFAC",
        )
        .fill(1.0)
        .created_by("MPNSET", 1.0)
        .recomputed(),
        reals("D1PNAP", NODE_SETS, "Pa", "pressure on edges whose two nodes have one")
            .created_by("MPNSET", 0.0),
        reals("D1PNAT", NODE_SETS, "Pa", "traction along the counter-clockwise edge")
            .created_by("MPNSET", 0.0),
        reals(
            "D1PNAX",
            NODE_SETS,
            "N, m/s², m/s",
            "amplitude in local x; 1 if the keyword is absent",
        )
        .created_by("MPNSET", 1.0),
        reals(
            "D1PNAY",
            NODE_SETS,
            "N, m/s², m/s",
            "amplitude in local y; 1 if the keyword is absent",
        )
        .created_by("MPNSET", 1.0),
        reals(
            "D1PNAZ",
            NODE_SETS,
            "N, m/s², m/s",
            "amplitude in local z; 1 if the keyword is absent",
        )
        .created_by("MPNSET", 1.0)
        .only_3d(),
        reals("D1PNXX", NODE_SETS, "-", "x of the local x axis")
            .fill(1.0)
            .created_by("MPNSET", 1.0),
        reals("D1PNXY", NODE_SETS, "-", "y of the local x axis").created_by("MPNSET", 0.0),
        reals("D1PNXZ", NODE_SETS, "-", "z of the local x axis")
            .created_by("MPNSET", 0.0)
            .only_3d(),
        reals("D1PNYX", NODE_SETS, "-", "x of the local y axis").created_by("MPNSET", 0.0),
        reals("D1PNYY", NODE_SETS, "-", "y of the local y axis")
            .fill(1.0)
            .created_by("MPNSET", 1.0),
        reals("D1PNYZ", NODE_SETS, "-", "z of the local y axis")
            .created_by("MPNSET", 0.0)
            .only_3d(),
        reals("D1PNZX", NODE_SETS, "-", "x of the local z axis")
            .created_by("MPNSET", 0.0)
            .only_3d(),
        reals("D1PNZY", NODE_SETS, "-", "y of the local z axis")
            .created_by("MPNSET", 0.0)
            .only_3d(),
        reals("D1PNZZ", NODE_SETS, "-", "z of the local z axis")
            .fill(1.0)
            .created_by("MPNSET", 1.0)
            .only_3d(),
    ],
);

pub(super) static YDPJ: &[Keyword] = &of(
    "YDPJ",
    [
        integer("MPJSET", 0, "capacity: number of joint sets that the arrays hold"),
        integer("NPJSET", 0, "number of joint sets"),
        integer(
            "NINTPT",
            7,
            "integration points of 3D joints: 3 or 7 (the Windows program always uses 3)",
        )
        .adjusted(OutsideTo(&[3, 7], 7))
        .only_3d(),
        reals(
            "D1PJFS",
            JOINT_SETS,
            "Pa",
            "shear strength; D1PJCO is used where it is not positive",
        ),
        reals("D1PJFT", JOINT_SETS, "Pa", "tensile strength"),
        reals("D1PJGF", JOINT_SETS, "J/m²", "fracture energy of both modes"),
        reals(
            "D1PJCO",
            JOINT_SETS,
            "Pa",
            "cohesion, 2D: above 0 the shear strength follows Mohr and Coulomb",
        )
        .created_by("MPJSET", 0.0),
        reals("D1PJFR", JOINT_SETS, "-", "friction coefficient of the joint, 2D")
            .created_by("MPJSET", 0.0),
        reals("D1PJPE", JOINT_SETS, "Pa", "joint penalty"),
        integers("I1PSDE", JOINT_SETS, "row of the damage").no_effect(),
        integers("I1PTYP", JOINT_SETS, "joint type: 3 in 2D, 23 between 4-node tetrahedra"),
    ],
);
