//! Sweep and prune along three axes, kept from update to update (Cohen, Lin, Manocha and Ponamgi 1995; Ericson 2005, §7.5.1).
//!
//! ```text
//! on each axis, a list of all 2n ends of intervals, nearly sorted by the last update
//! insertion sort; when the start of a passes the end of b downwards, they may begin to overlap: add the pair if they do;
//!                 when the end of a passes the start of b downwards, they are apart: remove the pair
//! ```
//!
//! After a small motion few ends have passed each other, and a scene at rest costs 6n comparisons. The price: a body that
//! crosses a crowd passes every end on its way, though nothing is near, and inserting is dear. Where ends pass by the
//! thousand, all is sorted and swept anew.

use super::sweep::Sweep;
use super::{Aabb, BroadPhase, Pair, Ray, bytes, pair};

/// One end of the interval of a box on one axis.
#[derive(Clone, Copy, Debug)]
struct End {
    at: f64,
    /// Twice the key, plus one for the greater end: at equal coordinates lesser ends go first, for boxes are closed.
    what: u32,
}

impl End {
    fn is_greater_end(self) -> bool {
        self.what & 1 == 1
    }
    fn key(self) -> u32 {
        self.what >> 1
    }
    /// Whether this end belongs after `other`.
    fn is_after(self, other: Self) -> bool {
        self.at > other.at || (self.at == other.at && self.is_greater_end() && !other.is_greater_end())
    }
}

/// A set of pairs in a table: linear probing, removal by moving back what follows (Knuth 6.4, algorithm R).
#[derive(Clone, Debug, Default)]
struct PairSet {
    /// A power of two; `VACANT` or the two keys.
    slots: Vec<u64>,
    len: usize,
}

/// No pair: the lower key comes first, so the two are never equal.
const VACANT: u64 = u64::MAX;

impl PairSet {
    fn home(&self, item: u64) -> usize {
        (item.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32) as usize & (self.slots.len() - 1)
    }
    /// Where `item` is, or the vacant slot where it would go.
    fn find(&self, item: u64) -> usize {
        let mut at = self.home(item);
        while self.slots[at] != item && self.slots[at] != VACANT {
            at = (at + 1) & (self.slots.len() - 1);
        }
        at
    }
    fn insert(&mut self, (i, j): Pair) {
        if 2 * (self.len + 1) > self.slots.len() {
            let size = (4 * (self.len + 1)).next_power_of_two();
            let old = core::mem::replace(&mut self.slots, vec![VACANT; size]);
            for item in old.into_iter().filter(|&item| item != VACANT) {
                let at = self.find(item);
                self.slots[at] = item;
            }
        }
        let item = u64::from(i) << 32 | u64::from(j);
        let at = self.find(item);
        self.len += usize::from(self.slots[at] == VACANT);
        self.slots[at] = item;
    }
    fn remove(&mut self, (i, j): Pair) {
        if self.len == 0 {
            return;
        }
        let mut hole = self.find(u64::from(i) << 32 | u64::from(j));
        if self.slots[hole] == VACANT {
            return;
        }
        self.len -= 1;
        let mask = self.slots.len() - 1;
        let mut at = hole;
        loop {
            at = (at + 1) & mask;
            let item = self.slots[at];
            if item == VACANT {
                break;
            }
            // It may fill the hole if its home does not lie behind the hole.
            if (at.wrapping_sub(self.home(item)) & mask) >= (at.wrapping_sub(hole) & mask) {
                self.slots[hole] = item;
                hole = at;
            }
        }
        self.slots[hole] = VACANT;
    }
    fn clear(&mut self) {
        self.slots.fill(VACANT);
        self.len = 0;
    }
    fn pairs(&self) -> impl Iterator<Item = Pair> + '_ {
        self.slots.iter().filter(|&&item| item != VACANT).map(|&item| ((item >> 32) as u32, item as u32))
    }
}

/// Three sorted lists of ends, and the pairs they imply.
#[derive(Clone, Debug, Default)]
pub struct Sweep3 {
    boxes: Vec<Aabb>,
    ends: [Vec<End>; 3],
    set: PairSet,
    /// For the first sweep, and for the queries.
    sweep: Sweep,
    first_pairs: Vec<Pair>,
}

