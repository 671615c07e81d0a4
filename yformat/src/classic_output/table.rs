//! Rows of equal length.

/// Numbers in rows of equal length: one row per element.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Table<T> {
    columns: usize,
    values: Vec<T>,
}

impl<T: Copy> Table<T> {
    /// Rows of `columns` numbers, one after the other; a last row that is not whole is left out.
    #[must_use]
    pub fn new(columns: usize, mut values: Vec<T>) -> Self {
        let whole = values.len().checked_div(columns).unwrap_or(0) * columns;
        values.truncate(whole);
        Self { columns, values }
    }

    /// Numbers per row.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// How many rows there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.values.len().checked_div(self.columns).unwrap_or(0)
    }

    /// Whether there are no rows.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// The rows.
    pub fn rows(&self) -> impl Iterator<Item = &[T]> {
        self.values.chunks_exact(self.columns.max(1))
    }

    /// One row.
    #[must_use]
    pub fn row(&self, index: usize) -> Option<&[T]> {
        let start = index.checked_mul(self.columns)?;
        self.values.get(start..start.checked_add(self.columns)?).filter(|row| !row.is_empty())
    }
}
