//! A number that may be several numbers: the type every law is written in.
//!
//! A law is written once, generic over [`Lane`]. With `f64` it is the textbook's formula for one body; with
//! [`Wide`] it is the same formula for as many bodies as fit in a register. Every operation here is one IEEE operation a lane, so the
//! bits do not depend on the width: no fused multiply-add, no reciprocal estimate, no horizontal sum.

use core::fmt::Debug;
use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};
use fearless_simd::{ExtractToken, Select, Simd, SimdBase, SimdFloat, SimdMask};

/// A scalar or a vector of scalars that go through the same arithmetic.
///
/// Constants are made from a value at hand, `x.like(0.5)`, because a SIMD value carries the proof that its instruction
/// set is present and a literal does not.
pub trait Lane:
    Copy + Debug + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self> + Neg<Output = Self>
{
    /// One truth value a lane.
    type Mask: Copy + BitAnd<Output = Self::Mask> + BitOr<Output = Self::Mask> + Not<Output = Self::Mask>;

    /// The constant `value` in every lane.
    fn like(self, value: f64) -> Self;
    /// Square root, correctly rounded.
    fn sqrt(self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
    /// The least integer not below self.
    fn ceil(self) -> Self;
    /// Lane-wise `self < other`.
    fn lt(self, other: Self) -> Self::Mask;
    /// Lane-wise choice: `if_true` where the mask holds.
    fn select(mask: Self::Mask, if_true: Self, if_false: Self) -> Self;
    /// Whether the mask holds in any lane.
    fn any(mask: Self::Mask) -> bool;

    /// `if self < other { self } else { other }`, the same bits on every machine.
    #[inline(always)]
    fn least(self, other: Self) -> Self {
        Self::select(self.lt(other), self, other)
    }
    /// `if self < other { other } else { self }`, the same bits on every machine.
    #[inline(always)]
    fn greatest(self, other: Self) -> Self {
        Self::select(self.lt(other), other, self)
    }
}

impl Lane for f64 {
    type Mask = bool;
    #[inline(always)]
    fn like(self, value: f64) -> Self {
        value
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self::sqrt(self)
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self::abs(self)
    }
    #[inline(always)]
    fn ceil(self) -> Self {
        Self::ceil(self)
    }
    #[inline(always)]
    fn lt(self, other: Self) -> bool {
        self < other
    }
    #[inline(always)]
    fn select(mask: bool, if_true: Self, if_false: Self) -> Self {
        if mask { if_true } else { if_false }
    }
    #[inline(always)]
    fn any(mask: bool) -> bool {
        mask
    }
}

/// As many f64 as the instruction set `S` holds in one register: 2, 4 or 8.
#[derive(Clone, Copy, Debug)]
pub struct Wide<S: Simd>(S::f64s);

impl<S: Simd> Wide<S> {
    /// The number of lanes.
    pub const LEN: usize = <S::f64s as SimdBase<S>>::LEN;

    /// `value` in every lane.
    #[inline(always)]
    pub fn splat(simd: S, value: f64) -> Self {
        Self(S::f64s::splat(simd, value))
    }
    /// `f(i)` in lane `i`.
    #[inline(always)]
    pub fn from_fn(simd: S, f: impl FnMut(usize) -> f64) -> Self {
        Self(S::f64s::from_fn(simd, f))
    }
    /// The number in lane `i`.
    ///
    /// # Panics
    /// If `i` is not below [`Wide::LEN`].
    #[inline(always)]
    pub fn lane(&self, i: usize) -> f64 {
        self.0[i]
    }
}

macro_rules! wide_operator {
    ($($Trait:ident $function:ident),*) => {$(
        impl<S: Simd> $Trait for Wide<S> {
            type Output = Self;
            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                Self(self.0.$function(other.0))
            }
        }
    )*};
}
wide_operator!(Add add, Sub sub, Mul mul, Div div);

impl<S: Simd> Neg for Wide<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl<S: Simd> Lane for Wide<S> {
    type Mask = S::mask64s;
    #[inline(always)]
    fn like(self, value: f64) -> Self {
        Self::splat(self.0.token(), value)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.sqrt())
    }
    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.abs())
    }
    #[inline(always)]
    fn ceil(self) -> Self {
        Self(self.0.ceil())
    }
    #[inline(always)]
    fn lt(self, other: Self) -> Self::Mask {
        self.0.simd_lt(other.0)
    }
    #[inline(always)]
    fn select(mask: Self::Mask, if_true: Self, if_false: Self) -> Self {
        Self(mask.select(if_true.0, if_false.0))
    }
    #[inline(always)]
    fn any(mask: Self::Mask) -> bool {
        mask.any_true()
    }
}
