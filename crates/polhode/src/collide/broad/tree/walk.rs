//! Ways through the tree: one box against it, it against itself, two against each other, a ray.
//!
//! ```text
//! itself(node):   for each lane i:  the lanes j > i that overlap i →  two boxes: a pair
//!                                                                     two nodes: between(i, j)
//!                 for each lane that is a node:  itself(lane)
//! between(a, b):  for each lane i of a:  the lanes j of b that overlap i, as above
//! ```
//!
//! Each test is one box against eight lanes. The order of the walk is that of the memory and shows in no result, for what is
//! found is sorted afterwards.

use super::Tree;
use super::node::{Bits, Box32, LEAF, NONE, Node, Probe};
use crate::collide::bounds::{Aabb, Ray};
use crate::collide::broad::{Pair, pair};
use crate::math::Vec3;
use fearless_simd::{Level, Simd, dispatch};

/// What is still to visit: on the stack for any tree that was built, on the heap for one grown long without [`Tree::mend`].
struct Stack<T> {
    near: [T; 160],
    len: usize,
    far: Vec<T>,
}

impl<T: Copy + Default> Stack<T> {
    #[inline(always)]
    fn new(first: Option<T>) -> Self {
        let mut stack = Self { near: [T::default(); 160], len: 0, far: Vec::new() };
        if let Some(first) = first {
            stack.push(first);
        }
        stack
    }
    #[inline(always)]
    fn push(&mut self, item: T) {
        if self.len < self.near.len() {
            self.near[self.len] = item;
            self.len += 1;
        } else {
            self.far.push(item);
        }
    }
    #[inline(always)]
    fn pop(&mut self) -> Option<T> {
        if let Some(item) = self.far.pop() {
            return Some(item);
        }
        self.len = self.len.checked_sub(1)?;
        Some(self.near[self.len])
    }
}

impl Tree {
    /// Appends the keys whose fat boxes overlap `region`, in no particular order.
    pub fn query(&self, region: &Aabb, out: &mut Vec<u32>) {
        if region.is_valid() {
            self.query_fat(&Box32::outward(region, self.origin), out);
        }
    }
    /// Appends the keys whose fat boxes overlap a box relative to this tree's origin.
    pub(super) fn query_fat(&self, region: &Box32, out: &mut Vec<u32>) {
        dispatch!(Level::new(), simd => one_against(simd, self, region, out));
    }
    /// Appends the keys whose fat boxes `ray` may go through, in no particular order.
    pub fn query_ray(&self, ray: &Ray, out: &mut Vec<u32>) {
        if !ray.is_valid() {
            return;
        }
        // A box relative to the origin comes back with a rounding of each addition; a wider one finds no less.
        let slack = 4.0 * f64::EPSILON * (self.origin.max_abs() + ray.origin.max_abs());
        let mut stack = Stack::new(self.root);
        while let Some(at) = stack.pop() {
            let node = &self.nodes[at as usize];
            for lane in node.lanes() {
                let b = node.get(lane);
                let corner = |c: [f32; 3]| Vec3::from(c.map(f64::from)) + self.origin;
                let wide = Aabb::new(corner(b.min), corner(b.max)).expanded(slack);
                if wide.ray(ray).is_some() {
                    visit(node.child[lane], &mut stack, out);
                }
            }
        }
    }
    /// Appends every two keys of this tree whose fat boxes overlap, in no particular order.
    pub fn pairs_within(&self, out: &mut Vec<Pair>) {
        if let Some(root) = self.root {
            dispatch!(Level::new(), simd => itself(simd, self, root, out));
        }
    }
    /// Appends every key of this tree paired with every key of `other` where their fat boxes overlap, in no particular order.
    ///
    /// # Panics
    /// If the trees have different origins.
    pub fn pairs_between(&self, other: &Self, out: &mut Vec<Pair>) {
        assert!(self.origin == other.origin, "trees that meet have one origin");
        if let (Some(a), Some(b)) = (self.root, other.root) {
            dispatch!(Level::new(), simd => each_other(simd, (self, a), (other, b), out));
        }
    }
}

