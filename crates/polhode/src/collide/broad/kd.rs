//! The k-d tree: space halved by planes, a box in every leaf it reaches (Bentley 1975; Ericson 2005, §7.3.7).
//!
//! ```text
//! split(boxes):  a plane through the median centre, across the axis along which the centres vary most
//!                boxes with min < plane go left, with max ≥ plane right: some go to both
//!                until few are left, or no plane separates enough of them
//! two boxes of a leaf that overlap are a pair, reported in the leaf with the lower corner of their intersection
//! ```
//!
//! The planes follow the boxes, so clusters cost nothing, but a box astride many planes is stored many times. It is built anew
//! at each update, in time n log² n: a tree for what does not move.

use super::sweep::widest_axis;
use super::{Aabb, BroadPhase, Pair, PairSort, Ray, bytes, valid_keys};
use crate::math::{Lane, Vec3};

/// A leaf with no more boxes than this is not split.
const FEW: usize = 12;
/// Planes above a leaf, at most.
const DEEPEST: usize = 40;

/// A region of space, open towards greater coordinates.
#[derive(Clone, Copy, Debug)]
struct Region {
    low: Vec3,
    high: Vec3,
}

impl Region {
    const ALL: Self = Self { low: Vec3::splat(f64::NEG_INFINITY), high: Vec3::splat(f64::INFINITY) };

    fn holds(&self, p: Vec3) -> bool {
        // +∞ itself belongs to the last region.
        (0..3).all(|i| self.low[i] <= p[i] && (p[i] < self.high[i] || self.high[i] == f64::INFINITY))
    }
}

#[derive(Clone, Debug)]
enum Node {
    /// Its two sides, and the box around all that is in them.
    Plane { around: Aabb, left: u32, right: u32 },
    /// Its part of `entries`.
    Leaf { around: Aabb, region: Region, first: usize, end: usize },
}

/// Planes and leaves.
#[derive(Clone, Debug, Default)]
pub struct Kd {
    boxes: Vec<Aabb>,
    keys: Vec<u32>,
    nodes: Vec<Node>,
    entries: Vec<u32>,
    pair_sort: PairSort,
}

/// A plane that leaves at most three quarters of the boxes, those on both sides counted twice, on either side.
fn plane(boxes: &[Aabb], keys: &[u32]) -> Option<(usize, f64)> {
    let axis = widest_axis(boxes, keys);
    let mut centers: Vec<f64> = keys.iter().map(|&i| boxes[i as usize].center()[axis]).collect();
    let middle = centers.len() / 2;
    let plane = *centers.select_nth_unstable_by(middle, f64::total_cmp).1;
    let left = keys.iter().filter(|&&i| boxes[i as usize].min[axis] < plane).count();
    let right = keys.iter().filter(|&&i| boxes[i as usize].max[axis] >= plane).count();
    (4 * left.max(right) <= 3 * keys.len()).then_some((axis, plane))
}

impl Kd {
    /// Divides `keys`, all that reach into `region`, and returns the index of the node.
    fn split(&mut self, keys: Vec<u32>, region: Region, depth: usize) -> u32 {
        let around = keys.iter().fold(Aabb::EMPTY, |a, &i| a.merged(&self.boxes[i as usize]));
        let cut = if keys.len() > FEW && depth < DEEPEST { plane(&self.boxes, &keys) } else { None };
        let at = self.nodes.len();
        let Some((axis, plane)) = cut else {
            let first = self.entries.len();
            self.entries.extend(keys);
            self.nodes.push(Node::Leaf { around, region, first, end: self.entries.len() });
            return at as u32;
        };
        self.nodes.push(Node::Plane { around, left: 0, right: 0 });
        let (mut below, mut above) = (region, region);
        (below.high[axis], above.low[axis]) = (plane, plane);
        let left = keys.iter().copied().filter(|&i| self.boxes[i as usize].min[axis] < plane).collect();
        let right = keys.iter().copied().filter(|&i| self.boxes[i as usize].max[axis] >= plane).collect();
        drop(keys);
        let left = self.split(left, below, depth + 1);
        let right = self.split(right, above, depth + 1);
        self.nodes[at] = Node::Plane { around, left, right };
        at as u32
    }
    /// Calls `found` with the keys of every leaf for which `enter` holds all the way down; a key may come several times.
    fn visit(&self, enter: impl Fn(&Aabb) -> bool, mut found: impl FnMut(u32)) {
        let mut stack = [0; DEEPEST + 2];
        let mut len = usize::from(!self.nodes.is_empty());
        while len > 0 {
            len -= 1;
            match &self.nodes[stack[len] as usize] {
                Node::Plane { around, left, right } if enter(around) => {
                    stack[len] = *left;
                    stack[len + 1] = *right;
                    len += 2;
                }
                Node::Leaf { around, first, end, .. } if enter(around) => {
                    self.entries[*first..*end].iter().for_each(|&i| found(i));
                }
                _ => {}
            }
        }
    }
}

impl BroadPhase for Kd {
    fn update(&mut self, boxes: &[Aabb]) {
        self.boxes.clear();
        self.boxes.extend_from_slice(boxes);
        valid_keys(boxes, &mut self.keys);
        self.nodes.clear();
        self.entries.clear();
        self.split(self.keys.clone(), Region::ALL, 0);
    }
    fn pairs(&mut self, out: &mut Vec<Pair>) {
        out.clear();
        for node in &self.nodes {
            let Node::Leaf { region, first, end, .. } = node else { continue };
            let keys = &self.entries[*first..*end];
            for (n, &i) in keys.iter().enumerate() {
                let a = &self.boxes[i as usize];
                for &j in &keys[n + 1..] {
                    let b = &self.boxes[j as usize];
                    let corner = || {
                        let (p, q) = (a.min, b.min);
                        Vec3::new(p.x.greatest(q.x), p.y.greatest(q.y), p.z.greatest(q.z))
                    };
                    if a.meets(b) && region.holds(corner()) {
                        out.push((i, j));
                    }
                }
            }
        }
        self.pair_sort.sort(out);
    }
    fn query(&self, region: &Aabb, out: &mut Vec<u32>) {
        out.clear();
        if region.is_valid() {
            let meets = |i: u32| self.boxes[i as usize].meets(region);
            self.visit(|around| around.meets(region), |i| out.extend(meets(i).then_some(i)));
            out.sort_unstable();
            out.dedup();
        }
    }
    fn ray(&self, ray: &Ray, out: &mut Vec<u32>) {
        out.clear();
        let hit = |b: &Aabb| b.ray(ray).is_some();
        self.visit(hit, |i| out.extend(hit(&self.boxes[i as usize]).then_some(i)));
        out.sort_unstable();
        out.dedup();
    }
    fn memory(&self) -> usize {
        let lists = bytes(&self.keys) + bytes(&self.entries);
        lists + bytes(&self.boxes) + bytes(&self.nodes) + self.pair_sort.memory()
    }
}
