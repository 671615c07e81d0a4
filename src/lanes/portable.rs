//! Lanes for any machine, as the compiler makes them of loops.

use super::{LANES, Lanes, Mask, Pair};
use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

/// Four numbers.
#[derive(Debug, Clone, Copy)]
pub(super) struct Portable([f64; LANES]);

/// Four truth values.
#[derive(Debug, Clone, Copy)]
pub(super) struct PortableMask([bool; LANES]);

/// A plane vector.
#[derive(Debug, Clone, Copy)]
pub(super) struct PortablePair([f64; 2]);

impl Add for PortablePair {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self([self.0[0] + other.0[0], self.0[1] + other.0[1]])
    }
}

impl Sub for PortablePair {
    type Output = Self;

    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self([self.0[0] - other.0[0], self.0[1] - other.0[1]])
    }
}

impl Pair for PortablePair {
    #[inline(always)]
    fn load(components: &[f64; 2]) -> Self {
        Self(*components)
    }

    #[inline(always)]
    fn store(self, components: &mut [f64; 2]) {
        *components = self.0;
    }
}

impl Portable {
    #[inline(always)]
    fn each(self, other: Self, f: impl Fn(f64, f64) -> f64) -> Self {
        Self(std::array::from_fn(|i| f(self.0[i], other.0[i])))
    }

    #[inline(always)]
    fn compare(self, other: Self, f: impl Fn(&f64, &f64) -> bool) -> PortableMask {
        PortableMask(std::array::from_fn(|i| f(&self.0[i], &other.0[i])))
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident) => {
        impl $trait for Portable {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                self.each(other, f64::$method)
            }
        }
    };
}

operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);
operator!(Div, div);

impl Neg for Portable {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        Self(self.0.map(f64::neg))
    }
}

impl BitAnd for PortableMask {
    type Output = Self;

    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] & other.0[i]))
    }
}

impl BitOr for PortableMask {
    type Output = Self;

    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] | other.0[i]))
    }
}

impl Not for PortableMask {
    type Output = Self;

    #[inline(always)]
    fn not(self) -> Self {
        Self(self.0.map(bool::not))
    }
}

impl Mask for PortableMask {
    #[inline(always)]
    fn bits(self) -> u32 {
        (0..LANES).fold(0, |bits, i| bits | u32::from(self.0[i]) << i)
    }
}

impl Lanes for Portable {
    type Mask = PortableMask;
    type Pair = PortablePair;

    #[inline(always)]
    fn splat(value: f64) -> Self {
        Self([value; LANES])
    }

    #[inline(always)]
    fn split(x: Self, y: Self) -> [PortablePair; LANES] {
        std::array::from_fn(|i| PortablePair([x.0[i], y.0[i]]))
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.map(f64::sqrt))
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.map(f64::abs))
    }

    #[inline(always)]
    fn lt(self, other: Self) -> PortableMask {
        self.compare(other, f64::lt)
    }

    #[inline(always)]
    fn le(self, other: Self) -> PortableMask {
        self.compare(other, f64::le)
    }

    #[inline(always)]
    fn smaller(self, other: Self) -> Self {
        self.each(other, |a, b| if b < a { b } else { a })
    }

    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        self.each(other, |a, b| if b > a { b } else { a })
    }

    #[inline(always)]
    fn select(mask: PortableMask, yes: Self, no: Self) -> Self {
        Self(std::array::from_fn(|i| if mask.0[i] { yes.0[i] } else { no.0[i] }))
    }

    #[inline(always)]
    fn new(values: [f64; LANES]) -> Self {
        Self(values)
    }

    #[inline(always)]
    fn array(self) -> [f64; LANES] {
        self.0
    }

    #[inline(always)]
    fn load(values: &[f64; LANES]) -> Self {
        Self(*values)
    }

    #[inline(always)]
    fn widen(values: &[f32; LANES]) -> Self {
        Self(values.map(f64::from))
    }

    #[inline(always)]
    fn store(self, values: &mut [f64; LANES]) {
        *values = self.0;
    }

    #[inline(always)]
    fn pairs(pairs: [&[f64; 2]; LANES]) -> [Self; 2] {
        [0, 1].map(|k| Self(pairs.map(|pair| pair[k])))
    }

    #[inline(always)]
    fn transpose(rows: [Self; LANES]) -> [Self; LANES] {
        std::array::from_fn(|k| Self(rows.map(|row| row.0[k])))
    }

    #[inline(always)]
    fn unpair(x: Self, y: Self) -> [[f64; 2]; LANES] {
        std::array::from_fn(|i| [x.0[i], y.0[i]])
    }
}