#[inline(always)]
fn visit(child: u32, stack: &mut Stack<u32>, out: &mut Vec<u32>) {
    if child & LEAF == 0 {
        stack.push(child);
    } else if child != NONE {
        out.push(child & !LEAF);
    }
}

#[inline(always)]
fn one_against<S: Simd>(simd: S, tree: &Tree, region: &Box32, out: &mut Vec<u32>) {
    let probe = Probe::new(simd, region);
    let mut stack = Stack::new(tree.root);
    while let Some(at) = stack.pop() {
        let node = &tree.nodes[at as usize];
        for lane in Bits(probe.meets(simd, node)) {
            visit(node.child[lane], &mut stack, out);
        }
    }
}

/// A node against itself, and all below it.
#[inline(always)]
fn itself<S: Simd>(simd: S, tree: &Tree, root: u32, out: &mut Vec<Pair>) {
    let mut nodes = Stack::new(Some(root));
    let mut stack = Stack::new(None);
    while let Some(at) = nodes.pop() {
        let node = &tree.nodes[at as usize];
        for lane in node.lanes() {
            if node.child[lane] & LEAF == 0 {
                nodes.push(node.child[lane]);
            }
            let later = !0 << (lane + 1);
            against(simd, (node, lane), (node, later), &mut stack, out);
        }
        between(simd, tree, tree, &mut stack, out);
    }
}

/// A tree against another.
#[inline(always)]
fn each_other<S: Simd>(simd: S, (one, a): (&Tree, u32), (other, b): (&Tree, u32), out: &mut Vec<Pair>) {
    let mut stack = Stack::new(None);
    stack.push((a, b));
    between(simd, one, other, &mut stack, out);
}

/// Whatever the stack holds, a child of `one` and a child of `other` at a time, until it is empty.
#[inline(always)]
fn between<S: Simd>(simd: S, one: &Tree, other: &Tree, stack: &mut Stack<Pair>, out: &mut Vec<Pair>) {
    while let Some((a, b)) = stack.pop() {
        match (a & LEAF == 0, b & LEAF == 0) {
            (true, true) => {
                let (node, with) = (&one.nodes[a as usize], &other.nodes[b as usize]);
                for lane in node.lanes() {
                    against(simd, (node, lane), (with, !0), stack, out);
                }
            }
            (false, _) => {
                let with = &other.nodes[b as usize];
                let probe = Probe::new(simd, &one.fat[(a & !LEAF) as usize]);
                for j in Bits(probe.meets(simd, with)) {
                    meet(a, with.child[j], stack, out);
                }
            }
            (true, false) => {
                let node = &one.nodes[a as usize];
                let probe = Probe::new(simd, &other.fat[(b & !LEAF) as usize]);
                for lane in Bits(probe.meets(simd, node)) {
                    meet(node.child[lane], b, stack, out);
                }
            }
        }
    }
}

/// One lane of `node` against the lanes of `other` that `lanes` names.
#[inline(always)]
fn against<S: Simd>(
    simd: S,
    (node, lane): (&Node, usize),
    (other, lanes): (&Node, u32),
    stack: &mut Stack<Pair>,
    out: &mut Vec<Pair>,
) {
    let probe = Probe::new(simd, &node.get(lane));
    for j in Bits(probe.meets(simd, other) & lanes) {
        meet(node.child[lane], other.child[j], stack, out);
    }
}

/// Two children that overlap: a pair, or something to look into.
#[inline(always)]
fn meet(a: u32, b: u32, stack: &mut Stack<Pair>, out: &mut Vec<Pair>) {
    if a & b & LEAF == 0 {
        stack.push((a, b));
    } else {
        out.push(pair(a & !LEAF, b & !LEAF));
    }
}
