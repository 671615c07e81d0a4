//! yformat
