//! Databases YDB (boreholes) and YDS (pressure sources), shared by the split dialect and Y-Geo.

use super::keyword::{Extent, Keyword, integer, of, real, reals};

const HOLES: &[Extent] = &[Extent::Size("MBORH")];
const HOLE_ENDS: &[Extent] = &[Extent::Size("MBDIM"), Extent::Size("MBORH")];
const SOURCES: &[Extent] = &[Extent::Size("MSOUR")];

pub(super) static YDB: &[Keyword] = &of(
    "YDB",
    [
        integer("MBORH", 0, "capacity: number of boreholes that the arrays hold"),
        integer("NBORH", 0, "number of boreholes; 0 switches them off"),
        integer("MBDIM", 0, "number of coordinates of the end points (2)"),
        integer("NBDIM", 0, "number of coordinates in use").no_effect(),
        integer("NBPAF", 0, "number of points of the factor table"),
        reals("D2BCA", HOLE_ENDS, "m", "end point A, where the detonation starts"),
        reals("D2BCB", HOLE_ENDS, "m", "end point B"),
        reals("D1BRAD", HOLES, "m", "radius"),
        reals(
            "D1BPAF",
            &[Extent::Size("NBPAF")],
            "-",
            "factors at equal intervals between start and end",
        ),
        reals("D1BPTS", HOLES, "s", "start of the pressure"),
        reals("D1BPTE", HOLES, "s", "end of the pressure"),
        reals("D1BVDT", HOLES, "m/s", "detonation velocity"),
        reals("D1BPRS", HOLES, "Pa", "pressure amplitude"),
        real("DBLMAX", 0.0, "m", "length of the longest borehole"),
        real("DBBUF", 0.0, "m", "search margin: size of the largest element"),
    ],
);

pub(super) static YDS: &[Keyword] = &of(
    "YDS",
    [
        integer("MSOUR", 0, "capacity: number of sources that the arrays hold"),
        integer("NSOUR", 0, "number of sources; 0 switches them off"),
        integer("MSDIM", 0, "number of coordinates of a source (2)"),
        integer("NSDIM", 0, "number of coordinates in use").no_effect(),
        integer("NSPAF", 0, "number of points of the factor table in time"),
        integer("NSSAF", 0, "number of points of the factor table in radius"),
        reals("D2SCS", &[Extent::Size("MSDIM"), Extent::Size("MSOUR")], "m", "positions"),
        reals(
            "D1SPAF",
            &[Extent::Size("NSPAF")],
            "-",
            "factors at equal intervals between start and end",
        ),
        reals("D1SSAF", &[Extent::Size("NSSAF")], "-", "factors over the relative radius 0 to 1"),
        reals("D1SPTS", SOURCES, "s", "start of the pressure"),
        reals("D1SPTE", SOURCES, "s", "end of the pressure"),
        reals("D1SVPR", SOURCES, "m/s", "velocity of the pressure front"),
        reals("D1SPRS", SOURCES, "Pa", "pressure amplitude"),
        reals("D1SSIR", SOURCES, "m", "initial radius"),
        real("DSBUF", 0.0, "m", "search margin: size of the largest element"),
    ],
);
