//! The `.Y3D` lineage (VGW and Solidity).

use super::Table;
use super::keyword::{Extent, Extent::Fixed, Keyword, integer, integers, of, real, reals};
use super::output::YDO;

mod bodies;
mod properties;

const ELEMENTS: &[Extent] = &[Extent::Size("MELEM")];
const COUPLES: &[Extent] = &[Extent::Size("MICOUP")];
const COUPLE_VECTORS: &[Extent] = &[Fixed(3), Extent::Size("MICOUP")];
const NODES: &[Extent] = &[Extent::Size("MNOPO")];
const VECTORS: &[Extent] = &[Extent::Size("MNODIM"), Extent::Size("MNOPO")];

pub(super) static TABLES: &[Table] = &[
    Table { database: "YDC", reader: "Yrdc", exit_status: 103, keywords: YDC },
    Table { database: "YDE", reader: "Yrde", exit_status: 104, keywords: YDE },
    Table { database: "YDI", reader: "Yrdi", exit_status: 104, keywords: YDI },
    Table { database: "YDN", reader: "Yrdn", exit_status: 105, keywords: YDN },
    Table { database: "YDO", reader: "Yrdo", exit_status: 105, keywords: YDO },
    Table { database: "YDP", reader: "Yrdp", exit_status: 104, keywords: properties::YDP },
    Table { database: "YDB", reader: "Yrdb", exit_status: 105, keywords: properties::YDB },
    Table { database: "YDX", reader: "Yrdx", exit_status: 105, keywords: bodies::YDX },
    Table { database: "YDJ", reader: "Yrdj", exit_status: 104, keywords: bodies::YDJ },
    Table { database: "YSP", reader: "Yrsp", exit_status: 105, keywords: bodies::YSP },
];

static YDC: &[Keyword] = &of(
    "YDC",
    [
        integer("MCSTEP", 0, "last step plus one: steps run while NCSTEP < MCSTEP").required(),
        integer("NCSTEP", 0, "first step"),
        real("DCGRAX", 0.0, "m/s²", "gravity in x"),
        real("DCGRAY", 0.0, "m/s²", "gravity in y"),
        real("DCGRAZ", 0.0, "m/s²", "gravity in z"),
        real("DCSTEC", 1.0, "s", "time step").required(),
        real("DCTIME", 0.0, "s", "time at the first step"),
        real("DCSIZC", 1.0, "m", "output scale of coordinates").ignored(),
        real("DCSIZF", 1.0, "N", "output scale of forces").ignored(),
        real("DCSIZS", 1.0, "Pa", "output scale of stresses").indeterminate().ignored(),
        real("DCSIZV", 1.0, "m/s", "output scale of velocities").ignored(),
        real("DCRMPT", 0.0, "s", "ramp time of surface pressures"),
        real("DCURELX", 1.0, "-", "relaxation of the iteration for the consistent mass").ignored(),
        integer(
            "INITER",
            2,
            "passes of the iteration for the consistent mass: 0, lumped, is what is simulated",
        ),
        integer("ICOUTF", 0, "states are written every so many steps"),
        integer("ICOUTI", 0, "number of the next output").ignored(),
        integer("ICOUTP", 2, "characters per number of coded output").ignored(),
        integer("IWFAST", 1, "other than 0: only tagged elements touch, never those of one body"),
        integer("ISAVE", 1000, "restart data are written every so many steps").ignored(),
        real("DCGRST", 0.0, "s", "settling time (Solidity)")
            .refused("the five stages of a load (Solidity)"),
        real("DCRMCT", 0.0, "s", "hold time of the load (Solidity)")
            .refused("the five stages of a load (Solidity)"),
        real("DCRMUT", 0.0, "s", "unload time (Solidity)")
            .refused("the five stages of a load (Solidity)"),
        real("DCRMJT", 0.0, "s", "ramp time of the jet (Solidity)").refused("jets (Solidity)"),
        real("DCSTDN", 0.0, "m", "stand-off of the jet (Solidity)").ignored(),
        real("DCFACT1", 1.0, "-", "grain factor 1 (Solidity)").ignored(),
        real("DCFACT2", 1.0, "-", "grain factor 2 (Solidity)").ignored(),
        real("DCFACT3", 1.0, "-", "grain factor 3 (Solidity)").ignored(),
        real("DCFACT4", 1.0, "-", "grain factor 4 (Solidity)").ignored(),
        real("DCFACT5", 1.0, "-", "grain factor 5 (Solidity)").ignored(),
        real("DCIMVELX", 0.0, "m/s", "impact velocity in x (Solidity)")
            .refused("impact velocities (Solidity)"),
        real("DCIMVELY", 0.0, "m/s", "impact velocity in y (Solidity)")
            .refused("impact velocities (Solidity)"),
        real("DCIMVELZ", 0.0, "m/s", "impact velocity in z (Solidity)")
            .refused("impact velocities (Solidity)"),
        integer("ICHPRM", 0, "chip removal (Solidity)").refused("chip removal (Solidity)"),
    ],
);

