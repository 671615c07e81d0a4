//! Four numbers at a time.
//!
//! Kernels are written once, over [`Lanes`], and compiled twice: for AVX2 and for any machine.
//! [`run`] chooses when the program runs. Nothing is fused or reassociated, so that each lane
//! gets the bits that scalar code would give it: bits depend neither on the machine nor on which
//! elements share a vector.

use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// An array of two, three or four values of an expression in the index `k`, as
/// `each!(3, |k| f(k))`. `array::map` and `array::from_fn` would do the same, but are not always
/// inlined, and lanes are only fast where all is.
macro_rules! each {
    (2, |$k:ident| $value:expr) => {
        each!(@ $k, $value, 0, 1)
    };
    (3, |$k:ident| $value:expr) => {
        each!(@ $k, $value, 0, 1, 2)
    };
    (4, |$k:ident| $value:expr) => {
        each!(@ $k, $value, 0, 1, 2, 3)
    };
    (@ $k:ident, $value:expr, $($index:literal),+) => {
        [$({
            let $k: usize = $index;
            $value
        }),+]
    };
}

pub(crate) use each;

#[cfg(target_arch = "x86_64")]
mod avx2;
mod portable;

/// Number of lanes.
pub const LANES: usize = 4;

/// Four `f64` that are computed with together, as operators on `f64` do it one by one.
pub trait Lanes:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// One truth value per lane.
    type Mask: Mask;

    /// A plane vector.
    type Pair: Pair;

    /// The same number in all lanes.
    fn splat(value: f64) -> Self;

    /// As [`Self::unpair`], in registers.
    fn split(x: Self, y: Self) -> [Self::Pair; LANES];

    /// Square roots.
    fn sqrt(self) -> Self;

    /// Without sign.
    fn abs(self) -> Self;

    /// Lanes in which this number is smaller.
    fn lt(self, other: Self) -> Self::Mask;

    /// Lanes in which this number is smaller or equal.
    fn le(self, other: Self) -> Self::Mask;

    /// Lanes in which this number is larger.
    #[inline(always)]
    fn gt(self, other: Self) -> Self::Mask {
        other.lt(self)
    }

    /// `if other < self { other } else { self }`.
    fn smaller(self, other: Self) -> Self;

    /// `if other > self { other } else { self }`.
    fn larger(self, other: Self) -> Self;

    /// `yes` where the mask is true, `no` elsewhere.
    fn select(mask: Self::Mask, yes: Self, no: Self) -> Self;

    /// From one number per lane.
    fn new(values: [f64; LANES]) -> Self;

    /// Numbers of all lanes.
    fn array(self) -> [f64; LANES];

    /// Four numbers that lie one after the other.
    fn load(values: &[f64; LANES]) -> Self;

    /// Four numbers in single precision that lie one after the other.
    fn widen(values: &[f32; LANES]) -> Self;

    /// Writes the numbers one after the other.
    fn store(self, values: &mut [f64; LANES]);

    /// Components of four plane vectors: all first ones, all second ones.
    fn pairs(pairs: [&[f64; 2]; LANES]) -> [Self; 2];

    /// The transpose: lane `i` of result `k` is lane `k` of `rows[i]`.
    fn transpose(rows: [Self; LANES]) -> [Self; LANES];

    /// The plane vectors of four lanes: the inverse of [`Self::pairs`].
    fn unpair(x: Self, y: Self) -> [[f64; 2]; LANES];
}

/// Truth values of four lanes.
pub trait Mask: Copy + BitAnd<Output = Self> + BitOr<Output = Self> + Not<Output = Self> {
    /// Bit `i` of the result is the truth value of lane `i`.
    fn bits(self) -> u32;

    /// Whether it is true in any lane.
    #[inline(always)]
    fn any(self) -> bool {
        self.bits() != 0
    }

    /// Whether it is true in all lanes.
    #[inline(always)]
    fn all(self) -> bool {
        self.bits() == (1 << LANES) - 1
    }
}

/// A plane vector that sums are made of.
pub trait Pair: Copy + Add<Output = Self> + Sub<Output = Self> {
    /// From memory.
    fn load(components: &[f64; 2]) -> Self;

    /// To memory.
    fn store(self, components: &mut [f64; 2]);
}

/// A computation over lanes of either kind.
pub trait Kernel {
    /// What it gives.
    type Output;

    /// Runs it. Implementations have to be `#[inline(always)]`, like all that they call with
    /// lanes, to be compiled for the instruction set of the lanes.
    fn run<L: Lanes>(self) -> Self::Output;
}

/// Runs a kernel with the widest instruction set of this machine.
#[inline]
pub fn run<K: Kernel>(kernel: K) -> K::Output {
    #[cfg(target_arch = "x86_64")]
    if avx2::is_available() {
        return avx2::run(kernel);
    }
    kernel.run::<portable::Portable>()
}

