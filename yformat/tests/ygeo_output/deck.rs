//! The few values of a deck that the tests need.

use std::collections::HashMap;

/// The words behind each keyword, comments left out.
pub struct Deck(HashMap<String, Vec<String>>);

impl Deck {
    pub fn parse(text: &str) -> Self {
        let mut values: HashMap<String, Vec<String>> = HashMap::new();
        let mut keyword = String::new();
        let mut in_comment = false;
        for word in text.split_whitespace() {
            if in_comment || word.starts_with("/*") {
                in_comment = !word.ends_with("*/");
            } else if let Some(path) = word.strip_prefix("/YD/") {
                keyword = path.to_owned();
                values.insert(keyword.clone(), Vec::new());
            } else {
                values.entry(keyword.clone()).or_default().push(word.to_owned());
            }
        }
        Self(values)
    }

    /// Entry of a list with its count in front.
    pub fn entry(&self, keyword: &str, index: usize) -> f64 {
        self.0[keyword][index + 1].parse().unwrap()
    }

    /// A table `21 2 N` and its rows.
    pub fn table(&self, keyword: &str) -> Vec<[f64; 2]> {
        let numbers: Vec<f64> =
            self.0[keyword].iter().skip(3).map(|word| word.parse().unwrap()).collect();
        numbers.chunks_exact(2).map(|row| [row[0], row[1]]).collect()
    }
}
