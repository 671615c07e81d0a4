//! Databases YDR (reference points), YDSB (bars) and YDPS (steel) of Y-Geo.

use super::{Extent, Fixed, Keyword, integer, integers, of, reals};

const POINTS: &[Extent] = &[Extent::Size("MREPO")];
const POINT_VECTORS: &[Extent] = &[Extent::Size("MNODIM"), Extent::Size("MREPO")];
const POINT_LOCALS: &[Extent] = &[Extent::Size("MRLDM"), Extent::Size("MREPO")];
const PAIRS: &[Extent] = &[Fixed(2), Extent::Size("MREPO")];
const BARS: &[Extent] = &[Extent::Size("MSBAR")];
const STEELS: &[Extent] = &[Extent::Size("MPROP")];

pub(super) static YDR: &[Keyword] = &of(
    "YDR",
    [
        integer("MNODIM", 0, "rows of the coordinate arrays"),
        integer("NNODIM", 0, "coordinates in use"),
        integer("MRDIM", 0, "dimension").no_effect(),
        integer("NRDIM", 0, "dimension in use").no_effect(),
        integer("MRLDM", 0, "local coordinates of a reference point (3)"),
        integer("NRLDM", 0, "local coordinates in use"),
        integer("MREPO", 0, "capacity: number of reference points"),
        integer("NREPO", 0, "number of reference points"),
        integer("NBRJOINTRB", 0, "internal counter, starts at 0"),
        reals("D2RCIG", POINT_VECTORS, "m", "initial coordinates"),
        reals("D2RCCG", POINT_VECTORS, "m", "current coordinates"),
        reals("D2RVCG", POINT_VECTORS, "m/s", "velocities"),
        reals("D2RCCL", POINT_LOCALS, "-", "current local coordinates").no_effect(),
        reals("D2RILC", POINT_LOCALS, "-", "initial local coordinates"),
        reals("D2RSCTR", PAIRS, "-", "internal work array"),
        integers("I2RELTO", PAIRS, "internal work array"),
        integers("I1RMYEL", POINTS, "internal work array"),
        integers("I1RRPN", POINTS, "internal work array"),
        integers("I1RPROP", POINTS, "internal work array"),
        integers("I1REFBAR", POINTS, "internal work array"),
        integers("I1MYJOINT", POINTS, "internal work array; leave it out"),
    ],
);

pub(super) static YDSB: &[Keyword] = &of(
    "YDSB",
    [
        integer("MSDIM", 0, "coordinates of a bar (4)"),
        integer("NSDIM", 0, "coordinates in use"),
        integer("MSBAR", 0, "capacity: number of bars"),
        integer("NSBAR", 0, "number of bars; 0 switches them off"),
        integer("ISFIRST", 0, "other than 0: bars exist already"),
        reals(
            "D2SIC",
            &[Extent::Size("MSDIM"), Extent::Size("MSBAR")],
            "m",
            "records `xA yA xB yB`",
        ),
        integers("I1SRPF", &[Extent::Size("NSBAR")], "internal work array").recomputed(),
        integers("I1SBPR", BARS, "steel set"),
        reals("D1SPEA", BARS, "m²", "cross section").fill(-1.0),
        reals("D1SDIAM", BARS, "m", "diameter").fill(-1.0),
        reals("D1SMMDIAM", BARS, "mm", "diameter").fill(-1.0),
        reals("D1CRLCR", BARS, "mm", "unused").fill(-1.0).no_effect(),
        integers(
            "I1SBTY",
            BARS,
            "kind: 0 elastic, 1 plastic, 5 elastic, 6 elastoplastic, 7 friction",
        ),
        integers("I1SBAC", BARS, "0 inactive, 1 activate at the next step, 2 active"),
    ],
);

pub(super) static YDPS: &[Keyword] = &of(
    "YDPS",
    [
        integer("MPROP", 0, "capacity: number of steel sets"),
        integer("NPROP", 0, "number of steel sets"),
        reals("D1YOUNG", STEELS, "Pa", "Young's modulus").fill(-1.0),
        reals("D1SFC", STEELS, "Pa", "strength of the concrete").fill(-1.0),
        reals("D1MPSFC", STEELS, "MPa", "strength of the concrete").fill(-1.0),
        reals("D1SFY", STEELS, "Pa", "steel law, named by the original only").fill(-1.0),
        reals("D1EPSSH", STEELS, "-", "steel law, named by the original only").fill(-1.0),
        reals("D1SFU", STEELS, "Pa", "steel law, named by the original only").fill(-1.0),
        reals("D1EPSU", STEELS, "-", "steel law, named by the original only").fill(-1.0),
        reals("D1SFBR", STEELS, "Pa", "break strength; computed with but without use").fill(-1.0),
        reals("D1EPSBR", STEELS, "-", "steel law, named by the original only").fill(-1.0),
        reals("D1STKN", STEELS, "Pa/m", "normal law, types 5 to 7").fill(-1.0),
        reals("D1STKT", STEELS, "Pa/m", "tangential law, types 5 to 7").fill(-1.0),
        reals("D1STYNS", STEELS, "Pa", "law of type 6").fill(-1.0),
        reals("D1STRNS", STEELS, "-", "law of type 6").fill(-1.0),
        reals("D1STCOH", STEELS, "Pa", "cohesion, type 7").fill(-1.0),
        reals("D1STFRI", STEELS, "-", "friction, type 7").fill(-1.0),
    ],
);
