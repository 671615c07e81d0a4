//! From the file of a study to the study: everything is checked, and what is wrong is told with its
//! line.

use super::{
    base::{Base, BaseError, Setting},
    cell::Cell,
    outputs::Output,
    sampling::{MOST_CASES, Mismatch, Sampling},
    study::{Case, FlagCheck, Parameter, RunPlan, Study, StudyError},
    study_file::{OutputTable, ParameterTable, Range, RunTable, SamplingTable, Spacing, StudyFile},
    values::Values,
};
use std::{ops::Range as Bytes, path::Path};
use yformat::{
    diagnostic::Diagnostic,
    dialect::Dialect,
    source::{SourceId, SourceMap},
};

/// Steps between two checkpoints of a case, if the study does not say so.
const CHECKPOINT_EVERY: u64 = 20_000;

/// Flags that a sweep gives to its runs itself.
const OWN_FLAGS: [&str; 8] = [
    "--out",
    "--formats",
    "--threads",
    "--checkpoint",
    "--checkpoint-every",
    "--resume",
    "--quiet",
    "-q",
];

impl Study {
    /// Reads a study with its base. Paths in it are relative to its folder. `flags` knows what
    /// `ypsilon run` takes, and tells the dialect that they force.
    ///
    /// # Errors
    /// If it cannot be read, or with the first thing that makes no sense and its line.
    pub fn read(
        path: &Path,
        folder: Option<&Path>,
        flags: FlagCheck<'_>,
    ) -> Result<Self, StudyError> {
        let io = |source| StudyError::Io { path: path.to_path_buf(), source };
        let text = std::fs::read_to_string(path).map_err(io)?;
        let mut sources = SourceMap::new();
        let id = sources.add(path.display().to_string(), text.clone().into_bytes());
        let reader = Reader { sources, id };
        let file: StudyFile = toml::from_str(&text).map_err(|error| {
            let mut found = Diagnostic::error("study::file", error.message());
            if error.message().contains("missing field `base`") {
                found = found.help("name the deck or scenario that is varied: base = \"wall.y\"");
            }
            reader.finding(found, error.span().unwrap_or(0..0))
        })?;
        reader.study(file, path, folder, flags)
    }
}

/// Turns the file into a study; knows where everything stands.
struct Reader {
    sources: SourceMap,
    id: SourceId,
}

impl Reader {
    fn finding(&self, finding: Diagnostic, place: Bytes<usize>) -> StudyError {
        let finding = finding.at(self.sources.span(self.id, place)).located(&self.sources);
        StudyError::Finding { sources: Box::new(self.sources.clone()), finding: Box::new(finding) }
    }

    fn error(
        &self,
        code: &'static str,
        message: impl Into<String>,
        place: Bytes<usize>,
    ) -> StudyError {
        self.finding(Diagnostic::error(code, message), place)
    }

    fn study(
        &self,
        file: StudyFile,
        path: &Path,
        folder: Option<&Path>,
        flags: FlagCheck<'_>,
    ) -> Result<Study, StudyError> {
        let home = path.parent().unwrap_or(Path::new(""));
        let folder = match (folder, &file.folder) {
            (Some(given), _) => given.to_path_buf(),
            (None, Some(own)) => home.join(own),
            (None, None) => home.join(path.file_stem().unwrap_or_default()),
        };
        if folder == path {
            let message = "a study without an ending needs `folder`, or --out: its results cannot \
                           have its own name";
            return Err(self.error("study::folder", message, 0..0));
        }
        let run = file.run.as_ref().map(|run| (run.get_ref(), run.span()));
        let (plan, dialect) = self.plan(run, file.table.as_deref(), flags)?;
        let base = Base::read(&home.join(file.base.get_ref()), dialect).map_err(|e| match e {
            BaseError::Words(words) => self.error("study::base", words, file.base.span()),
            BaseError::Deck(sources, findings) => StudyError::Deck { sources, findings },
        })?;
        if file.parameters.is_empty() {
            let message = "there are no parameters: nothing is varied";
            let help = "write [parameters.NAME] with `target` and, for instance, `values`";
            return Err(
                self.finding(Diagnostic::error("study::parameter", message).help(help), 0..0)
            );
        }
        // in the order of the file
        let mut tables: Vec<_> = file.parameters.iter().collect();
        tables.sort_by_key(|(name, _)| name.span().start);
        let mut parameters = Vec::new();
        let mut values = Vec::new();
        for (name, table) in &tables {
            let name_place = name.span();
            if name.get_ref() == "case" || name.get_ref() == "status" {
                let message = format!("`{}` is a column of every table already", name.get_ref());
                return Err(self.error("study::parameter", message, name_place));
            }
            let (parameter, own) = self.parameter(name.get_ref(), table, name_place, &base)?;
            parameters.push(parameter);
            values.push(own);
        }
        let mut outputs = Vec::new();
        let mut found: Vec<_> = file.outputs.iter().collect();
        found.sort_by_key(|(name, _)| name.span().start);
        for (name, table) in found {
            outputs.push(self.output(name.get_ref(), table, name.span(), &parameters, &base)?);
        }
        let named: Vec<(&str, &Values)> =
            parameters.iter().zip(&values).map(|(p, v)| (p.name.as_str(), v)).collect();
        let places: Vec<Bytes<usize>> = tables.iter().map(|(name, _)| name.span()).collect();
        let mut cases = self.cases(file.sampling.as_ref(), &named, &places)?;
        // what is rounded is a value as all others; of a factor the product is rounded
        for (parameter, cell) in
            cases.iter_mut().flat_map(|case| parameters.iter().zip(&mut case.values))
        {
            if let (true, Cell::Number(value)) =
                (parameter.is_rounded && !parameter.is_factor, cell)
            {
                *value = value.round();
            }
        }
        let study = Study {
            file: path.to_path_buf(),
            folder,
            title: file.title,
            base,
            parameters,
            cases,
            outputs,
            plan,
        };
        self.check_values(&study, &values, &places)?;
        Ok(study)
    }

