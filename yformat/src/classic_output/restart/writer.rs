//! From the model to the text of the original.

use std::io::{self, Write};

use super::rows::Column;
use super::{HistoryState, JointState, PropertySet, RestartDeck};
use crate::c_format::Exponential;
use crate::classic_output::RestartError;
use crate::classic_output::text::{DeckText, E18, E28, Width};

/// What is written as the number of masses.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MassCount {
    /// The number of masses that follow: the original can read such a deck.
    #[default]
    Correct,
    /// 0, as the original writes it: it cannot read its own deck then.
    AsOriginal,
}

/// `+2e+02`: larger than any buffer, so that contact is detected at once.
const TRAVEL: (f64, Exponential) = (200.0, Exponential::new(0).width(5).plus());

const I4: Width = Width(4);
const I5: Width = Width(5);
const I6: Width = Width(6);

impl RestartDeck {
    /// Writes the deck; apart from the count of masses byte for byte as the original does.
    ///
    /// # Errors
    /// [`RestartError::Length`] before anything is written if lists that belong together have
    /// different lengths, [`RestartError::Io`] if `out` cannot be written to.
    pub fn write_to(&self, out: impl Write, masses: MassCount) -> Result<(), RestartError> {
        self.check_lengths()?;
        let mut text = DeckText { out };
        self.control(&mut text)?;
        self.elements(&mut text)?;
        self.joints(&mut text)?;
        self.interactions(&mut text)?;
        self.nodes(&mut text, masses)?;
        self.properties(&mut text)?;
        self.histories(&mut text)?;
        text.out.write_all(b"$YDOIT\n$YSTOP\n")?;
        Ok(())
    }

    fn check_lengths(&self) -> Result<(), RestartError> {
        let (elements, nodes) = (&self.elements, &self.nodes);
        let (count, points) = (elements.kinds.len(), nodes.coordinates.len());
        let per_element = usize::try_from(elements.nodes_per_element).unwrap_or(0);
        for (array, expected, found) in [
            ("I1ELPR", count, elements.properties.len()),
            ("I2ELTO", count, elements.nodes.len()),
            ("D2ELFS", count, elements.shear_strengths.len()),
            ("I2ELJP", count, elements.joints.len()),
            ("I2ELJP, row", per_element, elements.joints.columns()),
            ("D2ELFS, row", elements.nodes.columns(), elements.shear_strengths.columns()),
            ("D2NCI", points, nodes.initial_coordinates.len()),
            ("D2NFC", points, nodes.forces.len()),
            ("D1NMCT", points, nodes.masses.len()),
            ("D2NVC", points, nodes.velocities.len()),
            ("I1NOBF", points, nodes.boundary_flags.len()),
            ("I1NOPR", points, nodes.properties.len()),
        ] {
            let rows_of_nothing = count == 0 && array.ends_with("row");
            if expected != found && !rows_of_nothing {
                return Err(RestartError::Length { array, expected, found });
            }
        }
        Ok(())
    }

    fn control(&self, text: &mut DeckText<impl Write>) -> io::Result<()> {
        let control = &self.control;
        text.section("Control   ")?;
        text.scalar("YDC/MCSTEP", Width(8), control.end_step)?;
        text.scalar("YDC/NCSTEP", Width(8), control.next_step)?;
        for (keyword, value) in [
            ("YDC/DCGRAY", control.gravity),
            ("YDC/DCSIZC", control.scales.coordinate),
            ("YDC/DCSIZF", control.scales.force),
            ("YDC/DCSIZS", control.scales.stress),
            ("YDC/DCSIZV", control.scales.velocity),
            ("YDC/DCSIZD", control.scales.displacement),
            ("YDC/DCSIZA", control.scales.aperture),
            ("YDC/DCSTEC", control.time_step),
            ("YDC/DCTIME", control.time),
            ("YDC/DCGRST", control.settling_time),
            ("YDC/DCRMPT", control.ramp_time),
        ] {
            text.scalar(keyword, E18, value)?;
        }
        for (keyword, value) in [
            ("YDC/ICOUTF", control.output_interval),
            ("YDC/ICOUTI", control.next_snapshot),
            ("YDC/ICSAVF", control.restart_interval),
            ("YDC/ICOUTP", control.digits),
            ("YDC/ICFMTY", control.friction_law),
            ("YDC/ICIATY", control.aperture_law),
        ] {
            text.scalar(keyword, I5, value)?;
        }
        Ok(())
    }

