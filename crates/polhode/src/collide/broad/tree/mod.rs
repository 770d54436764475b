//! The tree of the engine: eight boxes a node, fat leaves, mended where something moved.
//!
//! ```text
//!                    ┌───────────────────────────────┐
//!                    │ A B C D E F G H   8 boxes f32 │   one box against eight: six comparisons
//!                    └─┬─┬─┬─────────────────────────┘
//!          ┌───────────┘ │ └── a box (its key)
//!  ┌───────┴───────┐ ┌───┴───────────┐
//!  │ A0 A1 …       │ │ B0 B1 …       │
//!  └───────────────┘ └───────────────┘
//! ```
//!
//! A leaf's box is *fat*: larger than what it holds, and drawn out ahead of its motion. While the box stays inside, [`Tree::place`]
//! does nothing. When it leaves, its lane and the lanes above are set anew, and the nodes on the way are marked; when a quarter
//! of the boxes has moved so, [`Tree::mend`] takes the marked nodes apart and builds their place anew from the clean subtrees
//! below, so that what rests is never touched. Inserting, removing and moving take time log n; building n log n.
//!
//! Fixed, kinematic and moving things go into trees of their own, all keys distinct: fixed things never meet each other and
//! are not asked. [`pairs::Pairs`] keeps the overlapping fat boxes between updates. No list has a limit, so no pair is lost.

mod build;
mod node;
pub mod pairs;
pub mod phase;
mod walk;
#[cfg(test)]
mod tests;

use super::bytes;
use crate::collide::bounds::Aabb;
use crate::math::Vec3;
use build::{Item, Part, divide};
use node::{Box32, KEYS, LANES, LEAF, NONE, Node};

/// How much larger a leaf is than what it holds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Margin {
    /// On every side \[m\]; 0.
    pub distance: f64,
    /// On every side, as a share of the box's least edge; 0.1.
    pub share: f64,
    /// Ahead, as a multiple of the displacement that [`Tree::place`] is told; 4.
    pub ahead: f64,
}

impl Default for Margin {
    fn default() -> Self {
        Self { distance: 0.0, share: 0.1, ahead: 4.0 }
    }
}

impl Margin {
    /// No margin: for what does not move.
    pub const NONE: Self = Self { distance: 0.0, share: 0.0, ahead: 0.0 };

    fn fatten(&self, b: &Aabb, displacement: Vec3) -> Aabb {
        let size = b.size();
        let least = size.x.min(size.y).min(size.z);
        let side = self.distance + if least.is_finite() { self.share * least } else { 0.0 };
        let ahead = self.ahead * displacement;
        let fat = b.expanded(side);
        if ahead.is_finite() { fat.swept(ahead) } else { fat }
    }
}

/// A dynamic tree of boxes with keys below 2³¹ − 1.
#[derive(Clone, Debug, Default)]
pub struct Tree {
    margin: Margin,
    /// All boxes are relative to this point \[m\].
    origin: Vec3,
    nodes: Vec<Node>,
    free: Vec<u32>,
    /// The topmost node, if there is any box.
    root: Option<u32>,
    /// The fat box of each key; NaN where there is none.
    fat: Vec<Box32>,
    /// Where each key is: node times [`LANES`] plus lane, or [`NONE`].
    home: Vec<u32>,
    len: usize,
    /// Leaves inserted or moved since the tree was last mended.
    restless: usize,
    /// Whether a leaf went deeper than a tree of this size should be.
    too_deep: bool,
    /// Keys whose fat box has changed since [`Tree::forget_changes`]; the flag of each keeps it from being listed twice.
    changed: Vec<u32>,
    is_changed: Vec<bool>,
    items: Vec<Item>,
    stack: Vec<u32>,
}