/// Runs a kernel with code for any machine: what tests hold [`run`] against.
#[inline]
pub fn run_portable<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<portable::Portable>()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All operations on some numbers, as bits.
    struct Everything([[f64; 4]; 2]);

    impl Kernel for Everything {
        type Output = Vec<u64>;

        #[inline(always)]
        fn run<L: Lanes>(self) -> Vec<u64> {
            let [a, b] = self.0.map(L::new);
            let mut bits = Vec::new();
            let results = [
                a + b,
                a - b,
                a * b,
                a / b,
                -a,
                a.abs(),
                a.abs().sqrt(),
                a.smaller(b),
                a.larger(b),
                L::select(a.lt(b), a, b),
                L::select(a.le(b) & !a.gt(b), a, b),
                L::select(a.lt(b) | b.lt(a), a, b),
                L::splat(a.array()[1]),
                L::load(&b.array()),
            ];
            for value in results {
                let mut stored = [0.0; 4];
                value.store(&mut stored);
                assert_eq!(stored.map(f64::to_bits), value.array().map(f64::to_bits));
                bits.extend(stored.map(f64::to_bits));
            }
            let pairs = L::unpair(a, b);
            bits.extend(pairs.iter().flatten().map(|v| v.to_bits()));
            let mut split = L::split(a, b);
            for (split, pair) in split.iter_mut().zip(&pairs) {
                let mut stored = [0.0; 2];
                (*split + Pair::load(pair) - *split).store(&mut stored);
                bits.extend(stored.map(f64::to_bits));
                split.store(&mut stored);
                assert_eq!(stored.map(f64::to_bits), pair.map(f64::to_bits));
            }
            let [x, y] = L::pairs([&pairs[0], &pairs[1], &pairs[2], &pairs[3]]);
            bits.extend(x.array().into_iter().chain(y.array()).map(f64::to_bits));
            let columns = L::transpose([a, b, a, b]);
            bits.extend(columns.iter().flat_map(|c| c.array()).map(f64::to_bits));
            let masks = [a.lt(b), a.le(b), a.gt(b), !a.lt(b)];
            bits.extend(masks.iter().map(|m| u64::from(m.bits())));
            bits.extend(masks.iter().map(|m| u64::from(m.any()) + 2 * u64::from(m.all())));
            bits
        }
    }

    /// Lane by lane with scalar operators.
    fn expected([a, b]: [[f64; 4]; 2]) -> Vec<u64> {
        let mut bits = Vec::new();
        let mut each = |f: &dyn Fn(f64, f64) -> f64| {
            bits.extend((0..4).map(|i| f(a[i], b[i]).to_bits()));
        };
        each(&|a, b| a + b);
        each(&|a, b| a - b);
        each(&|a, b| a * b);
        each(&|a, b| a / b);
        each(&|a, _| -a);
        each(&|a, _| a.abs());
        each(&|a, _| a.abs().sqrt());
        each(&|a, b| if b < a { b } else { a });
        each(&|a, b| if b > a { b } else { a });
        each(&|a, b| if a < b { a } else { b });
        each(&|a, b| if a <= b { a } else { b });
        each(&|a, b| if a < b || b < a { a } else { b });
        each(&|_, _| a[1]);
        each(&|_, b| b);
        bits.extend((0..4).flat_map(|i| [a[i].to_bits(), b[i].to_bits()]));
        bits.extend((0..4).flat_map(|i| [a[i], b[i]].map(|x| (x + x - x).to_bits())));
        bits.extend(a.into_iter().chain(b).map(f64::to_bits));
        bits.extend((0..4).flat_map(|k| [a[k], b[k], a[k], b[k]]).map(f64::to_bits));
        let comparisons: [&dyn Fn(f64, f64) -> bool; 4] =
            [&|a, b| a < b, &|a, b| a <= b, &|a, b| a > b, &|a, b| !f64::lt(&a, &b)];
        let masks = comparisons.map(|f| (0..4).fold(0, |m, i| m | u64::from(f(a[i], b[i])) << i));
        bits.extend(masks);
        bits.extend(masks.map(|m| u64::from(m != 0) + 2 * u64::from(m == 15)));
        bits
    }

    #[test]
    fn lanes_give_the_bits_of_scalar_operators() {
        for numbers in [
            [[1.5, -2.25, 1e300, 3.0], [0.1, -2.25, 1e300, 7.0]],
            [[0.0, -0.0, f64::INFINITY, 1e-310], [-0.0, 0.0, 1.0, 1e-320]],
            [[f64::MIN_POSITIVE, 1.0, 2.0, 3.0], [5.0, 4.0, 3.0, 2.5]],
        ] {
            assert_eq!(run(Everything(numbers)), expected(numbers));
            assert_eq!(run_portable(Everything(numbers)), expected(numbers));
        }
    }

    /// What does not compare is neither smaller nor larger.
    #[test]
    fn no_number_is_smaller_than_one_that_does_not_compare() {
        struct Compare;
        impl Kernel for Compare {
            type Output = [u32; 3];

            #[inline(always)]
            fn run<L: Lanes>(self) -> [u32; 3] {
                let a = L::new([f64::NAN, 1.0, 1.0, 2.0]);
                let b = L::new([1.0, f64::NAN, 2.0, 1.0]);
                let kept = a.smaller(b).array();
                assert!(kept[0].is_nan() && kept[1] == 1.0);
                [a.lt(b).bits(), a.le(b).bits(), a.gt(b).bits()]
            }
        }
        assert_eq!(run(Compare), [0b0100, 0b0100, 0b1000]);
        assert_eq!(run_portable(Compare), [0b0100, 0b0100, 0b1000]);
    }
}
