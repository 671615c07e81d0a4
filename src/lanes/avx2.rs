//! Lanes in the 256-bit registers of AVX2.
//!
//! Invariant of every `unsafe` block here: the machine has AVX2. [`Avx2`] is private to
//! [`super`], and only [`run`] names it there, after [`is_available`].

use super::{Kernel, LANES, Lanes, Mask, Pair};
use std::{
    arch::x86_64::*,
    ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub},
};

/// Four numbers in a register.
#[derive(Debug, Clone, Copy)]
pub(super) struct Avx2(__m256d);

/// All bits of a lane set or none.
#[derive(Debug, Clone, Copy)]
pub(super) struct Avx2Mask(__m256d);

/// A plane vector in half a register.
#[derive(Debug, Clone, Copy)]
pub(super) struct Avx2Pair(__m128d);

/// Whether the machine has what [`run`] needs.
#[inline(always)]
pub(super) fn is_available() -> bool {
    is_x86_feature_detected!("avx2")
        && is_x86_feature_detected!("bmi1")
        && is_x86_feature_detected!("bmi2")
        && is_x86_feature_detected!("lzcnt")
}

/// Runs a kernel compiled for AVX2.
///
/// # Panics
/// If the machine does not have it.
#[inline(always)]
pub(super) fn run<K: Kernel>(kernel: K) -> K::Output {
    #[target_feature(enable = "avx2,bmi1,bmi2,lzcnt")]
    fn with_avx2<K: Kernel>(kernel: K) -> K::Output {
        kernel.run::<Avx2>()
    }
    assert!(is_available());
    // SAFETY: just checked
    unsafe { with_avx2(kernel) }
}

macro_rules! operator {
    ($type:ident, $trait:ident, $method:ident, $intrinsic:ident) => {
        impl $trait for $type {
            type Output = Self;

            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                // SAFETY: the machine has AVX2, see the module
                Self(unsafe { $intrinsic(self.0, other.0) })
            }
        }
    };
}

operator!(Avx2, Add, add, _mm256_add_pd);
operator!(Avx2, Sub, sub, _mm256_sub_pd);
operator!(Avx2, Mul, mul, _mm256_mul_pd);
operator!(Avx2, Div, div, _mm256_div_pd);
operator!(Avx2Mask, BitAnd, bitand, _mm256_and_pd);
operator!(Avx2Mask, BitOr, bitor, _mm256_or_pd);

operator!(Avx2Pair, Add, add, _mm_add_pd);
operator!(Avx2Pair, Sub, sub, _mm_sub_pd);

impl Pair for Avx2Pair {
    #[inline(always)]
    fn load(components: &[f64; 2]) -> Self {
        // SAFETY: the machine has AVX2, see the module; the reference is to 16 bytes
        Self(unsafe { _mm_loadu_pd(components.as_ptr()) })
    }

    #[inline(always)]
    fn store(self, components: &mut [f64; 2]) {
        // SAFETY: the machine has AVX2, see the module; the reference is to 16 bytes
        unsafe { _mm_storeu_pd(components.as_mut_ptr(), self.0) }
    }
}

impl Neg for Avx2 {
    type Output = Self;

    #[inline(always)]
    fn neg(self) -> Self {
        // SAFETY: the machine has AVX2, see the module
        Self(unsafe { _mm256_xor_pd(self.0, _mm256_set1_pd(-0.0)) })
    }
}

impl Not for Avx2Mask {
    type Output = Self;

    #[inline(always)]
    fn not(self) -> Self {
        // SAFETY: the machine has AVX2, see the module
        Self(unsafe {
            let all = _mm256_castsi256_pd(_mm256_set1_epi64x(-1));
            _mm256_xor_pd(self.0, all)
        })
    }
}

impl Mask for Avx2Mask {
    #[inline(always)]
    fn bits(self) -> u32 {
        // SAFETY: the machine has AVX2, see the module
        unsafe { _mm256_movemask_pd(self.0) as u32 }
    }
}

impl Lanes for Avx2 {
    type Mask = Avx2Mask;
    type Pair = Avx2Pair;

    #[inline(always)]
    fn splat(value: f64) -> Self {
        // SAFETY: the machine has AVX2, see the module
        Self(unsafe { _mm256_set1_pd(value) })
    }

    #[inline(always)]
    fn split(x: Self, y: Self) -> [Avx2Pair; LANES] {
        // SAFETY: the machine has AVX2, see the module
        unsafe {
            let even = _mm256_unpacklo_pd(x.0, y.0);
            let odd = _mm256_unpackhi_pd(x.0, y.0);
            [
                Avx2Pair(_mm256_castpd256_pd128(even)),
                Avx2Pair(_mm256_castpd256_pd128(odd)),
                Avx2Pair(_mm256_extractf128_pd::<1>(even)),
                Avx2Pair(_mm256_extractf128_pd::<1>(odd)),
            ]
        }
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        // SAFETY: the machine has AVX2, see the module
        Self(unsafe { _mm256_sqrt_pd(self.0) })
    }

    #[inline(always)]
    fn abs(self) -> Self {
        // SAFETY: the machine has AVX2, see the module
        Self(unsafe { _mm256_andnot_pd(_mm256_set1_pd(-0.0), self.0) })
    }

