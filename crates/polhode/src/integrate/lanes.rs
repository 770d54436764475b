//! The pDMV drift of many bodies, as many at once as the CPU has lanes.
//!
//! The formula is [`pdmv::rotate`], one text; here it is fed with vectors of the width that the CPU offers at run time.
//! A lane does the same IEEE operations in the same order at every width, so the width never shows in a result.

use super::exact;
use super::pdmv::{self, Order};
use crate::math::{Lane, Quat, Vec3, Wide};
use fearless_simd::{Level, Simd, dispatch};

/// How many bodies go through the arithmetic at once. Every choice gives the same bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
pub enum Lanes {
    /// As many as the CPU has: 8 with AVX-512, 4 with AVX2, 2 otherwise.
    #[default]
    Native,
    /// One at a time: the plain f64 formula.
    One,
}

impl Lanes {
    /// The number of f64 lanes on this machine.
    pub fn count(self) -> usize {
        match self {
            Self::Native => dispatch!(Level::new(), simd => native_width(simd)),
            Self::One => 1,
        }
    }
}

#[inline(always)]
fn native_width<S: Simd>(_: S) -> usize {
    Wide::<S>::LEN
}

/// Turns every body of the slices over `h` \[s\].
///
/// `l` in world axes [kg·m²/s]; `k` reciprocal principal moments [1/(kg·m²)]. All slices have length (n_bodies). A body that
/// spins too fast for the map (see [`pdmv::MAX_SUBROTATIONS`]) is turned by the exact solution, which has no such limit.
///
/// # Panics
/// If the slices differ in length.
pub fn rotate(lanes: Lanes, order: Order, rot: &mut [Quat], l: &[Vec3], k: &[Vec3], h: f64) {
    assert!(rot.len() == l.len() && rot.len() == k.len(), "slices of one length");
    match lanes {
        Lanes::One => scalar(order, rot, l, k, h),
        // One match on the order outside the loops: each order gets its own straight-line code.
        Lanes::Native => dispatch!(Level::new(), simd => match order {
            Order::Two => wide(simd, Order::Two, rot, l, k, h),
            Order::Four => wide(simd, Order::Four, rot, l, k, h),
            Order::Six => wide(simd, Order::Six, rot, l, k, h),
            Order::Eight => wide(simd, Order::Eight, rot, l, k, h),
            Order::Ten => wide(simd, Order::Ten, rot, l, k, h),
        }),
    }
}

/// Turns one body over `h` \[s\]: the same bits as [`rotate`].
pub fn rotate_one(order: Order, rot: Quat, l: Vec3, k: Vec3, h: f64) -> Quat {
    let (turned, too_fast) = pdmv::rotate(order, rot, l, k, h);
    if too_fast {
        return exact::rotate(rot, l, Vec3::new(1.0 / k.x, 1.0 / k.y, 1.0 / k.z), h);
    }
    turned
}

fn scalar(order: Order, rot: &mut [Quat], l: &[Vec3], k: &[Vec3], h: f64) {
    for ((rot, &l), &k) in rot.iter_mut().zip(l).zip(k) {
        *rot = rotate_one(order, *rot, l, k, h);
    }
}

#[inline(always)]
fn wide<S: Simd>(simd: S, order: Order, rot: &mut [Quat], l: &[Vec3], k: &[Vec3], h: f64) {
    let n = Wide::<S>::LEN;
    let whole = rot.len() / n * n;
    let h_wide = Wide::splat(simd, h);
    let gather = |v: &[Vec3]| {
        Vec3::new(Wide::from_fn(simd, |i| v[i].x), Wide::from_fn(simd, |i| v[i].y), Wide::from_fn(simd, |i| v[i].z))
    };
    for first in (0..whole).step_by(n) {
        let range = first..first + n;
        let (rot, l, k) = (&mut rot[range.clone()], &l[range.clone()], &k[range]);
        let q = Quat::new(
            Wide::from_fn(simd, |i| rot[i].w),
            Wide::from_fn(simd, |i| rot[i].x),
            Wide::from_fn(simd, |i| rot[i].y),
            Wide::from_fn(simd, |i| rot[i].z),
        );
        let (turned, too_fast) = pdmv::rotate(order, q, gather(l), gather(k), h_wide);
        if Wide::<S>::any(too_fast) {
            scalar(order, rot, l, k, h);
            continue;
        }
        for (i, rot) in rot.iter_mut().enumerate() {
            *rot = Quat::new(turned.w.lane(i), turned.x.lane(i), turned.y.lane(i), turned.z.lane(i));
        }
    }
    scalar(order, &mut rot[whole..], &l[whole..], &k[whole..], h);
}
