//! The overlapping fat boxes, kept from update to update.
//!
//! Two fat boxes that have not changed overlap as before. So only keys that changed ask the trees; the old list loses what no
//! longer overlaps, what is new is sorted and merged in. Where a quarter has changed, walking the trees whole is cheaper.
//! Either way the list is the set of all overlapping fat boxes, in ascending order.

use super::Tree;
use crate::collide::broad::{Pair, PairSort, bytes, pair};

/// Pairs of keys whose fat boxes overlap: of one moving tree, and between it and any number of fixed ones.
#[derive(Clone, Debug, Default)]
pub struct Pairs {
    all: Vec<Pair>,
    gained: Vec<Pair>,
    lost: Vec<Pair>,
    next: Vec<Pair>,
    found: Vec<u32>,
    sort: PairSort,
}

impl Pairs {
    /// All pairs, in ascending order.
    pub fn all(&self) -> &[Pair] {
        &self.all
    }
    /// Those that the last update added, in ascending order.
    pub fn gained(&self) -> &[Pair] {
        &self.gained
    }
    /// Those that the last update took away, in ascending order.
    pub fn lost(&self) -> &[Pair] {
        &self.lost
    }
    /// Memory in use \[bytes\].
    pub fn memory(&self) -> usize {
        let lists = [&self.all, &self.gained, &self.lost, &self.next];
        lists.into_iter().map(bytes).sum::<usize>() + bytes(&self.found) + self.sort.memory()
    }

    /// Brings the list up to date with every change that the trees list; call [`Tree::forget_changes`] on each afterwards.
    ///
    /// # Panics
    /// If the trees have different origins.
    pub fn update(&mut self, moving: &Tree, fixed: &[&Tree]) {
        let fixed_changes: usize = fixed.iter().map(|tree| tree.changes().len()).sum();
        self.gained.clear();
        self.lost.clear();
        if moving.changes().is_empty() && fixed_changes == 0 {
            return;
        }
        // A fixed key asks the moving tree only, and there are far more of them.
        if moving.changes().len() * 4 > moving.len() || fixed_changes > moving.len() {
            self.walk_whole(moving, fixed);
        } else {
            self.ask_for_changes(moving, fixed);
        }
    }

    fn walk_whole(&mut self, moving: &Tree, fixed: &[&Tree]) {
        self.next.clear();
        moving.pairs_within(&mut self.next);
        for tree in fixed {
            moving.pairs_between(tree, &mut self.next);
        }
        self.sort.sort(&mut self.next);
        difference(&self.next, &self.all, &mut self.gained);
        difference(&self.all, &self.next, &mut self.lost);
        core::mem::swap(&mut self.all, &mut self.next);
    }

    fn ask_for_changes(&mut self, moving: &Tree, fixed: &[&Tree]) {
        let changed = |key| moving.has_changed(key) || fixed.iter().any(|tree| tree.has_changed(key));
        let overlap = |(i, j): Pair| {
            let of = |key| {
                fixed.iter().map(|tree| tree.fat(key)).fold(moving.fat(key), |a, b| if a.is_absent() { b } else { a })
            };
            of(i).meets(&of(j))
        };
        self.lost.extend(self.all.iter().filter(|&&(i, j)| (changed(i) || changed(j)) && !overlap((i, j))));
        self.next.clear();
        for &key in moving.changes() {
            for tree in core::iter::once(&moving).chain(fixed) {
                self.ask(key, moving, tree);
            }
        }
        for from in fixed {
            for &key in from.changes() {
                self.ask(key, from, moving);
            }
        }
        self.sort.sort(&mut self.next);
        // Two keys that both changed found each other twice.
        self.next.dedup();
        difference(&self.next, &self.all, &mut self.gained);
        self.next.clear();
        merge(&self.all, &self.lost, &self.gained, &mut self.next);
        core::mem::swap(&mut self.all, &mut self.next);
    }

    /// Everything in `tree` that overlaps the box `key` of `from`.
    fn ask(&mut self, key: u32, from: &Tree, tree: &Tree) {
        self.found.clear();
        tree.query_fat(&from.fat(key), &mut self.found);
        self.next.extend(self.found.iter().filter(|&&j| j != key).map(|&j| pair(key, j)));
    }
}

/// What of `a` is not in `b`; both ascending.
fn difference(a: &[Pair], b: &[Pair], out: &mut Vec<Pair>) {
    let mut b = b.iter().peekable();
    out.extend(a.iter().filter(|&pair| {
        while b.next_if(|&other| other < pair).is_some() {}
        b.peek() != Some(&pair)
    }));
}

/// `all` without `lost` and with `gained`; all three ascending.
fn merge(all: &[Pair], lost: &[Pair], gained: &[Pair], out: &mut Vec<Pair>) {
    let mut lost = lost.iter().peekable();
    let mut gained = gained.iter().peekable();
    for pair in all {
        while let Some(new) = gained.next_if(|&new| new < pair) {
            out.push(*new);
        }
        if lost.next_if_eq(&pair).is_none() {
            out.push(*pair);
        }
    }
    out.extend(gained);
}
