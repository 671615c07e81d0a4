//! Databases YDX (surface triangles), YDJ (joints) and YSP (rigid bodies) of the `.Y3D` lineage.

use super::{Extent, Fixed, Keyword, integer, integers, of, real, reals};

const TRIANGLES: &[Extent] = &[Extent::Size("NELEM")];
const BODIES: &[Extent] = &[Extent::Size("MSPD")];
const BODY_VECTORS: &[Extent] = &[Fixed(3), Extent::Size("MSPD")];

pub(super) static YDX: &[Keyword] = &of(
    "YDX",
    [
        integer("MELEM", 0, "capacity: number of surface triangles (Solidity)").ignored(),
        integer("NELEM", 0, "number of surface triangles"),
        integer("NELNO", 0, "nodes of a surface triangle: 3 or 6"),
        integers(
            "I2ELTO",
            &[Extent::Size("NELNO"), Extent::Size("NELEM")],
            "nodes of the triangle, from 0",
        ),
        reals("D1NAP", TRIANGLES, "Pa", "pressure on the triangle, compression positive"),
        reals("D1NBP", TRIANGLES, "Pa", "back pressure (Solidity)")
            .refused("back pressures (Solidity)"),
        integers("I1JTP", TRIANGLES, "jet flag (Solidity)").refused("jets (Solidity)"),
        real("DTHICK", 0.0, "m", "thickness of the shell that couples to the fluid").ignored(),
    ],
);

pub(super) static YDJ: &[Keyword] = &of(
    "YDJ",
    [
        integer("MELEM", 0, "capacity: number of joints (Solidity)").ignored(),
        integer("MELNO", 0, "numbers per joint (7)").ignored(),
        integer("NELNO", 0, "nodes of a joint (6)").ignored(),
        real("DEFECT", 0.0, "-", "fraction of weakened joints")
            .refused("weakened joints (Solidity)"),
        real("DRAN", 0.0, "-", "seed of the random numbers").ignored(),
    ],
);

pub(super) static YSP: &[Keyword] = &of(
    "YSP",
    [
        integer("MSPD", 0, "capacity: number of rigid bodies"),
        integer("NSPD", 0, "number of rigid bodies").refused("rigid bodies"),
        reals("D1MASS", BODIES, "kg", "mass").ignored(),
        reals("D2PP", BODY_VECTORS, "m", "centre").ignored(),
        reals("D2PVT", BODY_VECTORS, "m/s", "velocity").ignored(),
        reals("D2PA", BODY_VECTORS, "rad", "angle").ignored(),
        reals("D2PVR", BODY_VECTORS, "rad/s", "angular velocity in principal axes").ignored(),
        reals("D2PRINE", BODY_VECTORS, "kg·m²", "principal inertias").ignored(),
        reals("D2PRINN1", BODY_VECTORS, "-", "first principal axis").ignored(),
        reals("D2PRINN2", BODY_VECTORS, "-", "second principal axis").ignored(),
        reals("D2PRINN3", BODY_VECTORS, "-", "third principal axis").ignored(),
        integers("I1CON", BODIES, "1 free, 0 driven").ignored(),
    ],
);
