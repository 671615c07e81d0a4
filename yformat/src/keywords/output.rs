//! Database YDO (histories), the same in every dialect but for the third coordinate.

use super::keyword::{Extent, Keyword, integer, integers, of, real, reals};

const HISTORIES: &[Extent] = &[Extent::Size("MOHYS")];

pub(super) static YDO: &[Keyword] = &of(
    "YDO",
    [
        integer("MOHYS", 0, "capacity: number of histories that the arrays hold").required(),
        integer("NOHYS", 0, "number of histories written"),
        real(
            "DOHYP",
            0.05,
            "-",
            "change that refreshes a history: relative for energies, absolute at points (split, Y-Geo)",
        ),
        reals("D1OHYC", HISTORIES, "-", "factor applied to the time when written"),
        reals("D1OHYF", HISTORIES, "-", "factor applied to the value when written"),
        reals("D1OHYS", HISTORIES, "-", "value at the last refresh (start value)"),
        reals("D1OHYT", HISTORIES, "s", "time of the last refresh (start value)"),
        reals("D1OHYX", HISTORIES, "m", "x of the point"),
        reals("D1OHYY", HISTORIES, "m", "y of the point"),
        reals("D1OHYZ", HISTORIES, "m", "z of the point").no_effect(),
        integers(
            "I1OHYT",
            HISTORIES,
            "quantity: 15 kinetic energy; in split and Y-Geo also 1 σxx, 2 σxy, 3 σyy, 7 speed, 8 vx, 9 vy, 18 Fx, 19 Fy",
        ),
    ],
);