impl Sweep3 {
    /// Mends the order on one axis and the set of pairs with it; `false` if too many ends pass each other.
    fn mend(&mut self, axis: usize) -> bool {
        let Self { boxes, ends, set, .. } = self;
        let ends = &mut ends[axis];
        for end in ends.iter_mut() {
            let b = &boxes[end.key() as usize];
            end.at = if end.is_greater_end() { b.max[axis] } else { b.min[axis] };
        }
        let mut swaps_left = 16 * ends.len();
        for n in 1..ends.len() {
            let (moving, mut at) = (ends[n], n);
            while at > 0 && ends[at - 1].is_after(moving) {
                let passed = ends[at - 1];
                match (moving.is_greater_end(), passed.is_greater_end()) {
                    (false, true) if boxes[moving.key() as usize].meets(&boxes[passed.key() as usize]) => {
                        set.insert(pair(moving.key(), passed.key()));
                    }
                    (true, false) => set.remove(pair(moving.key(), passed.key())),
                    _ => {}
                }
                ends[at] = passed;
                at -= 1;
            }
            ends[at] = moving;
            swaps_left = swaps_left.saturating_sub(n - at);
            if swaps_left == 0 {
                return false;
            }
        }
        true
    }
    /// Sorts and sweeps without regard to what was.
    fn restart(&mut self) {
        for axis in 0..3 {
            let ends = &mut self.ends[axis];
            ends.clear();
            for (key, b) in self.boxes.iter().enumerate().filter(|(_, b)| b.is_valid()) {
                let what = 2 * key as u32;
                ends.extend([End { at: b.min[axis], what }, End { at: b.max[axis], what: what + 1 }]);
            }
            // +0 makes −0 and 0 the same place.
            ends.sort_unstable_by(|a, b| (a.at + 0.0).total_cmp(&(b.at + 0.0)).then((a.what & 1).cmp(&(b.what & 1))));
        }
        self.set.clear();
        self.sweep.update(&self.boxes);
        self.sweep.pairs(&mut self.first_pairs);
        for &pair in &self.first_pairs {
            self.set.insert(pair);
        }
    }
}

impl BroadPhase for Sweep3 {
    fn update(&mut self, boxes: &[Aabb]) {
        let same =
            self.boxes.len() == boxes.len() && self.boxes.iter().zip(boxes).all(|(a, b)| a.is_valid() == b.is_valid());
        self.boxes.clear();
        self.boxes.extend_from_slice(boxes);
        if !same || !(0..3).all(|axis| self.mend(axis)) {
            self.restart();
        }
    }
    fn pairs(&mut self, out: &mut Vec<Pair>) {
        out.clear();
        out.extend(self.set.pairs());
        out.sort_unstable();
    }
    fn query(&self, region: &Aabb, out: &mut Vec<u32>) {
        out.clear();
        if !region.is_valid() {
            return;
        }
        // The lists say who starts before the region ends; who of them has not ended before it must be asked.
        let starts = |axis: usize| self.ends[axis].partition_point(|end| end.at <= region.max[axis]);
        let axis = (1..3).fold(0, |best, axis| if starts(axis) < starts(best) { axis } else { best });
        let before = self.ends[axis][..starts(axis)].iter().filter(|end| !end.is_greater_end());
        out.extend(before.map(|end| end.key()).filter(|&i| self.boxes[i as usize].meets(region)));
        out.sort_unstable();
    }
    fn ray(&self, ray: &Ray, out: &mut Vec<u32>) {
        out.clear();
        let starts = self.ends[0].iter().filter(|end| !end.is_greater_end());
        out.extend(starts.map(|end| end.key()).filter(|&i| self.boxes[i as usize].ray(ray).is_some()));
        out.sort_unstable();
    }
    fn memory(&self) -> usize {
        let ends = self.ends.iter().map(bytes).sum::<usize>();
        ends + bytes(&self.boxes) + bytes(&self.set.slots) + bytes(&self.first_pairs) + self.sweep.memory()
    }
}
