//! The tree behind the trait of the study set: one moving tree, its fat pairs refused by the exact boxes.

use super::pairs::Pairs;
use super::{Margin, Tree, middle};
use crate::collide::bounds::{Aabb, Ray};
use crate::collide::broad::{BroadPhase, Pair, bytes};
use crate::math::Vec3;

/// The engine's tree as a [`BroadPhase`].
#[derive(Clone, Debug, Default)]
pub struct Phase {
    tree: Tree,
    pairs: Pairs,
    boxes: Vec<Aabb>,
}

impl Phase {
    /// The tree inside.
    pub fn tree(&self) -> &Tree {
        &self.tree
    }
}

impl BroadPhase for Phase {
    fn update(&mut self, boxes: &[Aabb]) {
        if self.boxes.len() == boxes.len() {
            for (key, (new, old)) in boxes.iter().zip(&self.boxes).enumerate() {
                let went = if new.is_finite() && old.is_finite() { new.center() - old.center() } else { Vec3::ZERO };
                self.tree.place(key as u32, new, went);
            }
            self.tree.mend();
        } else {
            self.tree = Tree::new(middle(boxes), Margin::default());
            self.pairs = Pairs::default();
            self.tree.build(boxes);
        }
        self.boxes.clear();
        self.boxes.extend_from_slice(boxes);
    }
    fn pairs(&mut self, out: &mut Vec<Pair>) {
        self.pairs.update(&self.tree, &[]);
        self.tree.forget_changes();
        out.clear();
        let overlap = |&&(i, j): &&Pair| self.boxes[i as usize].meets(&self.boxes[j as usize]);
        out.extend(self.pairs.all().iter().filter(overlap));
    }
    fn query(&self, region: &Aabb, out: &mut Vec<u32>) {
        out.clear();
        self.tree.query(region, out);
        out.retain(|&i| self.boxes[i as usize].overlaps(region));
        out.sort_unstable();
    }
    fn ray(&self, ray: &Ray, out: &mut Vec<u32>) {
        out.clear();
        self.tree.query_ray(ray, out);
        out.retain(|&i| self.boxes[i as usize].ray(ray).is_some());
        out.sort_unstable();
    }
    fn memory(&self) -> usize {
        self.tree.memory() + self.pairs.memory() + bytes(&self.boxes)
    }
}