    fn plan(
        &self,
        run: Option<(&RunTable, Bytes<usize>)>,
        table: Option<&[toml::Spanned<String>]>,
        flags: FlagCheck<'_>,
    ) -> Result<(RunPlan, Option<Dialect>), StudyError> {
        let mut plan =
            RunPlan { keeps: true, checkpoint_every: CHECKPOINT_EVERY, ..RunPlan::default() };
        for word in table.unwrap_or_default() {
            match word.get_ref().as_str() {
                "csv" => {}
                "parquet" => plan.parquet = true,
                other => {
                    let message = format!("there is no table `{other}`");
                    let finding = Diagnostic::error("study::table", message)
                        .expected("csv (always written) or parquet");
                    return Err(self.finding(finding, word.span()));
                }
            }
        }
        let Some((run, place)) = run else { return Ok((plan, None)) };
        plan.formats = run.formats.clone();
        plan.threads = run.threads;
        plan.keeps = run.keep;
        plan.checkpoint_every = run.checkpoint_every.unwrap_or(CHECKPOINT_EVERY);
        if run.threads == Some(0) || run.checkpoint_every == Some(0) {
            let message = "`threads` and `checkpoint_every` of [run] are 1 or more";
            return Err(self.error("study::run", message, place));
        }
        let Some(given) = &run.flags else { return Ok((plan, None)) };
        plan.flags = given.get_ref().clone();
        let is_own =
            |flag: &&String| OWN_FLAGS.contains(&flag.split('=').next().unwrap_or_default());
        if let Some(flag) = plan.flags.iter().find(is_own) {
            let message = format!("{flag} is given to every case by the sweep itself");
            let help =
                "leave it out; `threads`, `formats` and `checkpoint_every` are keys of [run]";
            let finding = Diagnostic::error("study::run", message).help(help);
            return Err(self.finding(finding, given.span()));
        }
        let dialect = flags(&plan.flags).map_err(|words| {
            let finding = Diagnostic::error("study::run", words)
                .help("`ypsilon run --help` tells the flags of a run");
            self.finding(finding, given.span())
        })?;
        Ok((plan, dialect))
    }

    fn parameter(
        &self,
        name: &str,
        table: &ParameterTable,
        place: Bytes<usize>,
        base: &Base,
    ) -> Result<(Parameter, Values), StudyError> {
        let target_place = table.target.span();
        let mut targets = Vec::new();
        for words in table.target.get_ref().words() {
            let found = base.target(words);
            let message = |words| format!("parameter `{name}`: {words}");
            targets.push(found.map_err(|words| {
                self.error("study::target", message(words), target_place.clone())
            })?);
        }
        if targets.is_empty() {
            let message = format!("parameter `{name}` has no target");
            return Err(self.error("study::target", message, target_place));
        }
        let values = self.values(name, table, place)?;
        let unit = table.unit.clone().or_else(|| {
            let first = base.unit(targets.first()?)?;
            let is_common = targets.iter().all(|target| base.unit(target) == Some(first));
            (is_common && !table.factor).then(|| first.to_owned())
        });
        let parameter = Parameter {
            name: name.to_owned(),
            unit,
            targets,
            is_factor: table.factor,
            is_rounded: table.round,
        };
        Ok((parameter, values))
    }

