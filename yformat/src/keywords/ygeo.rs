//! Y-Geo (Toronto).

use super::Table;
use super::keyword::{Extent, Extent::Fixed, Keyword, integer, integers, of, real, reals};
use super::loads::{YDB, YDS};
use super::output::YDO;

mod fluids;
mod properties;
mod rebar;

const ELEMENTS: &[Extent] = &[Extent::Size("MELEM")];
const COUPLES: &[Extent] = &[Extent::Size("MICOUP")];
const NODES: &[Extent] = &[Extent::Size("MNOPO")];
const VECTORS: &[Extent] = &[Extent::Size("MNODIM"), Extent::Size("MNOPO")];

pub(super) static TABLES: &[Table] = &[
    Table { database: "YDC", reader: "Yrdc", exit_status: 103, keywords: YDC },
    Table { database: "YDE", reader: "Yrde", exit_status: 104, keywords: YDE },
    Table { database: "YDI", reader: "Yrdi", exit_status: 104, keywords: YDI },
    Table { database: "YDN", reader: "Yrdn", exit_status: 105, keywords: YDN },
    Table { database: "YDB", reader: "Yrdb", exit_status: 105, keywords: YDB },
    Table { database: "YDS", reader: "Yrds", exit_status: 105, keywords: YDS },
    Table { database: "YDO", reader: "Yrdo", exit_status: 105, keywords: YDO },
    Table { database: "YDPE", reader: "Yrdpe", exit_status: 104, keywords: properties::YDPE },
    Table { database: "YDPN", reader: "Yrdpn", exit_status: 104, keywords: properties::YDPN },
    Table { database: "YDPJ", reader: "Yrdpj", exit_status: 104, keywords: properties::YDPJ },
    Table { database: "YDPM", reader: "Yrdpm", exit_status: 104, keywords: properties::YDPM },
    Table { database: "YDFN", reader: "Yrdpm", exit_status: 104, keywords: fluids::YDFN },
    Table { database: "YDIS", reader: "Yrdis", exit_status: 104, keywords: fluids::YDIS },
    Table { database: "YDHF", reader: "Yrdhf", exit_status: 104, keywords: fluids::YDHF },
    Table { database: "YDSM", reader: "Yrdsm", exit_status: 104, keywords: fluids::YDSM },
    Table { database: "YDR", reader: "Yrdr", exit_status: 105, keywords: rebar::YDR },
    Table { database: "YDSB", reader: "Yrdsb", exit_status: 105, keywords: rebar::YDSB },
    Table { database: "YDPS", reader: "Yrdps", exit_status: 105, keywords: rebar::YDPS },
];

static YDC: &[Keyword] = &of(
    "YDC",
    [
        integer("MCSTEP", 0, "last step plus one: steps run while NCSTEP < MCSTEP").required(),
        integer("NCSTEP", 0, "first step; tables are set up at step 0 only"),
        real("DCGRAY", 0.0, "m/s²", "gravity in y, -9.81 points down"),
        real("DCSIZC", 1.0, "m", "output scale of coordinates").no_effect(),
        real("DCSIZF", 1.0, "N", "output scale of forces").no_effect(),
        real("DCSIZS", 1.0, "Pa", "output scale of stresses").indeterminate().no_effect(),
        real("DCSIZV", 1.0, "m/s", "output scale of velocities").no_effect(),
        real("DCSTEC", 1.0, "s", "time step").required(),
        real("DCTIME", 0.0, "s", "time at the first step"),
        integer(
            "ICOUTF",
            0,
            "states are written every so many steps; 0 divides by zero in the original",
        )
        .required(),
        integer(
            "ICOUTRF",
            0,
            "output interval once more than ICOUTNF joints are broken; 0: unchanged",
        ),
        integer("ICOUTNF", 0, "number of broken joints that switches to ICOUTRF"),
        integer("ICOUTI", 0, "number of the next output").no_effect(),
        integer("ICRESF", 0, "restart fragments are written every so many steps; 0: none"),
        integer("ICOUTP", 2, "characters per number of coded output").no_effect(),
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
        integer("NELNO", 0, "nodes per element given").required(),
        reals(
            "D2ELST",
            &[Extent::Size("MELST"), Extent::Size("MELEM")],
            "-",
            "state variables: row I1PSDE is the damage",
        )
        .required(),
        integers("I1ELCF", ELEMENTS, "first contact couple of the element").required(),
        integers("I1ELPR", ELEMENTS, "element property set, from 0").required().scratch_follows(),
        integers(
            "I2ELTO",
            &[Extent::Size("MELNO"), Extent::Size("MELEM")],
            "nodes of the element, from 0, counter-clockwise",
        )
        .required()
        .scratch_follows(),
    ],
);

static YDI: &[Keyword] = &of(
    "YDI",
    [
        integer("MICOUP", 0, "capacity: number of contact couples; 0 switches contact off"),
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
        integer("MISTATE", 0, "sliding states per couple: 6").indeterminate().required(),
        reals(
            "D2SLDIS",
            &[Extent::Size("MISTATE"), Extent::Size("MICOUP")],
            "m²",
            "accumulated sliding",
        ),
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
        .required(),
        integers("I1NOPR", NODES, "node set, from 0").required(),
        integers("I1NOWE", NODES, "fluid: 0 dry, 1 or 2 wet, 3 never wetted, -1 not involved")
            .required(),
    ],
);
