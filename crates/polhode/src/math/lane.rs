//! A number that may be several numbers: the type every law is written in.
//!
//! A law is written once, generic over [`Lane`]. With `f64` it is the textbook's formula for one body; with
//! `f64x8<S>` it is the same formula for eight bodies at once. Every operation here is one IEEE operation a lane, so the
//! bits do not depend on the width: no fused multiply-add, no reciprocal estimate, no horizontal sum.

use core::fmt::Debug;
use core::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};
use fearless_simd::{Select, Simd, SimdBase, SimdFloat, SimdMask, f64x2, f64x4, f64x8};

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

macro_rules! wide_lane {
    ($($wide:ident),*) => {$(
        impl<S: Simd> Lane for $wide<S> {
            type Mask = <Self as SimdBase<S>>::Mask;
            #[inline(always)]
            fn like(self, value: f64) -> Self {
                Self::splat(self.simd, value)
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                SimdFloat::sqrt(self)
            }
            #[inline(always)]
            fn abs(self) -> Self {
                SimdBase::abs(self)
            }
            #[inline(always)]
            fn lt(self, other: Self) -> Self::Mask {
                self.simd_lt(other)
            }
            #[inline(always)]
            fn select(mask: Self::Mask, if_true: Self, if_false: Self) -> Self {
                Select::select(mask, if_true, if_false)
            }
            #[inline(always)]
            fn any(mask: Self::Mask) -> bool {
                mask.any_true()
            }
        }
    )*};
}
wide_lane!(f64x2, f64x4, f64x8);
