//! Which of n boxes overlap, without asking all n(n − 1)/2 pairs.
//!
//! Every structure of the course is here behind one trait, [`BroadPhase`], each in a file that opens with its idea; all give
//! the pairs that [`brute::Brute`] gives, on any input. The engine itself uses the tree of [`tree`] without the trait, which
//! hands over every box at every update: a world knows which of them moved.

pub mod brute;
pub mod sweep;
pub mod sweep3;
mod lattice;
mod listing;
pub mod grid;
pub mod hashed;
pub mod hierarchical;
pub mod octree;
pub mod kd;
pub mod tree;
#[cfg(test)]
mod tests;

use super::bounds::{Aabb, Ray};

/// Two keys, the lower first.
pub type Pair = (u32, u32);

/// A structure that finds overlapping boxes.
///
/// The key of a box is its index. A box that is not valid ([`Aabb::is_valid`]) is in no answer. Every answer replaces what its
/// vector held, is in ascending order, and names nothing twice.
pub trait BroadPhase {
    /// Takes the boxes as they are now, at most 2³¹ of them.
    fn update(&mut self, boxes: &[Aabb]);
    /// Every two boxes that overlap.
    fn pairs(&mut self, out: &mut Vec<Pair>);
    /// Every box that overlaps `region`.
    fn query(&self, region: &Aabb, out: &mut Vec<u32>);
    /// Every box that `ray` goes through.
    fn ray(&self, ray: &Ray, out: &mut Vec<u32>);
    /// Memory in use \[bytes\], what is reserved included.
    fn memory(&self) -> usize;
}

/// The structures, for study and comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Structure {
    /// [`brute::Brute`].
    Brute,
    /// [`sweep::Sweep`].
    Sweep,
    /// [`sweep3::Sweep3`].
    Sweep3,
    /// [`grid::Grid`].
    Grid,
    /// [`hashed::Hashed`].
    Hashed,
    /// [`hierarchical::Hierarchical`].
    Hierarchical,
    /// [`octree::Octree`].
    Octree,
    /// [`kd::Kd`].
    Kd,
    /// [`tree::phase::Phase`].
    Tree,
}

impl Structure {
    /// All of them.
    pub const ALL: [Self; 9] = [
        Self::Brute,
        Self::Sweep,
        Self::Sweep3,
        Self::Grid,
        Self::Hashed,
        Self::Hierarchical,
        Self::Octree,
        Self::Kd,
        Self::Tree,
    ];
    /// Its name in tables: `sweep (1 axis)`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Brute => "brute force",
            Self::Sweep => "sweep (1 axis)",
            Self::Sweep3 => "sweep (3 axes)",
            Self::Grid => "uniform grid",
            Self::Hashed => "hashed grid",
            Self::Hierarchical => "hierarchical grid",
            Self::Octree => "loose octree",
            Self::Kd => "k-d tree",
            Self::Tree => "tree",
        }
    }
    /// An empty one.
    pub fn create(self) -> Box<dyn BroadPhase> {
        match self {
            Self::Brute => Box::new(brute::Brute::default()),
            Self::Sweep => Box::new(sweep::Sweep::default()),
            Self::Sweep3 => Box::new(sweep3::Sweep3::default()),
            Self::Grid => Box::new(grid::Grid::default()),
            Self::Hashed => Box::new(hashed::Hashed::default()),
            Self::Hierarchical => Box::new(hierarchical::Hierarchical::default()),
            Self::Octree => Box::new(octree::Octree::default()),
            Self::Kd => Box::new(kd::Kd::default()),
            Self::Tree => Box::new(tree::phase::Phase::default()),
        }
    }
}

/// The pair of two different keys.
#[inline]
pub(crate) fn pair(i: u32, j: u32) -> Pair {
    if i < j { (i, j) } else { (j, i) }
}

/// Sorts pairs by counting: each goes to the group of its first key, then each group is sorted by the second.
#[derive(Clone, Debug, Default)]
pub(crate) struct PairSort {
    /// Where the group of each key ends; while groups are filled, where its next pair goes.
    ends: Vec<u32>,
    room: Vec<Pair>,
}

impl PairSort {
    pub(crate) fn sort(&mut self, pairs: &mut Vec<Pair>) {
        let n_keys = pairs.iter().map(|&(i, _)| i as usize + 1).max().unwrap_or(0);
        if pairs.len() < n_keys / 8 || u32::try_from(pairs.len()).is_err() {
            return pairs.sort_unstable();
        }
        self.ends.clear();
        self.ends.resize(n_keys, 0);
        for &(i, _) in pairs.iter() {
            self.ends[i as usize] += 1;
        }
        let mut before = 0;
        for end in &mut self.ends {
            let count = core::mem::replace(end, before);
            before += count;
        }
        self.room.clear();
        self.room.resize(pairs.len(), (0, 0));
        for &pair in pairs.iter() {
            let next = &mut self.ends[pair.0 as usize];
            self.room[*next as usize] = pair;
            *next += 1;
        }
        let mut first = 0;
        for &end in &self.ends {
            self.room[first..end as usize].sort_unstable();
            first = end as usize;
        }
        core::mem::swap(pairs, &mut self.room);
    }
    pub(crate) fn memory(&self) -> usize {
        bytes(&self.ends) + bytes(&self.room)
    }
}

/// Keys of the valid boxes, in order, into `keys`.
fn valid_keys(boxes: &[Aabb], keys: &mut Vec<u32>) {
    keys.clear();
    keys.extend(boxes.iter().enumerate().filter(|(_, b)| b.is_valid()).map(|(i, _)| i as u32));
}

/// Bytes behind a vector.
pub(crate) fn bytes<T>(v: &Vec<T>) -> usize {
    v.capacity() * size_of::<T>()
}
