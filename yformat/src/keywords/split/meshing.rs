//! Database YDPM of the split dialect: refinement and joint insertion.

use super::{Extent, Fixed, Keyword, NegativeTo, integer, integers, of};

pub(super) static YDPM: &[Keyword] = &of(
    "YDPM",
    [
        integer("MPMCOM", 0, "number of records of I2PMSET; 0: nothing is meshed"),
        integer("MPMCOL", 0, "length of a record of I2PMSET"),
        integers(
            "I2PMSET",
            &[Extent::Size("MPMCOL"), Extent::Size("MPMCOM")],
            "records `count code set1 set2 ...`: code digits 1, 2 refine, 3 inserts joints, 4 separates",
        ),
        integer("MPMROW", 0, "number of records of I2PMIJ"),
        integers("I2PMIJ", &[Fixed(3), Extent::Size("MPMROW")], "records `setA setB jointset`"),
        integer("IAUTBN", 1, "mark the free surface nodes of 3D joint meshes (source tree only)")
            .adjusted(NegativeTo(1))
            .only_3d(),
    ],
);
