//! Databases YDPE, YDPN, YDPJ and YDPM of Y-Geo.

use super::{Extent, Fixed, Keyword, integer, integers, of, reals};

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
        reals("D1PEKS", ELEMENT_SETS, "Pa·s", "viscous damping").required(),
        reals(
            "D1PELA",
            ELEMENT_SETS,
            "Pa",
            "Lamé constant λ (acts twice its nominal value in type 1)",
        )
        .required(),
        reals("D1PEMU", ELEMENT_SETS, "Pa", "Lamé constant μ").required(),
        reals("D1PEPE", ELEMENT_SETS, "Pa", "contact penalty; D2PEINT is used instead").no_effect(),
        integer("MPEROW", 0, "number of records of D2PEINT"),
        reals(
            "D2PEINT",
            &[Fixed(5), Extent::Size("MPEROW")],
            "-, -, -, Pa, Pa",
            "contact records `i j μ p_n p_t`",
        )
        .required(),
        reals("D1PERA", ELEMENT_SETS, "m", "unused: radius of a sphere").no_effect(),
        reals("D1PERO", ELEMENT_SETS, "kg/m³", "density").required(),
        reals("D1PEVI", ELEMENT_SETS, "Pa·s", "viscosity").no_effect(),
        reals("D1PEEM", ELEMENT_SETS, "Pa", "Young's modulus, types 5 and 6").required(),
        reals("D1PENU", ELEMENT_SETS, "-", "Poisson's ratio, types 5 and 6").required(),
        reals("D1PEEX", ELEMENT_SETS, "Pa", "Young's modulus in x").required(),
        reals("D1PEEY", ELEMENT_SETS, "Pa", "Young's modulus in y").required(),
        reals("D1PEMX", ELEMENT_SETS, "-", "Poisson's ratio xy").required(),
        reals("D1PEMY", ELEMENT_SETS, "-", "Poisson's ratio yx").required(),
        reals("D1PEG", ELEMENT_SETS, "Pa", "shear modulus").required(),
        integers(
            "I1USAN",
            ELEMENT_SETS,
            "elasticity: 0 or -1 isotropic, 1 and 2 transversely isotropic",
        )
        .required(),
        reals("D1PSEM", ELEMENT_SETS, "-", "largest tensile stretch of type 4"),
        integers("I1PECN", ELEMENT_SETS, "unused: procreation").no_effect(),
        integers("I1PECP", ELEMENT_SETS, "unused: procreation").no_effect(),
        integers("I1PECT", ELEMENT_SETS, "unused: procreation").no_effect(),
        integers("I1PEFR", ELEMENT_SETS, "above 0: elements of type 4 may fracture"),
        integers("I1PEJP", ELEMENT_SETS, "joint set; overwritten by I2PMIJ at meshing")
            .recomputed(),
        integers(
            "I1PEMB",
            ELEMENT_SETS,
            "below 1: mesh codes 1 and 2 flag every node of refined elements as boundary",
        ),
        integers("I1PEMN", ELEMENT_SETS, "mesh code of the classic dialect").no_effect(),
        integers("I1PNIB", ELEMENT_SETS, "unused: borehole flag").no_effect(),
        integers(
            "I1PTYP",
            ELEMENT_SETS,
            "element type: 1 elastic, 2 rigid, 5 plane stress, 6 plane strain",
        )
        .required(),
        integers("I1PSDE", ELEMENT_SETS, "row of D2ELST that holds the damage").required(),
        integers("I1PEXC", ELEMENT_SETS, "1: excavated, the elements are taken out").required(),
        integers(
            "I1PSUP",
            ELEMENT_SETS,
            "1: support, initial coordinates become the current ones once",
        ),
    ],
);