impl Tree {
    /// An empty tree around `origin` \[m\], a point among what it will hold: boxes are kept to 6e-8 of the distance from it.
    pub fn new(origin: Vec3, margin: Margin) -> Self {
        Self { margin, origin, ..Self::default() }
    }
    /// The point that its boxes are relative to \[m\].
    pub fn origin(&self) -> Vec3 {
        self.origin
    }
    /// The number of boxes.
    pub fn len(&self) -> usize {
        self.len
    }
    /// Whether there is no box.
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }
    /// Whether there is a box with this key.
    pub fn holds(&self, key: u32) -> bool {
        self.home.get(key as usize).is_some_and(|&home| home != NONE)
    }
    /// The nodes, their mean number of lanes in use, and the levels: what a query walks through.
    pub fn shape(&self) -> (usize, f64, usize) {
        let (mut nodes, mut lanes, mut levels) = (0_usize, 0_usize, 0);
        let mut stack: Vec<(u32, usize)> = self.root.iter().map(|&root| (root, 1)).collect();
        while let Some((at, level)) = stack.pop() {
            let node = &self.nodes[at as usize];
            nodes += 1;
            levels = levels.max(level);
            for lane in node.lanes() {
                lanes += 1;
                if node.child[lane] & LEAF == 0 {
                    stack.push((node.child[lane], level + 1));
                }
            }
        }
        (nodes, lanes as f64 / nodes.max(1) as f64, levels)
    }
    /// Memory in use \[bytes\].
    pub fn memory(&self) -> usize {
        let keyed = bytes(&self.fat) + bytes(&self.home) + bytes(&self.changed) + bytes(&self.is_changed);
        keyed + bytes(&self.nodes) + bytes(&self.free) + bytes(&self.items) + bytes(&self.stack)
    }

    /// Replaces everything by `boxes`, keyed by index; boxes that are not valid are left out.
    ///
    /// # Panics
    /// If there are more than 2³¹ − 1.
    pub fn build(&mut self, boxes: &[Aabb]) {
        assert!(boxes.len() <= KEYS as usize, "a tree has keys below {KEYS}");
        for key in 0..self.home.len() as u32 {
            if self.holds(key) {
                self.note(key);
            }
        }
        self.nodes.clear();
        self.free.clear();
        self.items.clear();
        self.fat.fill(Box32::ABSENT);
        self.home.fill(NONE);
        self.grow(boxes.len());
        self.len = 0;
        for (key, b) in boxes.iter().enumerate().filter(|(_, b)| b.is_valid()) {
            self.fat[key] = Box32::outward(&self.margin.fatten(b, Vec3::ZERO), self.origin);
            self.items.push(Item { bounds: self.fat[key], child: key as u32 | LEAF });
            self.note(key as u32);
            self.len += 1;
        }
        self.plant();
    }

    /// Puts the box `key` where it is now: inserts it, moves it, or, if `b` is not valid, removes it.
    ///
    /// `displacement` \[m\] is how far it goes in the time to the next call. Says whether its fat box changed.
    ///
    /// # Panics
    /// If `key` is not below 2³¹ − 1.
    pub fn place(&mut self, key: u32, b: &Aabb, displacement: Vec3) -> bool {
        assert!(key < KEYS, "a tree has keys below {KEYS}");
        if !b.is_valid() {
            return self.remove(key);
        }
        self.grow(key as usize + 1);
        let old = self.fat[key as usize];
        if self.holds(key) && old.contains(&Box32::outward(b, self.origin)) {
            // Inside; but a box that was fat for speed must not stay so at rest.
            let roomy = self.margin.fatten(b, displacement).expanded(self.slack(b));
            if Box32::outward(&roomy, self.origin).contains(&old) {
                return false;
            }
        }
        let fat = Box32::outward(&self.margin.fatten(b, displacement), self.origin);
        if old == fat {
            return false;
        }
        self.fat[key as usize] = fat;
        self.note(key);
        self.restless += 1;
        match self.home[key as usize] {
            NONE => {
                self.len += 1;
                self.attach(Item { bounds: fat, child: key | LEAF });
            }
            home => self.shift(key, home, &fat),
        }
        true
    }

    /// Removes the box `key`, and says whether there was one.
    pub fn remove(&mut self, key: u32) -> bool {
        if !self.holds(key) {
            return false;
        }
        self.detach(self.home[key as usize]);
        self.home[key as usize] = NONE;
        self.fat[key as usize] = Box32::ABSENT;
        self.note(key);
        self.len -= 1;
        true
    }

    /// Builds anew what has become loose, once enough of it has; call it once a step, after the boxes are placed.
    pub fn mend(&mut self) {
        if self.restless * 4 <= self.len + 64 && !self.too_deep {
            return;
        }
        let Some(root) = self.root else { return };
        // Clean subtrees of any depth count as one item each, so that mending upon mending may make the tree deep: then all of it
        // is taken apart.
        let whole = self.nodes[root as usize].height > self.most_levels();
        self.items.clear();
        self.stack.clear();
        self.stack.push(root);
        while let Some(at) = self.stack.pop() {
            let node = &self.nodes[at as usize];
            for lane in 0..LANES {
                let child = node.child[lane];
                if child != NONE && child & LEAF == 0 && (whole || self.nodes[child as usize].stirred) {
                    self.stack.push(child);
                } else if child != NONE {
                    self.items.push(Item { bounds: node.get(lane), child });
                }
            }
            self.free.push(at);
        }
        self.plant();
    }

    /// Keys whose fat box is new, changed or gone since the last [`Tree::forget_changes`], in order of their change.
    pub fn changes(&self) -> &[u32] {
        &self.changed
    }
    /// Starts a new list of changes.
    pub fn forget_changes(&mut self) {
        for key in self.changed.drain(..) {
            self.is_changed[key as usize] = false;
        }
    }
    fn note(&mut self, key: u32) {
        if !self.is_changed[key as usize] {
            self.is_changed[key as usize] = true;
            self.changed.push(key);
        }
    }
    /// Whether the fat box of `key` is in the list of changes.
    fn has_changed(&self, key: u32) -> bool {
        self.is_changed.get(key as usize).is_some_and(|&c| c)
    }
    /// The fat box of `key`; NaN if there is none.
    fn fat(&self, key: u32) -> Box32 {
        self.fat.get(key as usize).copied().unwrap_or(Box32::ABSENT)
    }
    /// How much too large a fat box may be before it is made anew \[m\].
    fn slack(&self, b: &Aabb) -> f64 {
        let size = b.size();
        let least = size.x.min(size.y).min(size.z);
        4.0 * self.margin.distance + if least.is_finite() { 4.0 * self.margin.share * least } else { 0.0 }
    }
    /// How many levels are let be; a full tree has log₈ n.
    fn most_levels(&self) -> u32 {
        6 + 2 * (self.len.max(1).ilog2() / 3)
    }
    fn grow(&mut self, keys: usize) {
        if self.home.len() < keys {
            self.home.resize(keys, NONE);
            self.fat.resize(keys, Box32::ABSENT);
            self.is_changed.resize(keys, false);
        }
    }

    /// Makes a tree of the items: the root and every new node below it.
    fn plant(&mut self) {
        self.restless = 0;
        self.too_deep = false;
        let mut items = core::mem::take(&mut self.items);
        let whole = Part::whole(&items);
        self.root = (!items.is_empty()).then(|| self.plant_part(&mut items, whole));
        self.items = items;
    }

    /// A cut leaves at most 15/16 of the axis it divides, and f32 has finitely many halvings: the depth is some hundreds at most.
    fn plant_part(&mut self, items: &mut [Item], whole: Part) -> u32 {
        let at = self.allocate();
        let parts = divide(items, whole);
        for (lane, part) in parts.part[..parts.count].iter().enumerate() {
            let child = if part.len() == 1 { items[part.first].child } else { self.plant_part(items, *part) };
            self.put(at, lane, Item { bounds: part.bounds, child });
            if child & LEAF == 0 {
                let below = self.nodes[child as usize].height;
                let height = &mut self.nodes[at as usize].height;
                *height = (*height).max(below + 1);
            }
        }
        at
    }

    fn allocate(&mut self) -> u32 {
        if let Some(at) = self.free.pop() {
            self.nodes[at as usize] = Node::VACANT;
            return at;
        }
        self.nodes.push(Node::VACANT);
        self.nodes.len() as u32 - 1
    }

    /// Sets a lane and tells the child where it is.
    fn put(&mut self, at: u32, lane: usize, item: Item) {
        let node = &mut self.nodes[at as usize];
        node.set(lane, &item.bounds);
        node.child[lane] = item.child;
        let place = at * LANES as u32 + lane as u32;
        if item.child & LEAF == 0 {
            self.nodes[item.child as usize].parent = place;
        } else {
            self.home[(item.child & !LEAF) as usize] = place;
        }
    }

    /// Inserts a leaf where it adds the least surface.
    fn attach(&mut self, leaf: Item) {
        let Some(mut at) = self.root else {
            let root = self.allocate();
            self.put(root, 0, leaf);
            self.root = Some(root);
            return;
        };
        let mut level = 1;
        loop {
            level += 1;
            self.too_deep |= level > self.most_levels();
            let node = &mut self.nodes[at as usize];
            node.stirred = true;
            let (lane, growth) = cheapest_lane(node, &leaf.bounds);
            let (bounds, child) = (node.get(lane), node.child[lane]);
            let free = node.free_lane();
            let is_leaf = child & LEAF != 0;
            // A lane of its own costs the leaf's own surface.
            if let Some(free) = free.filter(|_| is_leaf || growth > leaf.bounds.half_area()) {
                return self.put(at, free, leaf);
            }
            let merged = bounds.merged(&leaf.bounds);
            if is_leaf {
                let both = self.allocate();
                self.nodes[both as usize].stirred = true;
                self.put(both, 0, Item { bounds, child });
                self.put(both, 1, leaf);
                return self.put(at, lane, Item { bounds: merged, child: both });
            }
            node.set(lane, &merged);
            at = child;
        }
    }

    /// Takes away what is at `place`, and the nodes this leaves empty.
    fn detach(&mut self, place: u32) {
        let (mut at, mut lane) = (place / LANES as u32, place as usize % LANES);
        loop {
            let node = &mut self.nodes[at as usize];
            node.set(lane, &Box32::ABSENT);
            node.child[lane] = NONE;
            let parent = node.parent;
            if node.child != [NONE; LANES] {
                return self.refit(at);
            }
            self.free.push(at);
            if parent == NONE {
                self.root = None;
                return;
            }
            (at, lane) = (parent / LANES as u32, parent as usize % LANES);
        }
    }

    /// Gives the leaf at `place` its new box, there or, if that is far from its neighbours, elsewhere.
    fn shift(&mut self, key: u32, place: u32, fat: &Box32) {
        let (at, lane) = (place / LANES as u32, place as usize % LANES);
        let around = self.nodes[at as usize].union();
        if around.merged(fat).half_area() > 2.0 * around.half_area() {
            self.detach(place);
            return self.attach(Item { bounds: *fat, child: key | LEAF });
        }
        self.nodes[at as usize].set(lane, fat);
        self.refit(at);
    }

    /// Marks `at` and all above it, and sets their boxes from below as far up as one changes.
    fn refit(&mut self, mut at: u32) {
        let mut changing = true;
        loop {
            let node = &mut self.nodes[at as usize];
            let was_stirred = core::mem::replace(&mut node.stirred, true);
            let (parent, union) = (node.parent, if changing { node.union() } else { Box32::EMPTY });
            if parent == NONE || (was_stirred && !changing) {
                return;
            }
            at = parent / LANES as u32;
            let lane = parent as usize % LANES;
            if changing {
                let above = &mut self.nodes[at as usize];
                changing = above.get(lane) != union;
                above.set(lane, &union);
            }
        }
    }
}

/// The lane in use whose box grows least, and by how much; of equals the smaller box.
fn cheapest_lane(node: &Node, b: &Box32) -> (usize, f32) {
    let (mut best, mut least) = (0, (f32::INFINITY, f32::INFINITY));
    for lane in node.lanes() {
        let bounds = node.get(lane);
        let area = bounds.half_area();
        let cost = (bounds.merged(b).half_area() - area, area);
        if cost < least {
            (best, least) = (lane, cost);
        }
    }
    (best, least.0)
}

/// The mean of the centres of what is finite: a point among the boxes, so that f32 relative to it are as fine as can be.
pub fn middle(boxes: &[Aabb]) -> Vec3 {
    let centers = boxes.iter().filter(|b| b.is_finite() && b.is_valid()).map(Aabb::center);
    let (mut n, mut mean) = (0.0, Vec3::ZERO);
    for c in centers {
        n += 1.0;
        mean += (c - mean) / n;
    }
    mean
}
