//! The loose octree: cubes within cubes, each box in the one that its size and centre name (Ulrich 2000; Ericson 2005, §7.3.5).
//!
//! ```text
//! start at the root's cube; while the child's edge is not less than the box's largest edge, go to the child with its centre
//! ```
//!
//! In a strict octree a small box astride a large plane stays near the root. Here a cube's box is *loose*: it is what its boxes
//! cover, at most half an edge more on each side, so size alone decides the level. A query leaves out whatever
//! cube's loose box it misses. Time n log n; a box costs one entry, and cubes without boxes are never made.

use super::{Aabb, BroadPhase, Pair, PairSort, Ray, bytes, valid_keys};
use crate::math::Vec3;

/// Below this level boxes no longer sink: 2²⁰ cubes along an edge.
const DEEPEST: u32 = 20;
const NONE: u32 = u32::MAX;

/// A cube: its boxes and its eight children.
#[derive(Clone, Debug)]
struct Cube {
    /// Around everything in it and below.
    loose: Aabb,
    child: [u32; 8],
    /// The first of its boxes; the others follow by `next`.
    first: u32,
}

/// A tree of cubes.
#[derive(Clone, Debug, Default)]
pub struct Octree {
    boxes: Vec<Aabb>,
    keys: Vec<u32>,
    cubes: Vec<Cube>,
    /// The next box of the same cube, by key.
    next: Vec<u32>,
    pair_sort: PairSort,
}

impl Octree {
    fn add_cube(&mut self) -> u32 {
        self.cubes.push(Cube { loose: Aabb::EMPTY, child: [NONE; 8], first: NONE });
        self.cubes.len() as u32 - 1
    }
    /// Puts a box into its cube, from the root of half edge `half` about `center` down.
    fn insert(&mut self, key: u32, mut center: Vec3, mut half: f64) {
        let b = self.boxes[key as usize];
        let (c, largest) = (b.center(), b.size().max_abs());
        let mut at = 0;
        for _ in 0..DEEPEST {
            let cube = &mut self.cubes[at as usize];
            cube.loose = cube.loose.merged(&b);
            // The edge of a child is `half`.
            if largest > half || largest.is_nan() {
                break;
            }
            let side = [c.x >= center.x, c.y >= center.y, c.z >= center.z];
            let octant = usize::from(side[0]) | usize::from(side[1]) << 1 | usize::from(side[2]) << 2;
            half *= 0.5;
            for i in 0..3 {
                center[i] += if side[i] { half } else { -half };
            }
            if self.cubes[at as usize].child[octant] == NONE {
                let child = self.add_cube();
                self.cubes[at as usize].child[octant] = child;
            }
            at = self.cubes[at as usize].child[octant];
        }
        let cube = &mut self.cubes[at as usize];
        cube.loose = cube.loose.merged(&b);
        self.next[key as usize] = core::mem::replace(&mut cube.first, key);
    }
    /// Calls `found` with every key below a cube for which `enter` holds all the way down.
    fn visit(&self, enter: impl Fn(&Aabb) -> bool, mut found: impl FnMut(u32)) {
        let mut stack = [0; 8 * DEEPEST as usize + 8];
        let mut len = usize::from(!self.cubes.is_empty());
        while len > 0 {
            len -= 1;
            let cube = &self.cubes[stack[len] as usize];
            if !enter(&cube.loose) {
                continue;
            }
            let mut key = cube.first;
            while key != NONE {
                found(key);
                key = self.next[key as usize];
            }
            for &child in cube.child.iter().filter(|&&child| child != NONE) {
                stack[len] = child;
                len += 1;
            }
        }
    }
}

impl BroadPhase for Octree {
    fn update(&mut self, boxes: &[Aabb]) {
        self.boxes.clear();
        self.boxes.extend_from_slice(boxes);
        valid_keys(boxes, &mut self.keys);
        self.next.clear();
        self.next.resize(boxes.len(), NONE);
        self.cubes.clear();
        self.add_cube();
        let finite = self.keys.iter().map(|&i| boxes[i as usize]).filter(Aabb::is_finite);
        let around = finite.fold(Aabb::EMPTY, |a, b| a.merged(&b));
        let (center, half) =
            if around.is_valid() { (around.center(), 0.5 * around.size().max_abs()) } else { (Vec3::ZERO, 1.0) };
        for n in 0..self.keys.len() {
            self.insert(self.keys[n], center, half);
        }
    }
    fn pairs(&mut self, out: &mut Vec<Pair>) {
        out.clear();
        for &i in &self.keys {
            let a = &self.boxes[i as usize];
            let found = |j: u32| {
                if j > i && a.meets(&self.boxes[j as usize]) {
                    out.push((i, j));
                }
            };
            self.visit(|loose| loose.meets(a), found);
        }
        self.pair_sort.sort(out);
    }
    fn query(&self, region: &Aabb, out: &mut Vec<u32>) {
        out.clear();
        if region.is_valid() {
            let meets = |i: u32| self.boxes[i as usize].meets(region);
            self.visit(|loose| loose.meets(region), |i| out.extend(meets(i).then_some(i)));
            out.sort_unstable();
        }
    }
    fn ray(&self, ray: &Ray, out: &mut Vec<u32>) {
        out.clear();
        let hit = |b: &Aabb| b.ray(ray).is_some();
        self.visit(hit, |i| out.extend(hit(&self.boxes[i as usize]).then_some(i)));
        out.sort_unstable();
    }
    fn memory(&self) -> usize {
        let lists = bytes(&self.keys) + bytes(&self.next);
        lists + bytes(&self.boxes) + bytes(&self.cubes) + self.pair_sort.memory()
    }
}