    #[inline(always)]
    fn lt(self, other: Self) -> Avx2Mask {
        // SAFETY: the machine has AVX2, see the module
        Avx2Mask(unsafe { _mm256_cmp_pd::<_CMP_LT_OQ>(self.0, other.0) })
    }

    #[inline(always)]
    fn le(self, other: Self) -> Avx2Mask {
        // SAFETY: the machine has AVX2, see the module
        Avx2Mask(unsafe { _mm256_cmp_pd::<_CMP_LE_OQ>(self.0, other.0) })
    }

    #[inline(always)]
    fn smaller(self, other: Self) -> Self {
        // SAFETY: the machine has AVX2, see the module. The instruction gives its second
        // operand where the first is not smaller or does not compare.
        Self(unsafe { _mm256_min_pd(other.0, self.0) })
    }

    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        // SAFETY: the machine has AVX2, see the module; as for `smaller`
        Self(unsafe { _mm256_max_pd(other.0, self.0) })
    }

    #[inline(always)]
    fn select(mask: Avx2Mask, yes: Self, no: Self) -> Self {
        // SAFETY: the machine has AVX2, see the module
        Self(unsafe { _mm256_blendv_pd(no.0, yes.0, mask.0) })
    }

    #[inline(always)]
    fn new([a, b, c, d]: [f64; LANES]) -> Self {
        // SAFETY: the machine has AVX2, see the module
        Self(unsafe { _mm256_setr_pd(a, b, c, d) })
    }

    #[inline(always)]
    fn array(self) -> [f64; LANES] {
        let mut values = [0.0; LANES];
        self.store(&mut values);
        values
    }

    #[inline(always)]
    fn load(values: &[f64; LANES]) -> Self {
        // SAFETY: the machine has AVX2, see the module; the reference is to 32 bytes
        Self(unsafe { _mm256_loadu_pd(values.as_ptr()) })
    }

    #[inline(always)]
    fn widen(values: &[f32; LANES]) -> Self {
        // SAFETY: the machine has AVX2, see the module; the reference is to 16 bytes
        Self(unsafe { _mm256_cvtps_pd(_mm_loadu_ps(values.as_ptr())) })
    }

    #[inline(always)]
    fn store(self, values: &mut [f64; LANES]) {
        // SAFETY: the machine has AVX2, see the module; the reference is to 32 bytes
        unsafe { _mm256_storeu_pd(values.as_mut_ptr(), self.0) }
    }

    #[inline(always)]
    fn pairs([a, b, c, d]: [&[f64; 2]; LANES]) -> [Self; 2] {
        // SAFETY: the machine has AVX2, see the module; each reference is to 16 bytes
        unsafe {
            let even = _mm256_insertf128_pd::<1>(
                _mm256_castpd128_pd256(_mm_loadu_pd(a.as_ptr())),
                _mm_loadu_pd(c.as_ptr()),
            );
            let odd = _mm256_insertf128_pd::<1>(
                _mm256_castpd128_pd256(_mm_loadu_pd(b.as_ptr())),
                _mm_loadu_pd(d.as_ptr()),
            );
            [Self(_mm256_unpacklo_pd(even, odd)), Self(_mm256_unpackhi_pd(even, odd))]
        }
    }

    #[inline(always)]
    fn transpose([a, b, c, d]: [Self; LANES]) -> [Self; LANES] {
        // SAFETY: the machine has AVX2, see the module
        unsafe {
            let (a, b, c, d) = (a.0, b.0, c.0, d.0);
            let (ab_even, ab_odd) = (_mm256_unpacklo_pd(a, b), _mm256_unpackhi_pd(a, b));
            let (cd_even, cd_odd) = (_mm256_unpacklo_pd(c, d), _mm256_unpackhi_pd(c, d));
            [
                Self(_mm256_permute2f128_pd::<0x20>(ab_even, cd_even)),
                Self(_mm256_permute2f128_pd::<0x20>(ab_odd, cd_odd)),
                Self(_mm256_permute2f128_pd::<0x31>(ab_even, cd_even)),
                Self(_mm256_permute2f128_pd::<0x31>(ab_odd, cd_odd)),
            ]
        }
    }

    #[inline(always)]
    fn unpair(x: Self, y: Self) -> [[f64; 2]; LANES] {
        let mut pairs = [[0.0; 2]; LANES];
        // SAFETY: the machine has AVX2, see the module; each pair has 16 bytes
        unsafe {
            let even = _mm256_unpacklo_pd(x.0, y.0);
            let odd = _mm256_unpackhi_pd(x.0, y.0);
            _mm_storeu_pd(pairs[0].as_mut_ptr(), _mm256_castpd256_pd128(even));
            _mm_storeu_pd(pairs[1].as_mut_ptr(), _mm256_castpd256_pd128(odd));
            _mm_storeu_pd(pairs[2].as_mut_ptr(), _mm256_extractf128_pd::<1>(even));
            _mm_storeu_pd(pairs[3].as_mut_ptr(), _mm256_extractf128_pd::<1>(odd));
        }
        pairs
    }
}
