//! One case: its folder, its files, its run in a process of its own.

use super::{
    child::{LOG, exit_code, flags_of_a_resumed_run, wait, why},
    error::{SweepError, at},
    evaluate::evaluate,
    record::{Record, State},
    study::{Case, Study},
};
use crate::output::OutputNames;
use std::{
    fs::{self, File},
    io::Write,
    path::{Path, PathBuf},
    process::{Command, ExitStatus, Stdio},
};
use yformat::{checksum::Checksum, part_file::PartFile};
use ypsilon_post::table::number;

/// How cases are run here.
#[derive(Debug, Clone)]
pub struct Runner {
    /// The program: Ypsilon itself.
    pub program: PathBuf,
    /// Threads of each case.
    pub threads: usize,
    /// Whether cases that failed are run again.
    pub retries: bool,
    /// Whether cases with other inputs than those in their folder are run anew.
    pub updates: bool,
}

/// Where a case stands before it is run.
enum Standing {
    /// Nothing is there.
    New,
    /// It is over.
    Over(Record),
    /// It has begun, with these inputs.
    Begun,
    /// Others have begun in its folder.
    Other,
}

impl Study {
    /// Folder of a case.
    #[must_use]
    pub fn case_folder(&self, case: &Case) -> PathBuf {
        self.folder.join(folder_name(case.number))
    }

    /// The record of a case with its present inputs, if it has one.
    #[must_use]
    pub fn record(&self, case: &Case) -> Option<Record> {
        let record = Record::read(&self.case_folder(case))?;
        self.print(case).is_ok_and(|inputs| record.inputs == inputs).then_some(record)
    }

    /// Writes the input files of a case that has not begun.
    ///
    /// # Errors
    /// If they cannot be written, or the folder holds something else.
    pub fn prepare(&self, case: &Case, updates: bool) -> Result<(), SweepError> {
        match self.standing(case, updates)? {
            Standing::Over(_) | Standing::Begun => Ok(()),
            Standing::New | Standing::Other => self.begin(case).map(drop),
        }
    }

    /// Runs a case, or goes on with it; one that is over is left alone. `wants_stop` is asked now
    /// and then: the run then ends in a state that can be gone on from.
    ///
    /// # Errors
    /// If files cannot be written or the folder holds something else. A run that fails is no
    /// error: the record tells.
    pub fn run_case(
        &self,
        case: &Case,
        runner: &Runner,
        wants_stop: &dyn Fn() -> bool,
    ) -> Result<Record, SweepError> {
        let folder = self.case_folder(case);
        let standing = match self.standing(case, runner.updates)? {
            Standing::Over(record) => Standing::Over(self.with_outputs(case, record)?),
            other => other,
        };
        let resumes = match standing {
            Standing::Over(record) if !(record.has_failed() && runner.retries) => {
                return Ok(record);
            }
            Standing::Begun => self.can_go_on() && self.names(&folder).checkpoint().exists(),
            Standing::Over(_) | Standing::New | Standing::Other => false,
        };
        let mut record = match resumes {
            true => self.blank(case),
            false => match self.begin(case)? {
                Ok(record) => record,
                Err(record) => return Ok(record),
            },
        };
        record.state = State::Running;
        record.write(&folder)?;
        let mut status = self.run(&folder, runner, resumes, wants_stop)?;
        if resumes && exit_code(status) == 1 && !wants_stop() {
            // the checkpoint is of no use, by another version for instance
            self.begin(case)?.ok();
            status = self.run(&folder, runner, false, wants_stop)?;
        }
        record.status = exit_code(status);
        record.state = match record.status {
            130 => State::Interrupted,
            _ => State::Ended,
        };
        if record.has_failed() {
            record.message = why(&folder, record.status);
        }
        if record.is_done() {
            self.take_outputs(&mut record, &folder);
        }
        if record.state == State::Ended {
            self.tidy(&folder)?;
        }
        record.write(&folder)?;
        Ok(record)
    }

    /// The record of a case that is over, with the outputs that are asked for now.
    ///
    /// # Errors
    /// If the record cannot be written.
    pub fn with_outputs(&self, case: &Case, mut record: Record) -> Result<Record, SweepError> {
        let is_failed_run = record.has_failed() && record.asked.is_empty();
        if record.state != State::Ended || is_failed_run || record.asked == self.asked() {
            return Ok(record);
        }
        if !self.plan.keeps {
            // said, not written: the outputs that were asked for before are still known
            record.status = 1;
            record.message =
                "the outputs have changed, and results were not kept (`keep = false`): \
                              run the case again with --retry"
                    .to_owned();
            return Ok(record);
        }
        let folder = self.case_folder(case);
        (record.status, record.message) = (0, String::new());
        self.take_outputs(&mut record, &folder);
        record.write(&folder)?;
        Ok(record)
    }

    fn take_outputs(&self, record: &mut Record, folder: &Path) {
        record.asked = self.asked();
        match evaluate(&self.outputs, &self.deck_name(), folder) {
            Ok(values) => record.outputs = values.into_iter().map(number).collect(),
            Err(message) => {
                (record.status, record.message) = (1, message);
                record.outputs.clear();
            }
        }
    }

    /// What tells the outputs of this study from others.
    fn asked(&self) -> String {
        format!("{:016x}", Checksum::of(format!("{:?}", self.outputs).as_bytes()))
    }

