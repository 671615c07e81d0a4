//! Tables as Parquet files, for pandas, polars, R, DuckDB and the like.

use std::io::{self, BufWriter, Write};
use std::path::Path;
use std::sync::Arc;

use ::parquet::basic::{LogicalType, Repetition, Type as Physical};
use ::parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
use ::parquet::errors::ParquetError;
use ::parquet::file::properties::WriterProperties;
use ::parquet::file::writer::SerializedFileWriter;
use ::parquet::schema::types::Type;
use yformat::part_file::PartFile;

/// A column.
#[derive(Debug, Clone, PartialEq)]
pub enum Column {
    /// Whole numbers.
    Integers(Vec<i64>),
    /// Numbers; NaN where there is none.
    Numbers(Vec<f64>),
    /// Words.
    Words(Vec<String>),
}

/// Writes columns of equal length with their names; the file takes its name when it is complete.
///
/// # Errors
/// If the file cannot be written.
pub fn write(path: &Path, columns: &[(String, Column)]) -> io::Result<()> {
    let file = BufWriter::new(PartFile::create(path)?);
    let mut file = encode(file, columns).map_err(io::Error::other)?;
    file.flush()?;
    file.into_inner().map_err(io::IntoInnerError::into_error)?.complete().map(drop)
}

fn encode<W: Write + Send>(out: W, columns: &[(String, Column)]) -> Result<W, ParquetError> {
    let fields = columns.iter().map(|(name, column)| {
        let (physical, logical) = match column {
            Column::Integers(_) => (Physical::INT64, None),
            Column::Numbers(_) => (Physical::DOUBLE, None),
            Column::Words(_) => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
        };
        let field = Type::primitive_type_builder(name, physical)
            .with_repetition(Repetition::REQUIRED)
            .with_logical_type(logical);
        field.build().map(Arc::new)
    });
    let fields = fields.collect::<Result<_, _>>()?;
    let schema = Type::group_type_builder("table").with_fields(fields).build()?;
    let properties = WriterProperties::builder().set_created_by("ypsilon".to_owned()).build();
    let mut writer = SerializedFileWriter::new(out, Arc::new(schema), Arc::new(properties))?;
    let mut rows = writer.next_row_group()?;
    for (_, column) in columns {
        let Some(mut open) = rows.next_column()? else { break };
        match column {
            Column::Integers(values) => {
                open.typed::<Int64Type>().write_batch(values, None, None)?;
            }
            Column::Numbers(values) => {
                open.typed::<DoubleType>().write_batch(values, None, None)?;
            }
            Column::Words(values) => {
                let words: Vec<ByteArray> =
                    values.iter().map(|word| ByteArray::from(word.as_str())).collect();
                open.typed::<ByteArrayType>().write_batch(&words, None, None)?;
            }
        }
        open.close()?;
    }
    rows.close()?;
    writer.into_inner()
}

#[cfg(test)]
mod tests {
    use super::*;
    use ::parquet::file::reader::{FileReader, SerializedFileReader};
    use ::parquet::record::Field;

    #[test]
    fn what_is_written_is_read_back() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("results.parquet");
        let columns = [
            ("case".to_owned(), Column::Integers(vec![1, 2, -3])),
            ("young (Pa)".to_owned(), Column::Numbers(vec![1.0 / 3.0, f64::NAN, -1e300])),
            ("bond".to_owned(), Column::Words(vec!["läufer".into(), String::new(), "b".into()])),
        ];
        write(&path, &columns).expect("it is written");
        let file = std::fs::File::open(&path).expect("the file");
        let reader = SerializedFileReader::new(file).expect("a Parquet file");
        let rows: Vec<_> =
            reader.get_row_iter(None).expect("rows").map(|row| row.expect("a row")).collect();
        assert_eq!(rows.len(), 3);
        for (number, row) in rows.iter().enumerate() {
            for ((name, column), (found, field)) in columns.iter().zip(row.get_column_iter()) {
                assert_eq!(name, found);
                match (column, field) {
                    (Column::Integers(values), Field::Long(value)) => {
                        assert_eq!(*value, values[number])
                    }
                    (Column::Numbers(values), Field::Double(value)) => {
                        assert_eq!(value.to_bits(), values[number].to_bits());
                    }
                    (Column::Words(values), Field::Str(value)) => {
                        assert_eq!(*value, values[number])
                    }
                    (_, other) => panic!("{name}: {other:?}"),
                }
            }
        }
        assert!(!folder.path().join("results.parquet.part").exists());
    }
}