    fn elements(&self, text: &mut DeckText<impl Write>) -> io::Result<()> {
        let elements = &self.elements;
        let count = elements.kinds.len();
        text.section("Elements   ")?;
        for (keyword, value) in [
            ("YDE/MELEM", elements.capacity),
            ("YDE/NELEM", count as i64),
            ("YDE/MELST", elements.state_rows),
            ("YDE/NELST", elements.states),
            ("YDE/MELNO", elements.nodes.columns() as i64),
            ("YDE/NELNO", elements.nodes_per_element),
        ] {
            text.scalar(keyword, I5, value)?;
        }
        text.matrix_header("YDE/D2ELST", count, 0)?;
        text.list("YDE/I1ELCF", I4, elements.kinds.iter().map(|_| -1))?;
        text.list("YDE/I1ELTY", I4, elements.kinds.iter().copied())?;
        text.list("YDE/I1ELPR", I4, elements.properties.iter().copied())?;
        let columns = elements.nodes.columns();
        text.matrix("YDE/I2ELTO", I6, columns, elements.nodes.rows(), count)?;
        text.matrix("YDE/D2ELFS", E28, columns, elements.shear_strengths.rows(), count)?;
        let columns = elements.joints.columns();
        text.matrix("YDE/I2ELJP", I6, columns, elements.joints.rows(), count)
    }

    fn joints(&self, text: &mut DeckText<impl Write>) -> io::Result<()> {
        text.section("Joints   ")?;
        text.scalar("YDJ/NJOINT", I5, self.joints.len() as i64)?;
        columns(text, I4, &self.joints, JointState::INTEGERS)?;
        columns(text, E28, &self.joints, JointState::REALS)
    }

    fn interactions(&self, text: &mut DeckText<impl Write>) -> io::Result<()> {
        text.section("Interactions     ")?;
        text.scalar("YDI/MICOUP", Width(18), self.contact.couple_capacity)?;
        text.scalar("YDI/NICOUP", I5, 0)?;
        text.scalar("YDI/IIECFF", I5, -2)?;
        text.scalar("YDI/DIEDI", TRAVEL.1, TRAVEL.0)?;
        text.scalar("YDI/DIEZON", E18, self.contact.buffer)?;
        text.count("YDI/D1IESL", 0)?;
        text.count("YDI/I1IECN", 0)?;
        text.count("YDI/I1IECT", 0)
    }

    fn nodes(&self, text: &mut DeckText<impl Write>, masses: MassCount) -> io::Result<()> {
        let nodes = &self.nodes;
        let count = nodes.coordinates.len();
        text.section("Nodes     ")?;
        for (keyword, value) in [
            ("YDN/MNODIM", nodes.dimension_capacity),
            ("YDN/NNODIM", 2),
            ("YDN/MNOPO", nodes.capacity),
            ("YDN/NNOPO", count as i64),
        ] {
            text.scalar(keyword, I5, value)?;
        }
        let vectors = |text: &mut DeckText<_>, keyword: &str, vectors: &[[f64; 2]]| {
            text.matrix(keyword, E28, 2, vectors.iter().map(<[f64; 2]>::as_slice), count)
        };
        vectors(text, "YDN/D2NCC", &nodes.coordinates)?;
        vectors(text, "YDN/D2NCI", &nodes.initial_coordinates)?;
        vectors(text, "YDN/D2NFC", &nodes.forces)?;
        let announced = if masses == MassCount::AsOriginal { 0 } else { count };
        text.count("YDN/D1NMCT", announced)?;
        text.values(E28, nodes.masses.iter().copied())?;
        vectors(text, "YDN/D2NVC", &nodes.velocities)?;
        text.list("YDN/I1NOBF", I4, nodes.boundary_flags.iter().copied())?;
        text.list("YDN/I1NOPR", I4, nodes.properties.iter().copied())
    }

    fn properties(&self, text: &mut DeckText<impl Write>) -> io::Result<()> {
        text.section("Properties     ")?;
        text.scalar("YDP/MPROP", I5, self.property_capacity)?;
        text.scalar("YDP/NPROP", I5, self.properties.len() as i64)?;
        columns(text, E18, &self.properties, PropertySet::REALS)?;
        columns(text, I5, &self.properties, PropertySet::INTEGERS)
    }

    fn histories(&self, text: &mut DeckText<impl Write>) -> io::Result<()> {
        text.section("Output     ")?;
        text.scalar("YDO/MOHYS", I5, self.history_capacity)?;
        text.scalar("YDO/NOHYS", I5, self.histories.len() as i64)?;
        text.scalar("YDO/DOHYP", E28, self.history_threshold)?;
        columns(text, E28, &self.histories, HistoryState::REALS)?;
        columns(text, I5, &self.histories, HistoryState::INTEGERS)
    }
}

/// One list per column.
fn columns<R, T>(
    text: &mut DeckText<impl Write>,
    format: impl crate::classic_output::text::Format<T> + Copy,
    rows: &[R],
    columns: &[Column<R, T>],
) -> io::Result<()> {
    columns.iter().try_for_each(|column| {
        text.list(column.keyword, format, rows.iter().map(|row| (column.get)(row)))
    })
}