    fn standing(&self, case: &Case, updates: bool) -> Result<Standing, SweepError> {
        let folder = self.case_folder(case);
        let Some(record) = Record::read(&folder) else {
            let holds_something = fs::read_dir(&folder).is_ok_and(|mut all| all.next().is_some());
            return if holds_something {
                Err(SweepError::Foreign(folder))
            } else {
                Ok(Standing::New)
            };
        };
        if self.print(case).is_ok_and(|inputs| inputs != record.inputs) {
            if updates {
                return Ok(Standing::Other);
            }
            return Err(SweepError::Changed(format!(
                "case {} was run with other inputs ({}; now {}): run it anew with --update, or \
                 take another folder with --out",
                case.number,
                record.values,
                self.words(case)
            )));
        }
        Ok(match record.state {
            State::Ended if record.is_to_blame_on_the_machine() => Standing::Begun,
            State::Ended => Standing::Over(record),
            State::Ready => Standing::New,
            State::Running | State::Interrupted => Standing::Begun,
        })
    }

    fn blank(&self, case: &Case) -> Record {
        Record {
            case: case.number,
            version: env!("CARGO_PKG_VERSION").to_owned(),
            values: self.words(case),
            inputs: self.print(case).unwrap_or_default(),
            state: State::Ready,
            status: 0,
            message: String::new(),
            asked: String::new(),
            outputs: Vec::new(),
        }
    }

    /// Empties the folder of a case and writes its input files. The inner error is the record of a
    /// case whose files cannot be made.
    fn begin(&self, case: &Case) -> Result<Result<Record, Record>, SweepError> {
        let folder = self.case_folder(case);
        if folder.exists() {
            fs::remove_dir_all(&folder).map_err(at(&folder))?;
        }
        fs::create_dir_all(&folder).map_err(at(&folder))?;
        let mut record = self.blank(case);
        record.write(&folder)?;
        let files = match self.base.files(&self.settings(case)) {
            Ok(files) => files,
            Err(message) => {
                (record.state, record.status, record.message) = (State::Ended, 1, message);
                record.write(&folder)?;
                return Ok(Err(record));
            }
        };
        for (name, bytes) in files {
            let path = folder.join(name);
            if let Some(parent) = path.parent() {
                fs::create_dir_all(parent).map_err(at(parent))?;
            }
            let write = || {
                let mut file = PartFile::create(&path)?;
                file.write_all(&bytes)?;
                file.complete()
            };
            write().map_err(at(&path))?;
        }
        Ok(Ok(record))
    }

    /// The name that results are called after.
    fn deck_name(&self) -> PathBuf {
        let name = PathBuf::from(self.base.path().file_name().unwrap_or_default());
        if name.extension().is_some_and(|e| e == "toml") { name.with_extension("y") } else { name }
    }

    fn names(&self, folder: &Path) -> OutputNames {
        OutputNames::new(&self.deck_name(), folder)
    }

    /// Whether runs write checkpoints: tables that are written line by line know none.
    fn can_go_on(&self) -> bool {
        let writes_tables =
            |flag: &String| flag.starts_with("--monitor") || flag.starts_with("--energy");
        self.plan.checkpoint_every > 0
            && !self.base.has_monitors()
            && !self.plan.flags.iter().any(writes_tables)
    }

    fn run(
        &self,
        folder: &Path,
        runner: &Runner,
        resumes: bool,
        wants_stop: &dyn Fn() -> bool,
    ) -> Result<ExitStatus, SweepError> {
        let path = folder.join(LOG);
        let log = File::options().create(true).append(true).open(&path).map_err(at(&path))?;
        let again = log.try_clone().map_err(at(&path))?;
        let mut command = Command::new(&runner.program);
        command
            .current_dir(folder)
            .arg("run")
            .arg(self.base.path().file_name().unwrap_or_default());
        command.args(["--out", ".", "--quiet", "--stop-at-eof", "--threads"]);
        command.arg(runner.threads.to_string());
        if self.can_go_on() {
            command.arg("--checkpoint-every").arg(self.plan.checkpoint_every.to_string());
        }
        if resumes {
            command.arg("--resume").args(flags_of_a_resumed_run(&self.plan.flags));
        } else {
            command.arg("--formats").arg(self.formats()).args(&self.plan.flags);
        }
        command.stdin(Stdio::piped()).stdout(log).stderr(again);
        let child = command.spawn().map_err(at(&runner.program))?;
        wait(child, wants_stop).map_err(at(&runner.program))
    }

    fn formats(&self) -> String {
        let mut formats = self.plan.formats.clone();
        let own = self.outputs.iter().filter_map(super::Output::format);
        let own = own.filter_map(|format| {
            use clap::ValueEnum;
            Some(format.to_possible_value()?.get_name().to_owned())
        });
        for format in own.chain(["json".to_owned()]) {
            if !formats.contains(&format) {
                formats.push(format);
            }
        }
        formats.join(",")
    }

    /// Takes away what a case that is over needs no more.
    fn tidy(&self, folder: &Path) -> Result<(), SweepError> {
        let checkpoint = self.names(folder).checkpoint();
        if checkpoint.exists() {
            fs::remove_file(&checkpoint).map_err(at(&checkpoint))?;
        }
        if self.plan.keeps {
            return Ok(());
        }
        let inputs = self.base.path().file_name().unwrap_or_default().to_owned();
        let deck = self.deck_name();
        for entry in fs::read_dir(folder).map_err(at(folder))?.flatten() {
            let name = entry.file_name();
            let stays =
                name == inputs || name == *deck.as_os_str() || name == LOG || name == "case.json";
            let path = entry.path();
            if !stays && path.is_file() {
                fs::remove_file(&path).map_err(at(&path))?;
            }
        }
        Ok(())
    }
}

/// Name of the folder of a case.
pub(super) fn folder_name(number: usize) -> String {
    format!("case-{number:04}")
}