pub(super) static YDPN: &[Keyword] = &of("YDPN", [
    integer("MPNSET", 0, "capacity: number of node sets that the arrays hold").required(),
    integer("NPNSET", 0, "number of node sets").required(),
    integer("MPNFACT", 0, "capacity: number of points of the factor table"),
    integer("NPNFACT", 0, "number of points of the factor table"),
    reals(
        "D3PNFAC",
        &[Fixed(2), Extent::Size("MPNSET"), Extent::Size("MPNFACT")],
        "s, -",
        "time and factor per set and point, usually in order 231; the factor is 1 outside the table",
    )
    .fill(-1.0),
    integers("I1PNFX", NODE_SETS, "in local x: 1 force, 2 acceleration, 3 velocity, 4 absorbing, else fixed").required(),
    integers("I1PNFY", NODE_SETS, "in local y: 1 force, 2 acceleration, 3 velocity, 4 absorbing, else fixed").required(),
    integers("I1PNFZ", NODE_SETS, "in local z").no_effect(),
    reals("D1PNAF", NODE_SETS, "-", "factor on loads; do not give it, the original then reads freed memory").recomputed(),
    reals("D1PNAP", NODE_SETS, "Pa", "pressure on edges whose two nodes have one").required(),
    reals("D1PNAT", NODE_SETS, "Pa", "traction along the counter-clockwise edge").required(),
    reals("D1PNAX", NODE_SETS, "N, m/s², m/s", "amplitude in local x").required(),
    reals("D1PNAY", NODE_SETS, "N, m/s², m/s", "amplitude in local y").required(),
    reals("D1PNAZ", NODE_SETS, "N, m/s², m/s", "amplitude in local z").no_effect(),
    reals("D1PNXX", NODE_SETS, "-", "x of the local x axis").required(),
    reals("D1PNXY", NODE_SETS, "-", "y of the local x axis").required(),
    reals("D1PNXZ", NODE_SETS, "-", "z of the local x axis").no_effect(),
    reals("D1PNYX", NODE_SETS, "-", "x of the local y axis").required(),
    reals("D1PNYY", NODE_SETS, "-", "y of the local y axis").required(),
    reals("D1PNYZ", NODE_SETS, "-", "z of the local y axis").no_effect(),
    reals("D1PNZX", NODE_SETS, "-", "x of the local z axis").no_effect(),
    reals("D1PNZY", NODE_SETS, "-", "y of the local z axis").no_effect(),
    reals("D1PNZZ", NODE_SETS, "-", "z of the local z axis").no_effect(),
]);

pub(super) static YDPJ: &[Keyword] = &of(
    "YDPJ",
    [
        integer("MPJSET", 0, "capacity: number of joint sets that the arrays hold").required(),
        integer("NPJSET", 0, "number of joint sets").required(),
        reals(
            "D1PJFS",
            JOINT_SETS,
            "Pa",
            "shear strength; D1PJCO is used where it is not positive",
        )
        .required(),
        reals("D1PJFT", JOINT_SETS, "Pa", "tensile strength").required(),
        reals("D1PJGF", JOINT_SETS, "J/m²", "fracture energy of mode I").required(),
        reals("D1PJGS", JOINT_SETS, "J/m²", "fracture energy of mode II").required(),
        reals("D1PJCO", JOINT_SETS, "Pa", "cohesion").required(),
        reals("D1PJFR", JOINT_SETS, "-", "friction coefficient of the joint").required(),
        reals("D1PJPE", JOINT_SETS, "Pa", "joint penalty").required(),
        integers("I1PSDE", JOINT_SETS, "row of the damage").no_effect(),
        integers("I1PTYP", JOINT_SETS, "joint type: 3, or 8 for concrete").required(),
        integer("IUSEHY", 0, "other than 0: hysteretic unloading"),
        reals("D1USAF", JOINT_SETS, "-", "above 0: exponent of the anisotropic strength")
            .fill(-1.0)
            .required(),
        reals("D1PJAL", JOINT_SETS, "°", "angle of the layering").required(),
        reals("D1PJCR", JOINT_SETS, "Pa", "reduced cohesion").required(),
        reals("D1PJFD", JOINT_SETS, "-", "reduced friction").required(),
        reals("D1PJTR", JOINT_SETS, "Pa", "reduced tensile strength").required(),
        reals("D1PJGR", JOINT_SETS, "J/m²", "reduced fracture energy of mode I").required(),
        reals("D1PJSR", JOINT_SETS, "J/m²", "reduced fracture energy of mode II").required(),
    ],
);

pub(super) static YDPM: &[Keyword] = &of(
    "YDPM",
    [
        integer("MPMCOM", 0, "number of records of I2PMSET; 0: nothing is meshed"),
        integer("MPMCOL", 0, "length of a record of I2PMSET"),
        integers(
            "I2PMSET",
            &[Extent::Size("MPMCOL"), Extent::Size("MPMCOM")],
            "records `count code set1 set2 ...`",
        ),
        integer("MPMROW", 0, "number of records of I2PMIJ"),
        integers("I2PMIJ", &[Fixed(3), Extent::Size("MPMROW")], "records `setA setB jointset`"),
    ],
);