    fn values(
        &self,
        name: &str,
        table: &ParameterTable,
        place: Bytes<usize>,
    ) -> Result<Values, StudyError> {
        let ParameterTable { values, linspace, logspace, uniform, log_uniform, .. } = table;
        let mut found = Vec::new();
        if let Some(values) = values {
            found.push(self.given(name, values)?);
        }
        for (spacing, is_log) in [(linspace, false), (logspace, true)] {
            if let Some(spacing) = spacing {
                found.push(self.spaced(name, spacing, is_log)?);
            }
        }
        for (range, is_log) in [(uniform, false), (log_uniform, true)] {
            if let Some(range) = range {
                found.push(self.range(name, range, is_log)?);
            }
        }
        let count = found.len();
        match (found.pop(), count) {
            (Some(values), 1) => Ok(values),
            _ => {
                let message = match count {
                    0 => format!("parameter `{name}` has no values"),
                    _ => format!("parameter `{name}` has values of {count} kinds"),
                };
                let finding = Diagnostic::error("study::values", message)
                    .expected("one of values, linspace, logspace, uniform, log_uniform");
                Err(self.finding(finding, place))
            }
        }
    }

    fn given(
        &self,
        name: &str,
        values: &toml::Spanned<Vec<toml::Value>>,
    ) -> Result<Values, StudyError> {
        let cell = |value: &toml::Value| match value {
            toml::Value::Float(number) if number.is_finite() => Some(Cell::Number(*number)),
            toml::Value::Integer(whole) => Some(Cell::Whole(*whole)),
            toml::Value::String(word) => Some(Cell::Word(word.clone())),
            toml::Value::Boolean(truth) => Some(Cell::Truth(*truth)),
            _ => None,
        };
        let cells: Option<Vec<Cell>> = values.get_ref().iter().map(cell).collect();
        match cells {
            Some(cells) if !cells.is_empty() => Ok(Values::Given(cells)),
            _ => {
                let message = format!("the values of parameter `{name}` make no sense");
                let finding = Diagnostic::error("study::values", message)
                    .expected("a list of one or more finite numbers, words, or true and false");
                Err(self.finding(finding, values.span()))
            }
        }
    }

    fn spaced(
        &self,
        name: &str,
        spacing: &toml::Spanned<Spacing>,
        is_log: bool,
    ) -> Result<Values, StudyError> {
        let Spacing { from, to, count } = *spacing.get_ref();
        let ends = self.ends(name, [from, to], is_log, spacing.span())?;
        if !(1..=MOST_CASES).contains(&count) || (count == 1 && from != to) {
            let message =
                format!("parameter `{name}` cannot take {count} values from {from} to {to}");
            let finding = Diagnostic::error("study::values", message)
                .expected("`count` of 2 or more: both ends are among the values");
            return Err(self.finding(finding, spacing.span()));
        }
        Ok(if is_log { Values::logspace(ends, count) } else { Values::linspace(ends, count) })
    }

    fn range(
        &self,
        name: &str,
        range: &toml::Spanned<Range>,
        is_log: bool,
    ) -> Result<Values, StudyError> {
        let ends = self.ends(name, *range.get_ref(), is_log, range.span())?;
        if ends[0] >= ends[1] {
            let message = format!("the range of parameter `{name}` is empty");
            let finding = Diagnostic::error("study::values", message)
                .expected("[LOW, HIGH] with LOW below HIGH");
            return Err(self.finding(finding, range.span()));
        }
        Ok(if is_log { Values::LogUniform(ends) } else { Values::Uniform(ends) })
    }

    fn ends(
        &self,
        name: &str,
        ends: [f64; 2],
        is_log: bool,
        place: Bytes<usize>,
    ) -> Result<[f64; 2], StudyError> {
        if ends.iter().any(|end| !end.is_finite()) {
            let message = format!("the ends of parameter `{name}` have to be finite");
            return Err(self.error("study::values", message, place));
        }
        if is_log && ends.iter().any(|end| *end <= 0.0) {
            let message = format!(
                "parameter `{name}` is spaced by its logarithm, so both ends have to be above 0"
            );
            let finding = Diagnostic::error("study::values", message)
                .help("ends are the values themselves, not powers of ten");
            return Err(self.finding(finding, place));
        }
        Ok(ends)
    }

    fn output(
        &self,
        name: &str,
        table: &toml::Spanned<OutputTable>,
        place: Bytes<usize>,
        parameters: &[Parameter],
        base: &Base,
    ) -> Result<Output, StudyError> {
        let is_taken = parameters.iter().any(|p| p.name == name);
        if is_taken || name == "case" || name == "status" {
            let message = format!("two columns of the table would be called `{name}`");
            return Err(self.error("study::output", message, place));
        }
        let output = Output::of(name, table.get_ref())
            .and_then(|output| output.check(base.dimension()).map(|()| output));
        output.map_err(|words| {
            self.error("study::output", format!("output `{name}`: {words}"), table.span())
        })
    }

