//! The split dialect (Queen Mary 2D/3D program).

use super::Table;
use super::keyword::{
    Adjustment::*, Extent, Extent::Fixed, Keyword, integer, integers, of, real, reals,
};
use super::loads::{YDB, YDS};
use super::output::YDO;

mod meshing;
mod properties;

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
    Table { database: "YDPM", reader: "Yrdpm", exit_status: 104, keywords: meshing::YDPM },
];

static YDC: &[Keyword] = &of("YDC", [
    integer("MCSTEP", 0, "last step plus one: steps run while NCSTEP < MCSTEP").required(),
    integer("NCSTEP", 0, "first step"),
    real("DCGRAX", 0.0, "m/s²", "gravity in x").only_3d(),
    real("DCGRAY", 0.0, "m/s²", "gravity in y, -9.81 points down"),
    real("DCGRAZ", 0.0, "m/s²", "gravity in z").only_3d(),
    real("DCSIZC", 1.0, "m", "output scale of coordinates").adjusted(RejectNegative).no_effect(),
    real("DCSIZF", 1.0, "N", "output scale of forces").adjusted(RejectNegative).no_effect(),
    real("DCSIZS", 1.0, "Pa", "output scale of stresses").adjusted(RejectNegative).no_effect(),
    real("DCSIZV", 1.0, "m/s", "output scale of velocities").adjusted(RejectNegative).no_effect(),
    real("DCSTEC", 0.0, "s", "time step").adjusted(RejectNegative).required(),
    real("DCTIME", 0.0, "s", "time at the first step"),
    real("DCURELX", 1.0, "-", "under-relaxation of the mass of 10-node tetrahedra").no_effect(),
    integer("INITER", 2, "iterations for the consistent mass of 10-node tetrahedra").no_effect(),
    integer("ICOUTT", 0, "kind of output file").adjusted(NonZeroTo(1)).no_effect(),
    integer("ICOUTF", 10, "states are written every so many steps; 10 if not positive").adjusted(NonPositiveTo(10)),
    integer("ICOUTI", 0, "number of the next output").adjusted(NegativeTo(0)).no_effect(),
    integer("ICOUTP", 4, "characters per number of coded output").adjusted(NegativeTo(4)).no_effect(),
    integer("ICSHTF", 100, "the progress table gets a row every so many steps; 100 if not positive")
        .adjusted(NonPositiveTo(100)),
    integer("IWFAST", 1, "0: every element may touch every other; above: only elements tagged by I1ELBE, never equal tags")
        .adjusted(NegativeTo(1)),
]);

static YDE: &[Keyword] = &of(
    "YDE",
    [
        integer("MELEM", 0, "capacity: number of elements including refined ones and joints")
            .required(),
        integer("NELEM", 0, "number of elements given").required(),
        integer(
            "MELST",
            0,
            "number of state variables of an element; at least 1 if mesh codes act",
        ),
        integer("NELST", 0, "number of state variables in use").no_effect(),
        integer("MELNO", 0, "rows of I2ELTO: 4 with 2D joints, 6 with 3D joints").required(),
        integer("NELNO", 0, "nodes per element given").required(),
        integers("I1ELCF", ELEMENTS, "first contact couple of the element")
            .created_by("MELEM", -1.0)
            .recomputed(),
        integers("I1ELBE", ELEMENTS, "contact tag of the element, see IWFAST")
            .created_by("MELEM", -1.0),
        integers("I1ELPR", ELEMENTS, "element property set, from 0").required(),
        reals(
            "D2ELST",
            &[Extent::Size("MELST"), Extent::Size("MELEM")],
            "-",
            "state variables: row I1PSDE is the damage",
        )
        .created_by("MELST", 0.0),
        integers(
            "I2ELTO",
            &[Extent::Size("MELNO"), Extent::Size("MELEM")],
            "nodes of the element, from 0, counter-clockwise",
        )
        .required(),
        reals("D3TCS", &[Fixed(3), Fixed(3), Extent::Size("MELEM")], "Pa", "Cauchy stress")
            .created_by("MELEM", 0.0)
            .recomputed(),
        reals("D1EMCT", ELEMENTS, "kg", "element mass").created_by("MELEM", 0.0).no_effect(),
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
        reals("D1IESL", COUPLES, "m", "sliding distance of older programs")
            .created_by("MICOUP", 0.0)
            .no_effect(),
        integers("I1IECN", COUPLES, "next couple in the chain").created_by("MICOUP", -1.0),
        integers("I1IECT", COUPLES, "target element of the couple").created_by("MICOUP", -1.0),
        integer("MISTATE", 0, "sliding states per couple: 6 for contact in 2D"),
        reals(
            "D2SLDIS",
            &[Extent::Size("MISTATE"), Extent::Size("MICOUP")],
            "m²",
            "accumulated sliding",
        )
        .created_by("MISTATE", 0.0),
    ],
);

static YDN: &[Keyword] = &of(
    "YDN",
    [
        integer("MNODIM", 0, "rows of the nodal arrays, at least NNODIM")
            .compared_over(5)
            .required(),
        integer("NNODIM", 0, "dimension of the problem: 2 or 3").compared_over(5).required(),
        integer("MNOPO", 0, "capacity: number of nodes including those made by joint insertion")
            .required(),
        integer("NNOPO", 0, "number of nodes given").required(),
        reals("D1NMCT", NODES, "kg", "nodal mass").created_by("MNOPO", 0.0).recomputed(),
        reals("D2NCC", VECTORS, "m", "current coordinates; the initial ones if absent"),
        reals("D2NCI", VECTORS, "m", "initial, stress-free coordinates").required(),
        reals("D2NFC", VECTORS, "N", "nodal force").created_by("MNOPO", 0.0).recomputed(),
        reals("D2NFT", VECTORS, "N", "total nodal force").created_by("MNOPO", 0.0).recomputed(),
        reals("D2NVC", VECTORS, "m/s", "velocities").created_by("MNOPO", 0.0),
        integers("I1NOBF", NODES, "boundary flag: 1 lets the elements of this node touch others")
            .created_by("MNOPO", 0.0),
        integers("I1NOPR", NODES, "node set, from 0").required(),
    ],
);
