//! Ypsilon
