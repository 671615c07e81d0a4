use serde::{Deserialize, Serialize};

/// What figures were measured on.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Machine {
    /// The processor's name, as far as it is known.
    pub processor: String,
    /// Cores that the program may use.
    pub cores: usize,
    /// Operating system and architecture.
    pub system: String,
    /// Processes that ran or wanted to run before the suite began, in the mean of a minute; `None`
    /// where the system does not tell.
    pub load: Option<f64>,
}

/// Load from which on other programs take part of the machine.
const BUSY: f64 = 0.5;

impl Machine {
    /// The machine that this runs on.
    #[must_use]
    pub fn here() -> Self {
        let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
        let model = text.lines().find_map(|line| line.strip_prefix("model name"));
        let name = model.map(|rest| rest.trim_start_matches([' ', '\t', ':']).trim());
        Self {
            processor: name.unwrap_or("unknown processor").to_owned(),
            cores: std::thread::available_parallelism().map_or(1, usize::from),
            load: std::fs::read_to_string("/proc/loadavg").ok().and_then(|text| first(&text)),
            system: format!("{} {}", std::env::consts::OS, std::env::consts::ARCH),
        }
    }

    /// What is to be said about its being busy with other things.
    #[must_use]
    pub fn caution(&self) -> Option<String> {
        let load = self.load.filter(|&load| load > BUSY)?;
        Some(format!(
            "The machine was busy with other things: {load:.1} processes wanted to run before the suite began"
        ))
    }
}

fn first(text: &str) -> Option<f64> {
    text.split_whitespace().next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn busy_machines_are_told_about() {
        assert_eq!(first("7.71 7.67 5.90 9/250 1234\n"), Some(7.71));
        assert_eq!(first(""), None);
        let machine = |load| Machine { load, ..Machine::here() };
        assert_eq!(machine(Some(0.1)).caution(), None);
        assert_eq!(machine(None).caution(), None);
        let caution = machine(Some(7.71)).caution().expect("a caution");
        assert!(caution.contains("7.7"), "{caution}");
    }
}
