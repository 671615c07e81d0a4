//! Databases YDFN (fracture network), YDIS (in-situ stress), YDHF (hydrofracture) and YDSM
//! (seismic) of Y-Geo.

use super::{Extent, Fixed, Keyword, integer, integers, of, real, reals};

const FRACTURES: &[Extent] = &[Extent::Size("MDFNFR")];

pub(super) static YDFN: &[Keyword] = &of(
    "YDFN",
    [
        integer(
            "IUSEFN",
            0,
            "fracture network: 0 none, 1 broken from the start, 2 cohesive, 3 per fracture (I1DFFT)",
        ),
        integer("MDFNFR", 0, "number of fractures"),
        integer("MDFNNO", 0, "largest number of nodes of a fracture"),
        integers(
            "I2DFNN",
            &[Extent::Size("MDFNNO"), Extent::Size("MDFNFR")],
            "nodes of each fracture, padded with -1",
        ),
        reals("D1DFFR", FRACTURES, "-", "friction of each fracture"),
        reals("D1DFPE", FRACTURES, "Pa", "normal contact penalty of each fracture"),
        reals("D1DFPT", FRACTURES, "Pa", "tangential contact penalty of each fracture"),
        real("DDFNFT", 0.0, "Pa", "tensile strength of cohesive fractures"),
        real("DDFNCO", 0.0, "Pa", "cohesion of cohesive fractures"),
        real("DDFNGF", 0.0, "J/m²", "fracture energy of mode I of cohesive fractures"),
        real("DDFNGS", 0.0, "J/m²", "fracture energy of mode II of cohesive fractures"),
        integers("I1DFFT", FRACTURES, "kind of each fracture if IUSEFN is 3: 1 broken, 2 cohesive"),
    ],
);

pub(super) static YDIS: &[Keyword] = &of(
    "YDIS",
    [
        integer("IUSEIS", 0, "1: use the in-situ stress").compared_over(5),
        real("DCSTXX", 0.0, "Pa", "stress xx at the surface, compression positive"),
        real("DCSTXY", 0.0, "Pa", "stress xy at the surface"),
        real("DCSTYY", 0.0, "Pa", "stress yy at the surface, compression positive"),
        real("DCSYXX", 0.0, "Pa/m", "growth of stress xx with y"),
        real("DCSYXY", 0.0, "Pa/m", "growth of stress xy with y"),
        real("DCSYYY", 0.0, "Pa/m", "growth of stress yy with y"),
        real("DCSRFY", 0.0, "m", "y of the surface"),
    ],
);

/// `FLUPRES0`, the reference pressure, cannot be reached: the original compares `FLUPRES` first.
pub(super) static YDHF: &[Keyword] = &of(
    "YDHF",
    [
        integer("IUSEHF", 0, "1: use hydrofracturing"),
        integer("IHFTYP", 1, "1 pressure, 2 flow rate, 3 hydrostatic"),
        real("DHFFLP", 0.0, "Pa", "fluid pressure"),
        real("DHFFLQ", 0.0, "kg/(s·m)", "flow rate"),
        integer("HFAROW", 0, "number of records of D2HFAF"),
        reals("D2HFAF", &[Fixed(2), Extent::Size("HFAROW")], "s, -", "time and factor").fill(-1.0),
        real("FLUPRES", 0.0, "Pa", "initial pressure"),
        real("FLURHO0", 0.0, "kg/m³", "reference density"),
        real("FLUBULK", 0.0, "Pa", "bulk modulus"),
        integer("FRADIM", 2, "2 plane, 3 axisymmetric"),
        real("GRAVACC", 0.0, "m/s²", "gravity of the fluid"),
        reals(
            "D2WTLEV",
            &[Fixed(2), Fixed(2)],
            "m",
            "row 0: x of upstream and downstream side, row 1: water levels",
        )
        .fill(-1.0),
    ],
);

pub(super) static YDSM: &[Keyword] = &of(
    "YDSM",
    [
        integer(
            "IUSESM",
            0,
            "seismic energy: 0 largest since yield, 1 in a window of DCTWLE, 2 at failure",
        ),
        real("DCTWLE", 1.0, "s", "length of the window"),
    ],
);
