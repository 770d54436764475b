//! A node of eight boxes, and one box against all eight.
//!
//! Boxes are f32 relative to the tree's origin, rounded outwards, which halves the memory of f64 and doubles the lanes. Rounding
//! is monotone: from a.min ≤ b.max follows down(a.min) ≤ up(b.max), so two boxes that overlap still do; some that do not, within
//! a relative 1e-7 of their distance from the origin, do as well and are refused later by their exact boxes.

use crate::collide::bounds::Aabb;
use crate::math::Vec3;
use fearless_simd::{Simd, f32x8, prelude::*};

/// Lanes of a node.
pub(super) const LANES: usize = 8;
/// No child, no parent, no place.
pub(super) const NONE: u32 = u32::MAX;
/// Marks a child that is a box and no node; the rest is its key.
pub(super) const LEAF: u32 = 1 << 31;
/// The greatest key a tree takes, less one: a key has 31 bits, and one value is taken by [`NONE`].
pub(super) const KEYS: u32 = LEAF - 1;
/// Areas and centres are taken of boxes cut off here, so that neither overflows.
const FAR: f32 = 1e17;

/// A box relative to the tree's origin, rounded outwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Box32 {
    pub(super) min: [f32; 3],
    pub(super) max: [f32; 3],
}

fn down(x: f64) -> f32 {
    let near = x as f32;
    if f64::from(near) > x { near.next_down() } else { near }
}

fn up(x: f64) -> f32 {
    let near = x as f32;
    if f64::from(near) < x { near.next_up() } else { near }
}

#[inline(always)]
fn least(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

#[inline(always)]
fn greatest(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// `x` within ±[`FAR`].
#[inline(always)]
fn cut(x: f32) -> f32 {
    greatest(least(x, FAR), -FAR)
}

impl Box32 {
    /// Neutral in a union.
    pub(super) const EMPTY: Self = Self { min: [f32::INFINITY; 3], max: [f32::NEG_INFINITY; 3] };
    /// Where there is none: NaN is on no side of anything, so no comparison finds it.
    pub(super) const ABSENT: Self = Self { min: [f32::NAN; 3], max: [f32::NAN; 3] };

    pub(super) fn outward(b: &Aabb, origin: Vec3) -> Self {
        let (min, max) = (b.min - origin, b.max - origin);
        Self { min: [down(min.x), down(min.y), down(min.z)], max: [up(max.x), up(max.y), up(max.z)] }
    }
    pub(super) fn is_absent(&self) -> bool {
        self.min[0].is_nan()
    }
    #[inline(always)]
    pub(super) fn merged(&self, b: &Self) -> Self {
        let min = [least(self.min[0], b.min[0]), least(self.min[1], b.min[1]), least(self.min[2], b.min[2])];
        let max = [greatest(self.max[0], b.max[0]), greatest(self.max[1], b.max[1]), greatest(self.max[2], b.max[2])];
        Self { min, max }
    }
    #[inline(always)]
    pub(super) fn meets(&self, b: &Self) -> bool {
        (0..3).all(|i| self.min[i] <= b.max[i] && b.min[i] <= self.max[i])
    }
    #[inline(always)]
    pub(super) fn contains(&self, b: &Self) -> bool {
        (0..3).all(|i| self.min[i] <= b.min[i] && b.max[i] <= self.max[i])
    }
    /// Half of the surface, of what is left within ±[`FAR`]; 0 for [`Box32::EMPTY`].
    #[inline(always)]
    pub(super) fn half_area(&self) -> f32 {
        let edge = |i: usize| greatest(cut(self.max[i]) - cut(self.min[i]), 0.0);
        let (x, y, z) = (edge(0), edge(1), edge(2));
        x * y + y * z + z * x
    }
    /// Twice the centre, within ±[`FAR`].
    #[inline(always)]
    pub(super) fn twice_center(&self) -> [f32; 3] {
        [0, 1, 2].map(|i| cut(self.min[i]) + cut(self.max[i]))
    }
}

/// Eight boxes, each around a key or around another node.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub(super) struct Node {
    pub(super) min: [[f32; LANES]; 3],
    pub(super) max: [[f32; LANES]; 3],
    /// The index of a node, or a key with [`LEAF`], or [`NONE`].
    pub(super) child: [u32; LANES],
    /// The parent's index times [`LANES`] plus the lane in it, or [`NONE`].
    pub(super) parent: u32,
    /// Whether something below has moved since the node was built.
    pub(super) stirred: bool,
    /// Levels from here down, as it was built.
    pub(super) height: u32,
}

impl Node {
    pub(super) const VACANT: Self = Self {
        min: [[f32::NAN; LANES]; 3],
        max: [[f32::NAN; LANES]; 3],
        child: [NONE; LANES],
        parent: NONE,
        stirred: false,
        height: 1,
    };

    #[inline(always)]
    pub(super) fn get(&self, lane: usize) -> Box32 {
        Box32 { min: [0, 1, 2].map(|i| self.min[i][lane]), max: [0, 1, 2].map(|i| self.max[i][lane]) }
    }
    #[inline(always)]
    pub(super) fn set(&mut self, lane: usize, b: &Box32) {
        for i in 0..3 {
            self.min[i][lane] = b.min[i];
            self.max[i][lane] = b.max[i];
        }
    }
    /// The lanes that hold something.
    pub(super) fn lanes(&self) -> impl Iterator<Item = usize> + '_ {
        (0..LANES).filter(|&lane| self.child[lane] != NONE)
    }
    pub(super) fn free_lane(&self) -> Option<usize> {
        self.child.iter().position(|&c| c == NONE)
    }
    /// The union of the lanes.
    pub(super) fn union(&self) -> Box32 {
        // A vacant lane is NaN, which loses every comparison against what is already there.
        let mut all = Box32::EMPTY;
        for i in 0..3 {
            for lane in 0..LANES {
                all.min[i] = least(self.min[i][lane], all.min[i]);
                all.max[i] = greatest(self.max[i][lane], all.max[i]);
            }
        }
        all
    }
}

