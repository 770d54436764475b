//! Names of bodies that survive removals, and where their numbers are now.
//!
//! Bodies lie in dense arrays so that a stage is a loop over slices. The arrays are grouped: first every dynamic body, then
//! the kinematic, then the fixed, so that "all that moves" is a prefix. A body's place, its *slot*, changes when another
//! is removed; its [`BodyId`] does not.

/// The name of a body: stays valid until the body is removed, and is never given to another.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct BodyId {
    index: u32,
    generation: u32,
}

impl BodyId {
    /// The number of the body: dense, reused after a removal.
    pub fn index(self) -> usize {
        self.index as usize
    }
    /// How often the number had been used before.
    pub fn generation(self) -> u32 {
        self.generation / 2
    }
}

/// Which of the three groups of the dense arrays a body is in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Group {
    /// Moved by forces.
    Dynamic = 0,
    /// Moved as prescribed.
    Kinematic = 1,
    /// Not moved.
    Fixed = 2,
}

/// What has to happen to every dense array so that it follows an insertion or a removal: apply in order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Move {
    /// Slot to copy from.
    pub from: usize,
    /// Slot to copy to.
    pub to: usize,
}

/// The table from ids to slots and back.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Slots {
    /// Slot of each index, meaningful where the generation is alive (n_indices).
    slot_of: Vec<u32>,
    /// Current generation of each index; odd while alive (n_indices).
    generation: Vec<u32>,
    /// Indices to be used again, last first.
    free: Vec<u32>,
    /// The id in each slot (n_bodies).
    ids: Vec<BodyId>,
    /// First slot after each group.
    ends: [usize; 3],
}

impl Slots {
    /// Number of bodies.
    pub fn len(&self) -> usize {
        self.ids.len()
    }
    /// Whether there are no bodies.
    pub fn is_empty(&self) -> bool {
        self.ids.is_empty()
    }
    /// The slots of a group.
    pub fn group(&self, group: Group) -> core::ops::Range<usize> {
        let g = group as usize;
        (if g == 0 { 0 } else { self.ends[g - 1] })..self.ends[g]
    }
    /// The group of a slot.
    pub fn group_of(&self, slot: usize) -> Group {
        if slot < self.ends[0] {
            Group::Dynamic
        } else if slot < self.ends[1] {
            Group::Kinematic
        } else {
            Group::Fixed
        }
    }
    /// The ids in slot order (n_bodies).
    pub fn ids(&self) -> &[BodyId] {
        &self.ids
    }
    /// The slot of a body, or `None` if it was removed.
    pub fn slot(&self, id: BodyId) -> Option<usize> {
        let i = id.index as usize;
        (self.generation.get(i) == Some(&id.generation)).then(|| self.slot_of[i] as usize)
    }

    /// Makes room for a body at the end of its group. Every dense array has to take the new element at its end and then
    /// swap as the moves say, which brings it to the returned slot: see [`insert_into`].
    ///
    /// # Panics
    /// Above 2³² bodies.
    pub fn insert(&mut self, group: Group) -> (BodyId, usize, [Option<Move>; 2]) {
        let g = group as usize;
        let index = self.free.pop().unwrap_or_else(|| {
            let index = u32::try_from(self.generation.len()).expect("at most 2^32 bodies");
            self.generation.push(0);
            self.slot_of.push(0);
            index
        });
        // Generations of living bodies are odd.
        self.generation[index as usize] += 1;
        let id = BodyId { index, generation: self.generation[index as usize] };
        self.ids.push(id);
        let mut moves = [None; 2];
        for later in (g + 1..3).rev() {
            // The first of a later group goes to its end, which frees a slot at the end of the group before.
            let (from, to) = (self.ends[later - 1], self.ends[later]);
            self.ends[later] += 1;
            if from != to {
                moves[2 - later] = Some(Move { from, to });
                self.place(self.ids[from], to);
            }
        }
        let slot = self.ends[g];
        self.ends[g] += 1;
        self.place(id, slot);
        (id, slot, moves)
    }

    /// Removes a body. Every dense array has to follow the moves and then drop its last element.
    pub fn remove(&mut self, id: BodyId) -> Option<[Option<Move>; 3]> {
        let mut hole = self.slot(id)?;
        self.generation[id.index as usize] += 1;
        self.free.push(id.index);
        let mut moves = [None; 3];
        let group = self.group_of(hole) as usize;
        for g in group..3 {
            // The last of the group fills the hole; its old place is the hole of the next group.
            let last = self.ends[g] - 1;
            self.ends[g] -= 1;
            if last != hole {
                moves[g] = Some(Move { from: last, to: hole });
                self.place(self.ids[last], hole);
            }
            hole = last;
        }
        self.ids.pop();
        Some(moves)
    }

    fn place(&mut self, id: BodyId, slot: usize) {
        self.ids[slot] = id;
        self.slot_of[id.index as usize] = slot as u32;
    }
}

/// Follows [`Slots::insert`] in one dense array.
pub fn insert_into<T>(array: &mut Vec<T>, moves: [Option<Move>; 2], value: T) {
    array.push(value);
    for m in moves.into_iter().flatten() {
        array.swap(m.from, m.to);
    }
}

/// Follows [`Slots::remove`] in one dense array.
pub fn remove_from<T>(array: &mut Vec<T>, moves: [Option<Move>; 3]) {
    for m in moves.into_iter().flatten() {
        array.swap(m.from, m.to);
    }
    array.pop();
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// After any sequence of insertions and removals an array that followed the moves holds, in the slot of each
        /// id, what was inserted with it, and the groups are contiguous.
        #[test]
        fn arrays_follow_their_ids(ops in prop::collection::vec((0u8..4, any::<prop::sample::Index>()), 1..200)) {
            let mut slots = Slots::default();
            let mut array: Vec<(BodyId, Group)> = Vec::new();
            let mut alive: Vec<(BodyId, Group)> = Vec::new();
            let mut dead: Vec<BodyId> = Vec::new();
            for (op, pick) in ops {
                let group = match op { 0 => Group::Dynamic, 1 => Group::Kinematic, 2 => Group::Fixed, _ => {
                    if alive.is_empty() { continue; }
                    let (id, _) = alive.swap_remove(pick.index(alive.len()));
                    let moves = slots.remove(id).unwrap();
                    remove_from(&mut array, moves);
                    dead.push(id);
                    continue;
                }};
                let (id, slot, moves) = slots.insert(group);
                insert_into(&mut array, moves, (id, group));
                prop_assert_eq!(array[slot], (id, group));
                alive.push((id, group));
                prop_assert_eq!(slots.len(), alive.len());
                for &(id, group) in &alive {
                    let slot = slots.slot(id).unwrap();
                    prop_assert_eq!(array[slot], (id, group));
                    prop_assert_eq!(slots.ids()[slot], id);
                    prop_assert_eq!(slots.group_of(slot), group);
                    prop_assert!(slots.group(group).contains(&slot));
                }
                for &id in &dead {
                    prop_assert!(slots.slot(id).is_none());
                    prop_assert!(slots.remove(id).is_none());
                }
            }
        }
    }
}
