//! Writing a deck: values with names, and what the dialects have in common.

use yformat::deck::{Deck, DeckBuilder};
use yformat::dialect::Dialect;

use super::DialectError;
use super::model::{Model, Node};

/// A deck being written. What is not finite cannot be in a deck: it is remembered and refused at
/// the end.
#[derive(Debug)]
pub(super) struct Writer {
    dialect: Dialect,
    builder: DeckBuilder,
    not_finite: Option<String>,
}

impl Writer {
    pub(super) fn new(dialect: Dialect) -> Self {
        Self { dialect, builder: DeckBuilder::new(dialect), not_finite: None }
    }

    pub(super) fn dialect(&self) -> Dialect {
        self.dialect
    }

    fn with(&mut self, next: impl FnOnce(DeckBuilder) -> DeckBuilder) {
        let builder = std::mem::replace(&mut self.builder, DeckBuilder::new(self.dialect));
        self.builder = next(builder);
    }

    fn is_finite(&mut self, name: &str, values: &[f64]) -> bool {
        let finite = values.iter().all(|value| value.is_finite());
        if !finite {
            self.not_finite.get_or_insert_with(|| name.to_owned());
        }
        finite
    }

    pub(super) fn integer(&mut self, name: &str, value: i64) {
        self.with(|builder| builder.integer(name, value));
    }

    pub(super) fn count(&mut self, name: &str, value: usize) {
        self.integer(name, i64::try_from(value).unwrap_or(i64::MAX));
    }

    pub(super) fn real(&mut self, name: &str, value: f64) {
        if self.is_finite(name, &[value]) {
            self.with(|builder| builder.real(name, value));
        }
    }

    pub(super) fn integers(&mut self, name: &str, values: Vec<i64>) {
        self.with(|builder| builder.integers(name, values));
    }

    pub(super) fn reals(&mut self, name: &str, values: Vec<f64>) {
        if self.is_finite(name, &values) {
            self.with(|builder| builder.reals(name, values));
        }
    }

    pub(super) fn integers2(&mut self, name: &str, components: usize, values: Vec<i64>) {
        self.with(|builder| builder.integers2(name, components, values));
    }

    pub(super) fn reals2(&mut self, name: &str, components: usize, values: Vec<f64>) {
        if self.is_finite(name, &values) {
            self.with(|builder| builder.reals2(name, components, values));
        }
    }

    pub(super) fn reals3(&mut self, name: &str, counts: [usize; 3], values: Vec<f64>) {
        if self.is_finite(name, &values) {
            self.with(|builder| builder.reals3(name, counts, values));
        }
    }

    pub(super) fn run(mut self) -> Self {
        self.with(DeckBuilder::run);
        self
    }

    /// The deck with comments in front.
    pub(super) fn finish(self, header: &[String]) -> Result<Deck, DialectError> {
        if let Some(name) = self.not_finite {
            return Err(DialectError::NotFinite(name));
        }
        let body = self.builder.stop().build();
        let mut builder = DeckBuilder::new(self.dialect);
        for comment in header {
            builder = builder.comment(comment);
        }
        for item in body.items() {
            builder = builder.item(item.kind().clone());
        }
        Ok(builder.build())
    }
}

/// The databases YDC, YDE, YDI and YDN as far as they are alike.
pub(super) fn common(model: &Model, writer: &mut Writer) {
    let control = &model.control;
    writer.integer("YDC/MCSTEP", control.last_step);
    writer.integer("YDC/NCSTEP", control.first_step);
    writer.real("YDC/DCGRAY", control.gravity);
    let scales = ["YDC/DCSIZC", "YDC/DCSIZF", "YDC/DCSIZS", "YDC/DCSIZV"];
    for (name, scale) in scales.into_iter().zip(control.scales) {
        if scale.is_some() || writer.dialect() == Dialect::Classic {
            writer.real(name, scale.unwrap_or(1.0));
        }
    }
    writer.real("YDC/DCSTEC", control.time_step);
    writer.real("YDC/DCTIME", control.start);
    writer.integer("YDC/ICOUTF", control.output_interval);
    writer.integer("YDC/ICOUTI", control.output_number);
    writer.integer("YDC/ICOUTP", control.output_digits);
    elements(model, writer);
    interaction(model, writer);
    nodes(model, writer);
}

fn elements(model: &Model, writer: &mut Writer) {
    writer.integer("YDE/MELEM", model.element_room);
    writer.count("YDE/NELEM", model.triangles.len());
    writer.integer("YDE/MELST", model.state_rows.max(2));
    writer.integer("YDE/NELST", 2);
    writer.integer("YDE/MELNO", 4);
    writer.integer("YDE/NELNO", 3);
    writer.reals2("YDE/D2ELST", 2, Vec::new());
    writer.integers("YDE/I1ELCF", Vec::new());
    let sets = model.triangles.iter().map(|triangle| triangle.set as i64).collect();
    writer.integers("YDE/I1ELPR", sets);
    writer.integers2("YDE/I2ELTO", 3, model.triangles.iter().flat_map(|t| t.nodes).collect());
}

fn interaction(model: &Model, writer: &mut Writer) {
    writer.integer("YDI/MICOUP", model.contact.couples);
    writer.integer("YDI/NICOUP", 0);
    if writer.dialect() != Dialect::Classic {
        writer.integer("YDI/MISTATE", 6);
    }
    writer.integer("YDI/IIECFF", -2);
    writer.real("YDI/DIEDI", model.contact.travelled);
    writer.real("YDI/DIEZON", model.contact.buffer);
    writer.reals("YDI/D1IESL", Vec::new());
    writer.integers("YDI/I1IECN", Vec::new());
    writer.integers("YDI/I1IECT", Vec::new());
}

fn nodes(model: &Model, writer: &mut Writer) {
    let vectors = |of: fn(&Node) -> [f64; 2]| model.nodes.iter().flat_map(of).collect::<Vec<_>>();
    writer.integer("YDN/MNODIM", if writer.dialect() == Dialect::Classic { 3 } else { 2 });
    writer.integer("YDN/NNODIM", 2);
    writer.integer("YDN/MNOPO", model.node_room);
    writer.count("YDN/NNOPO", model.nodes.len());
    writer.reals2("YDN/D2NCC", 2, vectors(|node| node.current));
    writer.reals2("YDN/D2NCI", 2, vectors(|node| node.initial));
    writer.reals2("YDN/D2NFC", 2, Vec::new());
    writer.reals("YDN/D1NMCT", Vec::new());
    writer.reals2("YDN/D2NVC", 2, vectors(|node| node.velocity));
    let flags = model.nodes.iter().map(|node| i64::from(node.flagged)).collect();
    writer.integers("YDN/I1NOBF", flags);
}