/// One box in every lane.
#[derive(Clone, Copy)]
pub(super) struct Probe<S: Simd> {
    min: [f32x8<S>; 3],
    max: [f32x8<S>; 3],
}

impl<S: Simd> Probe<S> {
    #[inline(always)]
    pub(super) fn new(simd: S, b: &Box32) -> Self {
        Self { min: b.min.map(|x| f32x8::splat(simd, x)), max: b.max.map(|x| f32x8::splat(simd, x)) }
    }
    /// The lanes of `node` that overlap the box, as bits.
    #[inline(always)]
    pub(super) fn meets(&self, simd: S, node: &Node) -> u32 {
        let axis = |i: usize| {
            f32x8::from_slice(simd, &node.min[i]).simd_le(self.max[i])
                & self.min[i].simd_le(f32x8::from_slice(simd, &node.max[i]))
        };
        (axis(0) & axis(1) & axis(2)).to_bitmask() as u32
    }
}

/// The bits of a mask, lowest first.
pub(super) struct Bits(pub(super) u32);

impl Iterator for Bits {
    type Item = usize;
    #[inline(always)]
    fn next(&mut self) -> Option<usize> {
        if self.0 == 0 {
            return None;
        }
        let lane = self.0.trailing_zeros() as usize;
        self.0 &= self.0 - 1;
        Some(lane)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounding_goes_outwards_at_every_size() {
        for x in [0.0, 1e-300, 1e-40, 0.1, 1.0 / 3.0, 1e7 + 0.3, 1e38, 1e39, 1e300, f64::INFINITY] {
            for x in [x, -x] {
                assert!(f64::from(down(x)) <= x && f64::from(up(x)) >= x, "{x}");
            }
        }
    }

    #[test]
    fn a_vacant_lane_meets_nothing_and_adds_nothing() {
        let everything = Box32 { min: [f32::NEG_INFINITY; 3], max: [f32::INFINITY; 3] };
        let mut node = Node::VACANT;
        assert!(!Box32::ABSENT.meets(&everything) && node.union() == Box32::EMPTY);
        node.set(3, &everything);
        node.child[3] = 0;
        let found = fearless_simd::dispatch!(fearless_simd::Level::new(), simd => Probe::new(simd, &everything).meets(simd, &node));
        assert_eq!((found, node.union()), (1 << 3, everything));
    }
}
