//! Random numbers that are the same on every machine and in every version of the program.

use yformat::checksum::Checksum;

/// SplitMix64 (G. L. Steele, D. Lea and C. H. Flood, *Fast splittable pseudorandom number
/// generators*, OOPSLA 2014): integers only, so that nothing depends on the machine.
#[derive(Debug, Clone)]
pub(super) struct Random(u64);

impl Random {
    /// The stream of a seed.
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The stream that a parameter draws from: parameters that are added or taken away leave those
    /// of the others as they are.
    pub fn of(seed: u64, parameter: &str) -> Self {
        Self(Self::new(seed).next() ^ Checksum::of(parameter.as_bytes()))
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A number in [0, 1), a multiple of 2⁻⁵³.
    pub fn unit(&mut self) -> f64 {
        (self.next() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A number below `count`, all of them alike.
    fn below(&mut self, count: u64) -> u64 {
        // what does not fill a whole turn is drawn again
        let rest = (u64::MAX % count + 1) % count;
        loop {
            let drawn = self.next();
            if drawn <= u64::MAX - rest {
                return drawn % count;
            }
        }
    }

    /// The numbers 0 to `count` − 1 in an order that is as likely as any other (R. A. Fisher and
    /// F. Yates; R. Durstenfeld).
    pub fn order(&mut self, count: usize) -> Vec<usize> {
        let mut order: Vec<usize> = (0..count).collect();
        for last in (1..count).rev() {
            let other = self.below(last as u64 + 1) as usize;
            order.swap(last, other);
        }
        order
    }
}

#[cfg(test)]
mod tests {
    use super::Random;

    /// The published sequence of the seed 1234567.
    #[test]
    fn the_sequence_is_that_of_the_paper() {
        let mut random = Random::new(1_234_567);
        let drawn: Vec<u64> = (0..5).map(|_| random.next()).collect();
        assert_eq!(
            drawn,
            [
                6_457_827_717_110_365_317,
                3_203_168_211_198_807_973,
                9_817_491_932_198_370_423,
                4_593_380_528_125_082_431,
                16_408_922_859_458_223_821
            ]
        );
    }

    #[test]
    fn orders_are_permutations_and_alike() {
        let mut random = Random::of(1, "young");
        let mut firsts = [0; 4];
        for _ in 0..4000 {
            let order = random.order(4);
            let mut sorted = order.clone();
            sorted.sort_unstable();
            assert_eq!(sorted, [0, 1, 2, 3]);
            firsts[order[0]] += 1;
        }
        // 1000 each, with a standard deviation of 27
        assert!(firsts.iter().all(|count| (890..1110).contains(count)), "{firsts:?}");
        assert!((0..1000).all(|_| (0.0..1.0).contains(&random.unit())));
    }

    #[test]
    fn streams_of_parameters_differ() {
        let draw = |name| Random::of(7, name).unit();
        assert_ne!(draw("young").to_bits(), draw("friction").to_bits());
        assert_eq!(draw("young").to_bits(), draw("young").to_bits());
    }
}
