//! The tables of a dialect and the search in them.

use super::{Keyword, classic, split, y3d, ygeo};
use crate::dialect::Dialect;

/// The keywords of one database in the order in which the original compares them.
///
/// ```
/// use yformat::dialect::Dialect;
/// use yformat::keywords::table;
///
/// let table = table(Dialect::Split, "YDC").unwrap();
/// assert_eq!((table.reader, table.exit_status), ("Yrdc", 103));
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Table {
    /// Name such as `YDC`.
    pub database: &'static str,
    /// Name of the original's reader, which begins its messages.
    pub reader: &'static str,
    /// Exit status of the original after an unknown keyword of this database.
    pub exit_status: u8,
    /// The keywords.
    pub keywords: &'static [Keyword],
}

impl Table {
    /// The keyword that the original takes for a name: the first one whose compared characters
    /// begin it.
    #[must_use]
    pub fn match_name(&self, name: &[u8]) -> Option<&'static Keyword> {
        self.keywords.iter().find(|keyword| {
            let compared = keyword.name.len().min(keyword.match_length);
            name.starts_with(&keyword.name.as_bytes()[..compared])
        })
    }
}

/// All tables of a dialect.
#[must_use]
pub fn tables(dialect: Dialect) -> &'static [Table] {
    match dialect {
        Dialect::Split => split::TABLES,
        Dialect::Classic => classic::TABLES,
        Dialect::YGeo => ygeo::TABLES,
        Dialect::Y3d => y3d::TABLES,
    }
}

/// The table of one database.
#[must_use]
pub fn table(dialect: Dialect, database: &str) -> Option<&'static Table> {
    tables(dialect).iter().find(|table| table.database == database)
}

/// The keyword with exactly this name, written `YDC/MCSTEP`.
#[must_use]
pub fn find(dialect: Dialect, name: &str) -> Option<&'static Keyword> {
    let (database, name) = name.split_once('/')?;
    table(dialect, database)?.keywords.iter().find(|keyword| keyword.name == name)
}

/// Splits a deck word into the table of its database and the name behind it, then matches the name
/// as the original does. `None`: no such database; `Some((table, None))`: no such keyword in it.
///
/// ```
/// use yformat::dialect::Dialect;
/// use yformat::keywords::match_word;
///
/// let (_, keyword) = match_word(Dialect::Split, b"/YD/YDC/MCSTEPXYZ").unwrap();
/// assert_eq!(keyword.unwrap().name, "MCSTEP");
/// ```
#[must_use]
pub fn match_word(
    dialect: Dialect,
    word: &[u8],
) -> Option<(&'static Table, Option<&'static Keyword>)> {
    let rest = word.strip_prefix(b"/YD/")?;
    let slash = rest.iter().position(|&b| b == b'/')?;
    let (database, name) = (&rest[..slash], &rest[slash + 1..]);
    let table = tables(dialect).iter().find(|table| table.database.as_bytes() == database)?;
    Some((table, table.match_name(name)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_keyword_is_reached_by_its_own_name() {
        for dialect in Dialect::ALL {
            for table in tables(dialect) {
                for keyword in table.keywords {
                    let found = table.match_name(keyword.name.as_bytes());
                    assert_eq!(
                        found.map(|k| k.name),
                        Some(keyword.name),
                        "{dialect} {}",
                        table.database
                    );
                    assert_eq!(keyword.database, table.database);
                    assert!(!keyword.meaning.is_empty(), "{dialect} {}", keyword.path());
                }
            }
        }
    }

    #[test]
    fn sizes_and_aliases_name_integer_scalars_and_keywords_of_the_same_database() {
        for dialect in Dialect::ALL {
            for keyword in tables(dialect).iter().flat_map(|table| table.keywords) {
                let find_here = |name: &str| find(dialect, &format!("{}/{name}", keyword.database));
                for extent in keyword.extents {
                    if let super::super::Extent::Size(size) = extent {
                        let found = find_here(size)
                            .unwrap_or_else(|| panic!("{dialect} {}: {size}", keyword.path()));
                        assert_eq!(found.rank(), 0);
                    }
                }
                let others = keyword
                    .stores_into
                    .into_iter()
                    .chain(keyword.created.map(|created| created.by));
                others.for_each(|name| {
                    assert!(find_here(name).is_some(), "{dialect} {}: {name}", keyword.path())
                });
            }
        }
    }
}
