//! The tree on its own: keys that come and go, several trees, and what stays true of the nodes.

use super::node::{LANES, LEAF, NONE};
use super::pairs::Pairs;
use super::{Margin, Tree};
use crate::collide::bounds::Aabb;
use crate::collide::broad::{Pair, pair};
use crate::math::Vec3;

struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        // PCG's multiplier and increment; the upper bits are the good ones.
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
    fn below(&mut self, n: usize) -> usize {
        (self.unit() * n as f64) as usize
    }
    fn cube(&mut self, half: f64) -> Aabb {
        let mut at = || (2.0 * self.unit() - 1.0) * half;
        Aabb::centered(Vec3::new(at(), at(), at()), Vec3::splat(0.5))
    }
}

/// Every lane is the union of what is below it, every child knows its place, and every key is there once.
fn assert_sound(tree: &Tree) {
    let mut stack: Vec<u32> = tree.root.into_iter().collect();
    let mut keys = 0;
    while let Some(at) = stack.pop() {
        let node = &tree.nodes[at as usize];
        assert!(node.lanes().count() > 0, "a node without children");
        for lane in node.lanes() {
            let (child, place) = (node.child[lane], at * LANES as u32 + lane as u32);
            if child & LEAF == 0 {
                let below = &tree.nodes[child as usize];
                assert_eq!((below.parent, below.union()), (place, node.get(lane)));
                stack.push(child);
            } else {
                let key = (child & !LEAF) as usize;
                assert_eq!((tree.home[key], tree.fat[key]), (place, node.get(lane)));
                keys += 1;
            }
        }
    }
    assert_eq!(keys, tree.len());
    assert_eq!(keys, tree.home.iter().filter(|&&home| home != NONE).count());
}

/// The overlapping fat boxes, by asking all.
fn oracle(moving: &Tree, fixed: &[&Tree]) -> Vec<Pair> {
    let keys = |tree: &Tree| (0..tree.home.len() as u32).filter(|&i| tree.holds(i)).collect::<Vec<_>>();
    let mut all = Vec::new();
    for i in keys(moving) {
        all.extend(keys(moving).into_iter().filter(|&j| j > i && moving.fat(i).meets(&moving.fat(j))).map(|j| (i, j)));
        for tree in fixed {
            all.extend(keys(tree).into_iter().filter(|&j| moving.fat(i).meets(&tree.fat(j))).map(|j| pair(i, j)));
        }
    }
    all.sort_unstable();
    all
}

#[test]
fn keys_come_and_go_and_the_pairs_follow() {
    let random = &mut Random(5);
    let origin = Vec3::new(1.0, 2.0, 3.0);
    let mut trees =
        [Tree::new(origin, Margin::default()), Tree::new(origin, Margin::NONE), Tree::new(origin, Margin::NONE)];
    let mut pairs = Pairs::default();
    for step in 0..120 {
        // Few changes in most steps, many in some: both ways to update.
        let changes = if step % 10 == 0 { 150 } else { 6 };
        for _ in 0..changes {
            let key = random.below(300) as u32;
            let tree = &mut trees[key as usize % 3];
            match random.below(4) {
                0 => drop(tree.remove(key)),
                1 => drop(tree.place(key, &Aabb::EMPTY, Vec3::ZERO)),
                _ => drop(tree.place(key, &random.cube(4.0), Vec3::new(0.0, 0.0, 0.1))),
            }
        }
        trees.iter_mut().for_each(Tree::mend);
        let before = pairs.all().to_vec();
        let [moving, fixed @ ..] = &trees;
        pairs.update(moving, &[&fixed[0], &fixed[1]]);
        assert_eq!(pairs.all(), oracle(moving, &[&fixed[0], &fixed[1]]), "step {step}");
        let mut replayed: Vec<Pair> = before.into_iter().filter(|pair| !pairs.lost().contains(pair)).collect();
        replayed.extend(pairs.gained());
        replayed.sort_unstable();
        assert_eq!(replayed, pairs.all(), "step {step}: gained and lost");
        trees.iter_mut().for_each(Tree::forget_changes);
        trees.iter().for_each(assert_sound);
    }
}

#[test]
fn a_box_that_stays_in_its_fat_box_changes_nothing() {
    let mut tree = Tree::new(Vec3::ZERO, Margin { distance: 0.0, share: 0.1, ahead: 4.0 });
    let at = |x: f64| Aabb::centered(Vec3::new(x, 0.0, 0.0), Vec3::splat(0.5));
    let step = 0.02 * Vec3::X;
    assert!(tree.place(3, &at(0.0), step));
    tree.forget_changes();
    // 0.1 of the edge and four steps ahead: nine steps of 0.02 fit into 0.18.
    for i in 1..9 {
        assert!(!tree.place(3, &at(0.02 * f64::from(i)), step), "{i}");
    }
    assert!(tree.changes().is_empty());
    assert!(tree.place(3, &at(0.2), step));
    assert_eq!(tree.changes(), [3]);
    // It was fat for 10 m a step and comes to rest: it must not stay so.
    tree.place(3, &at(0.0), 10.0 * Vec3::X);
    assert!(tree.place(3, &at(0.0), Vec3::ZERO));
}

#[test]
fn any_order_of_insertion_gives_a_tree_of_few_levels() {
    // A line from one end to the other is the worst case of greedy insertion.
    let mut tree = Tree::new(Vec3::ZERO, Margin::NONE);
    for i in 0..5000_u32 {
        tree.place(i, &Aabb::centered(f64::from(i) * Vec3::X, Vec3::splat(0.4)), Vec3::ZERO);
        tree.mend();
    }
    assert_sound(&tree);
    let (nodes, lanes, levels) = tree.shape();
    // 6 + 2 ⌊log₈ 5000⌋ = 14.
    assert!(levels <= 14 && lanes >= 4.0, "{nodes} nodes of {lanes} lanes, {levels} levels");
}

#[test]
fn a_built_tree_is_shallow_and_full() {
    let random = &mut Random(8);
    let boxes: Vec<Aabb> = (0..20_000).map(|_| random.cube(20.0)).collect();
    let mut tree = Tree::new(Vec3::ZERO, Margin::NONE);
    tree.build(&boxes);
    assert_sound(&tree);
    let (nodes, lanes, levels) = tree.shape();
    // Half full at the least, or eight lanes would do the work of four.
    assert!(lanes >= 4.0 && levels <= 10, "{nodes} nodes of {lanes} lanes, {levels} levels");
}
