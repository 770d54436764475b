//! Brute force: every pair is asked. Time n²/2, no structure, no case that is worse than another.
//!
//! Below some fifty boxes nothing is faster, and at any n it is the oracle that the other structures are tested against.

use super::{Aabb, BroadPhase, Pair, Ray, bytes, valid_keys};

/// All boxes, in a row.
#[derive(Clone, Debug, Default)]
pub struct Brute {
    boxes: Vec<Aabb>,
    keys: Vec<u32>,
}

impl BroadPhase for Brute {
    fn update(&mut self, boxes: &[Aabb]) {
        self.boxes.clear();
        self.boxes.extend_from_slice(boxes);
        valid_keys(boxes, &mut self.keys);
    }
    fn pairs(&mut self, out: &mut Vec<Pair>) {
        out.clear();
        for (n, &i) in self.keys.iter().enumerate() {
            let a = self.boxes[i as usize];
            let overlapping = self.keys[n + 1..].iter().filter(|&&j| a.meets(&self.boxes[j as usize]));
            out.extend(overlapping.map(|&j| (i, j)));
        }
    }
    fn query(&self, region: &Aabb, out: &mut Vec<u32>) {
        out.clear();
        out.extend(self.keys.iter().filter(|&&i| self.boxes[i as usize].overlaps(region)));
    }
    fn ray(&self, ray: &Ray, out: &mut Vec<u32>) {
        out.clear();
        out.extend(self.keys.iter().filter(|&&i| self.boxes[i as usize].ray(ray).is_some()));
    }
    fn memory(&self) -> usize {
        bytes(&self.boxes) + bytes(&self.keys)
    }
}