    fn cases(
        &self,
        sampling: Option<&toml::Spanned<SamplingTable>>,
        parameters: &[(&str, &Values)],
        places: &[Bytes<usize>],
    ) -> Result<Vec<Case>, StudyError> {
        let place = sampling.map_or(0..0, toml::Spanned::span);
        let table = sampling.map(toml::Spanned::get_ref);
        let method = table.and_then(|t| t.method.as_ref());
        let sampling = match (method.map_or("grid", |m| m.get_ref().as_str()), table) {
            (kind @ ("grid" | "list"), Some(SamplingTable { samples: Some(_), .. }))
            | (kind @ ("grid" | "list"), Some(SamplingTable { seed: Some(_), .. })) => {
                let message = format!("`samples` and `seed` mean nothing for a {kind}");
                let finding = Diagnostic::error("study::sampling", message)
                    .help("write method = \"latin-hypercube\", or leave them out");
                return Err(self.finding(finding, place));
            }
            ("grid", _) => Sampling::Grid,
            ("list", _) => Sampling::List,
            ("latin-hypercube", Some(SamplingTable { samples: Some(samples), seed, .. }))
                if *samples > 0 =>
            {
                Sampling::LatinHypercube { samples: *samples, seed: seed.unwrap_or(1) }
            }
            ("latin-hypercube", _) => {
                let message = "a Latin hypercube needs `samples`, 1 or more: the number of cases";
                return Err(self.error("study::sampling", message, place));
            }
            (other, _) => {
                let message = format!("there is no method `{other}`");
                let finding = Diagnostic::error("study::sampling", message).expected(
                    "grid (every value with every other), list (rows) or latin-hypercube",
                );
                return Err(self.finding(finding, method.map_or(place, toml::Spanned::span)));
            }
        };
        let name = |index: usize| parameters.get(index).map_or("", |(name, _)| *name);
        let at = |index: usize| places.get(index).cloned().unwrap_or(0..0);
        let rows = sampling.cases(parameters).map_err(|mismatch| match mismatch {
            Mismatch::Range(index) => {
                let message = format!("parameter `{}` has a range, not values", name(index));
                let finding = Diagnostic::error("study::sampling", message).help(
                    "give it values, linspace or logspace, or write method = \"latin-hypercube\" \
                     into [sampling]",
                );
                self.finding(finding, at(index))
            }
            Mismatch::Length(index) => {
                let count = |index: usize| match parameters.get(index) {
                    Some((_, Values::Given(cells))) => cells.len(),
                    _ => 0,
                };
                let message = format!(
                    "parameter `{}` has {} values, `{}` has {}: the rows of a list need one of each",
                    name(index),
                    count(index),
                    name(0),
                    count(0)
                );
                self.error("study::sampling", message, at(index))
            }
            Mismatch::TooMany => {
                let message = format!("the study has more than {MOST_CASES} cases");
                let finding = Diagnostic::error("study::sampling", message)
                    .help("take fewer values, or a Latin hypercube");
                self.finding(finding, place.clone())
            }
        })?;
        let numbered = rows.into_iter().enumerate();
        Ok(numbered.map(|(index, values)| Case { number: index + 1, values }).collect())
    }

    /// Every value must fit its place by itself; what values mean together is for the runs to say.
    fn check_values(
        &self,
        study: &Study,
        values: &[Values],
        places: &[Bytes<usize>],
    ) -> Result<(), StudyError> {
        for ((index, parameter), values) in study.parameters.iter().enumerate().zip(values) {
            let own: Vec<Cell> = match values {
                Values::Given(cells) => cells.clone(),
                _ => study.cases.iter().filter_map(|c| c.values.get(index).cloned()).collect(),
            };
            for cell in &own {
                let setting = |target| Setting {
                    target,
                    cell,
                    is_factor: parameter.is_factor,
                    is_rounded: parameter.is_rounded,
                };
                let settings: Vec<Setting<'_>> = parameter.targets.iter().map(setting).collect();
                study.base.describe(&settings).map_err(|words| {
                    let place = places.get(index).cloned().unwrap_or(0..0);
                    let message = format!("parameter `{}`: {words}", parameter.name);
                    let mut finding = Diagnostic::error("study::values", message);
                    if parameter.targets.iter().any(|target| study.base.is_whole(target)) {
                        finding = finding.help("round = true rounds the values to whole numbers");
                    }
                    self.finding(finding, place)
                })?;
            }
        }
        Ok(())
    }
}