static YDE: &[Keyword] = &of(
    "YDE",
    [
        integer("MELEM", 0, "capacity: number of elements including joints").required(),
        integer("NELEM", 0, "number of elements given").required(),
        integer("MELST", 0, "number of state variables").no_effect(),
        integer("NELST", 0, "number of state variables in use").no_effect(),
        integer("MELNO", 0, "rows of I2ELTO: NELNO + 1").required(),
        integer("NELNO", 0, "numbers per element: nodes and body, 5 or 11").required(),
        integer("LAYMX", 1, "largest body number (Solidity)").ignored(),
        integers("I1ELCF", ELEMENTS, "first contact couple of the element").ignored(),
        integers("I1ELBE", ELEMENTS, "body number of elements with a surface node"),
        integers("I1ELPR", ELEMENTS, "property set, from 0").fill(0.0),
        reals("D2ELST", &[Extent::Size("MELST"), Extent::Size("MELEM")], "-", "state variables")
            .no_effect(),
        integers(
            "I2ELTO",
            &[Extent::Size("MELNO"), Extent::Size("MELEM")],
            "nodes of the element, from 0, then its body",
        )
        .required(),
        integers(
            "I2ELBNP",
            &[Fixed(4), Extent::Size("MELEM")],
            "surface triangle that loads each face, -1 none",
        )
        .ignored(),
        reals(
            "D3TCS",
            &[Fixed(3), Fixed(3), Extent::Size("MELEM")],
            "Pa",
            "Cauchy stress (restart)",
        )
        .short_header()
        .ignored(),
        reals("D1EMCT", ELEMENTS, "kg", "element mass").recomputed(),
    ],
);

static YDI: &[Keyword] = &of(
    "YDI",
    [
        integer("MICOUP", 0, "capacity: number of contact couples; 0 switches contact off"),
        integer("NICOUP", 0, "number of contact couples").ignored(),
        integer(
            "IIECFF",
            -2,
            "head of the list of free couples; -2: make the list at the first detection, others are refused",
        ),
        real(
            "DIEDI",
            1e15,
            "m",
            "way travelled since the last detection; at least DIEZON: detect at once",
        ),
        real("DIEZON", 0.0, "m", "buffer around elements"),
        real("DRECT", 0.0, "m", "cell size of the detection grid (Solidity)").ignored(),
        reals("D1IESL", COUPLES, "m", "sliding distance").ignored(),
        integers("I1IECN", COUPLES, "next couple in the chain").ignored(),
        integers("I1IECT", COUPLES, "target element of the couple").ignored(),
        integers("I1STAT", COUPLES, "state of the couple (Solidity)").ignored(),
        reals("D1DELTAT1", COUPLES, "m", "slip along the first tangent").ignored(),
        reals("D1DELTAT2", COUPLES, "m", "slip along the second tangent").ignored(),
        reals("D1DELTAN", COUPLES, "m", "normal approach").ignored(),
        reals("D2NV", COUPLE_VECTORS, "-", "contact normal").ignored(),
        reals("D2T1V", COUPLE_VECTORS, "-", "first tangent").ignored(),
        reals("D2T2V", COUPLE_VECTORS, "-", "second tangent").ignored(),
    ],
);

static YDN: &[Keyword] = &of(
    "YDN",
    [
        integer("MNODIM", 0, "rows of the nodal arrays (4)").compared_over(5).required(),
        integer("NNODIM", 0, "dimension of the problem: 3").compared_over(5).required(),
        integer("MNOPO", 0, "capacity: number of nodes including those made by joint insertion")
            .required(),
        integer("NNOPO", 0, "number of nodes given").required(),
        reals("D1NMCT", NODES, "kg", "nodal mass").recomputed(),
        reals("D1NTI", NODES, "K", "initial temperature (VGW)").ignored(),
        reals("D1NTC", NODES, "K", "current temperature (VGW)").ignored(),
        reals("D1NTP", NODES, "K", "temperature of the fluid solver (VGW)").ignored(),
        reals("D1NVCT", NODES, "-", "restart data (VGW)").ignored(),
        reals("D2NCC", VECTORS, "m", "current coordinates").required(),
        reals("D2NCI", VECTORS, "m", "initial, stress-free coordinates").required(),
        reals("D2NCK", VECTORS, "m", "coordinates at the last detection (Solidity)").ignored(),
        reals("D2NVC", VECTORS, "m/s", "velocities"),
        reals("D2NVT", VECTORS, "m/s", "velocity of the fluid (VGW)")
            .refused("velocities of a fluid (VGW)"),
        reals("D2NFC", VECTORS, "N", "nodal force").recomputed(),
        reals("D2NFT", VECTORS, "N", "total nodal force").recomputed(),
        reals("D2NFD", VECTORS, "N", "restart data (VGW)").ignored(),
        reals("D2NDF", VECTORS, "m", "further nodal data (Solidity)").ignored(),
        integers("I1NOBF", NODES, "body number of a surface node, 0 inside").fill(0.0),
        integers("I1NOPR", NODES, "boundary set of database YDB, from 0").fill(0.0),
    ],
);
