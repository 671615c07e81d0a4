//! The classic dialect: Munjiza's book program with the joints of Imperial College.

use super::Table;
use super::keyword::{Extent, Keyword, integer, integers, of, real, reals};
use super::output::YDO;

mod properties;

const ELEMENTS: &[Extent] = &[Extent::Size("MELEM")];
const TOPOLOGY: &[Extent] = &[Extent::Size("MELNO"), Extent::Size("MELEM")];
const JOINTS: &[Extent] = &[Extent::Size("NJOINT")];
const COUPLES: &[Extent] = &[Extent::Size("MICOUP")];
const NODES: &[Extent] = &[Extent::Size("MNOPO")];
const VECTORS: &[Extent] = &[Extent::Size("MNODIM"), Extent::Size("MNOPO")];

pub(super) static TABLES: &[Table] = &[
    Table { database: "YDC", reader: "Yrdc", exit_status: 103, keywords: YDC },
    Table { database: "YDE", reader: "Yrde", exit_status: 104, keywords: YDE },
    Table { database: "YDJ", reader: "Yrdj", exit_status: 104, keywords: YDJ },
    Table { database: "YDI", reader: "Yrdi", exit_status: 104, keywords: YDI },
    Table { database: "YDN", reader: "Yrdn", exit_status: 105, keywords: YDN },
    Table { database: "YDO", reader: "Yrdo", exit_status: 105, keywords: YDO },
    Table { database: "YDP", reader: "Yrdp", exit_status: 104, keywords: properties::YDP },
];

static YDC: &[Keyword] = &of(
    "YDC",
    [
        integer("MCSTEP", 0, "last step plus one: steps run while NCSTEP < MCSTEP").required(),
        integer(
            "NCSTEP",
            0,
            "first step; joints are set up at step 0 only, later starts need database YDJ",
        ),
        real("DCGRAY", 0.0, "m/s²", "gravity in y, -9.81 points down"),
        real("DCSIZC", 1.0, "m", "output scale of coordinates"),
        real("DCSIZF", 1.0, "N", "output scale of forces"),
        real("DCSIZS", 1.0, "Pa", "output scale of stresses").indeterminate().required(),
        real("DCSIZV", 1.0, "m/s", "output scale of velocities"),
        real("DCSIZD", 1.0, "m", "output scale of shear displacement and dilation").indeterminate(),
        real(
            "DCSIZA",
            1e-7,
            "m",
            "output scale of apertures: log10(aperture)/log10(DCSIZA) is written",
        )
        .indeterminate(),
        real("DCSTEC", 1.0, "s", "time step").required(),
        real("DCTIME", 0.0, "s", "time at the first step"),
        real("DCGRST", 0.0, "s", "settling time: loads are 0 before it").indeterminate(),
        real("DCRMPT", 0.0, "s", "ramp time: loads grow from 0 to full after the settling time")
            .indeterminate(),
        integer(
            "ICOUTF",
            0,
            "states are written every so many steps; 0 divides by zero in the original",
        )
        .required(),
        integer("ICOUTI", 0, "number of the next output file"),
        integer("ICSAVF", 0, "restart decks are written every so many steps; 0: none"),
        integer("ICOUTP", 2, "characters per number of coded output"),
        integer("ICFMTY", 0, "contact friction: 0 Coulomb, 1 Barton and Bandis"),
        integer("ICIATY", 0, "initial aperture: 0 from roughness, 1 from fracture length"),
    ],
);

static YDE: &[Keyword] = &of(
    "YDE",
    [
        integer("MELEM", 0, "capacity: number of elements including refined ones and joints")
            .required(),
        integer("NELEM", 0, "number of elements given").required(),
        integer("MELST", 0, "rows of D2ELST"),
        integer("NELST", 0, "number of state variables in use").no_effect(),
        integer("MELNO", 0, "rows of I2ELTO: 4 with joints").required(),
        integer("NELNO", 0, "nodes per element given"),
        reals(
            "D2ELST",
            &[Extent::Size("MELST"), Extent::Size("MELEM")],
            "-",
            "state variables: row I1PSDE is the damage",
        )
        .required(),
        integers("I1ELCF", ELEMENTS, "first contact couple of the element").required(),
        integers("I1ELPR", ELEMENTS, "property set, from 0").required(),
        integers(
            "I1ELTY",
            ELEMENTS,
            "kind: -1 triangle, 0 intact joint, 1 model boundary, 2 old fracture, 3 new crack",
        )
        .required(),
        integers(
            "I1ELYI",
            ELEMENTS,
            "acoustic emission: 0 none, 1 yielding, 2 broken, 3 reactivated",
        ),
        reals("D1ELEY", ELEMENTS, "J", "kinetic energy at yield"),
        reals("D1ELES", ELEMENTS, "J", "emitted energy"),
        reals("D1ELME", ELEMENTS, "-", "event magnitude").fill(-1e15),
        integers("I2ELTO", TOPOLOGY, "nodes of the element, from 0, counter-clockwise").required(),
        integers("I2ELJP", TOPOLOGY, "joint element on each edge of a triangle").required(),
        reals("D2ELFS", TOPOLOGY, "Pa", "shear strength at the three points of a joint (restart)")
            .may_be_undefined(),
    ],
);

/// What the program remembers of each joint.
const fn joint_state(name: &'static str, unit: &'static str, meaning: &'static str) -> Keyword {
    reals(name, JOINTS, unit, meaning).may_be_undefined()
}

static YDJ: &[Keyword] = &of(
    "YDJ",
    [
        integer("NJOINT", 0, "number of joint elements"),
        integers("I1JTID", JOINTS, "element number of the joint"),
        joint_state("D1JKNI", "Pa/m", "initial normal stiffness"),
        joint_state("D1JKNC", "Pa/m", "current normal stiffness"),
        joint_state("D1JKSC", "Pa/m", "current shear stiffness"),
        joint_state("D1JNST", "Pa", "normal stress, compression positive"),
        joint_state("D1JSST", "Pa", "shear stress"),
        joint_state("D1JAPI", "m", "initial mechanical aperture"),
        joint_state("D1JAPC", "m", "current mechanical aperture"),
        joint_state("D1JAPH", "m", "hydraulic aperture"),
        joint_state("D1JAPR", "m", "residual mechanical aperture"),
        joint_state("D1JSDC", "m", "shear displacement"),
        joint_state("D1JDLC", "m", "dilation"),
        joint_state("D1JSDP", "m", "peak shear displacement"),
        joint_state("D1JEFL", "m", "effective fracture length"),
        joint_state("D1JJRC", "-", "scaled roughness coefficient"),
        joint_state("D1JJCS", "MPa", "scaled wall strength"),
        joint_state("D1JPHI", "°", "mobilised asperity angle"),
        joint_state("D1JFMD", "-", "failure mode: 0 none, 1 tension, 2 shear, between mixed"),
        joint_state("D1JFPR", "Pa", "fluid pressure"),
        joint_state("D1JFET", "s", "time at which the fluid entered"),
    ],
);

static YDI: &[Keyword] = &of(
    "YDI",
    [
        integer("MICOUP", 0, "capacity: number of contact couples").required(),
        integer("NICOUP", 0, "number of contact couples").no_effect(),
        integer(
            "IIECFF",
            -2,
            "head of the list of free couples; -2: make the list at the first detection",
        ),
        real(
            "DIEDI",
            1e15,
            "m",
            "way travelled since the last detection; at least DIEZON: detect at once",
        ),
        real("DIEZON", 0.0, "m", "buffer around elements, about a fifth of the smallest element"),
        reals("D1IESL", COUPLES, "m", "sliding distance of older programs").no_effect(),
        integers("I1IECN", COUPLES, "next couple in the chain").required(),
        integers("I1IECT", COUPLES, "target element of the couple").required(),
    ],
);

static YDN: &[Keyword] = &of(
    "YDN",
    [
        integer("MNODIM", 0, "rows of the nodal arrays, at least 2").compared_over(5).required(),
        integer("NNODIM", 0, "dimension of the problem: 2").compared_over(5).required(),
        integer("MNOPO", 0, "capacity: number of nodes including those made by joint insertion")
            .required(),
        integer("NNOPO", 0, "number of nodes given").required(),
        reals("D1NMCT", NODES, "kg", "nodal mass").recomputed(),
        reals("D2NCC", VECTORS, "m", "current coordinates").required(),
        reals("D2NCI", VECTORS, "m", "initial, stress-free coordinates").required(),
        reals("D2NFC", VECTORS, "N", "nodal force").recomputed(),
        reals("D2NVC", VECTORS, "m/s", "velocities").required(),
        integers(
            "I1NOBF",
            NODES,
            "boundary flag: above 0 lets the elements of this node touch others",
        )
        .fill(1.0)
        .required(),
        integers("I1NOPR", NODES, "property set of type -1, from 0").required(),
    ],
);
