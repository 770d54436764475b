//! Every structure gives the pairs, the queries and the rays of brute force.

use super::*;
use crate::math::Vec3;

/// splitmix64.
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }
    fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }
    fn vector(&mut self, half: f64) -> Vec3 {
        Vec3::new(self.between(-half, half), self.between(-half, half), self.between(-half, half))
    }
    /// Of positive components, with logarithms uniform between those of `low` and `high`.
    fn size(&mut self, low: f64, high: f64) -> Vec3 {
        let mut edge = || low * libm::pow(high / low, self.unit());
        Vec3::new(edge(), edge(), edge())
    }
}

const SCENES: [&str; 11] =
    ["random", "clusters", "line", "stack", "scales", "coincident", "points", "plate", "infinite", "huge", "nonsense"];

fn scene(name: &str, n: usize, random: &mut Random) -> Vec<Aabb> {
    let half_edge = 0.5 * libm::cbrt(n as f64);
    let mut boxes: Vec<Aabb> = (0..n)
        .map(|i| match name {
            "clusters" => {
                let at = Vec3::splat((i % 5) as f64 * 40.0) + random.vector(2.0);
                Aabb::centered(at, random.size(0.05, 0.6))
            }
            "line" => Aabb::centered(Vec3::new(0.3 * i as f64, 0.0, 0.0), random.size(0.1, 0.5)),
            // Faces that touch exactly, in a grid.
            "stack" => {
                let at = Vec3::new((i % 6) as f64, (i / 6 % 6) as f64, (i / 36) as f64);
                Aabb::new(at, at + Vec3::splat(1.0))
            }
            "scales" => Aabb::centered(random.vector(20.0), random.size(1e-3, 1e3).scale(Vec3::splat(0.05))),
            "coincident" => Aabb::centered(Vec3::splat((i / 40) as f64), Vec3::splat(0.25)),
            "points" => {
                let p = Vec3::new((i % 7) as f64, (i % 3) as f64, 0.0);
                Aabb::new(p, p)
            }
            _ => Aabb::centered(random.vector(half_edge), random.size(0.2, 0.8)),
        })
        .collect();
    spoil(name, &mut boxes, random);
    boxes
}

/// A few boxes unlike the others.
fn spoil(name: &str, boxes: &mut [Aabb], random: &mut Random) {
    let some = |random: &mut Random, n: usize| random.bits() as usize % n;
    let n = boxes.len();
    match name {
        "plate" => boxes[0] = Aabb::centered(Vec3::ZERO, Vec3::new(1e4, 1e4, 0.1)),
        "infinite" => {
            boxes[some(random, n)] = Aabb::EVERYTHING;
            boxes[some(random, n)].min.z = f64::NEG_INFINITY;
            boxes[some(random, n)].max.x = f64::INFINITY;
        }
        "huge" => {
            boxes[some(random, n)] = Aabb::centered(Vec3::ZERO, Vec3::splat(1e300));
            boxes[some(random, n)] = Aabb::centered(Vec3::splat(1e30), Vec3::splat(1.0));
            boxes[some(random, n)] = Aabb::centered(Vec3::splat(-1e7), Vec3::splat(1e-3));
            boxes[some(random, n)] = Aabb::new(Vec3::splat(-f64::MAX), Vec3::splat(f64::MAX));
        }
        "nonsense" => {
            boxes[some(random, n)].min.y = f64::NAN;
            boxes[some(random, n)] = Aabb::EMPTY;
            boxes[some(random, n)].max.z = -1e6;
            boxes[some(random, n)] = Aabb::new(Vec3::splat(f64::INFINITY), Vec3::splat(f64::INFINITY));
        }
        _ => {}
    }
}

/// Most rest, some drift, a few jump.
fn move_some(boxes: &mut [Aabb], random: &mut Random) {
    for b in boxes {
        let d = match random.bits() % 8 {
            0..=3 => Vec3::ZERO,
            4..=6 => random.vector(0.1),
            _ => random.vector(5.0),
        };
        *b = Aabb::new(b.min + d, b.max + d);
    }
}

fn agree(structure: &mut dyn BroadPhase, oracle: &mut brute::Brute, random: &mut Random, what: &str) {
    let (mut expected, mut found) = (Vec::new(), vec![(7, 7)]);
    oracle.pairs(&mut expected);
    structure.pairs(&mut found);
    assert!(found == expected, "{what}: {} pairs, {} expected", found.len(), expected.len());
    let (mut expected, mut found) = (Vec::new(), vec![7]);
    for i in 0..24 {
        let region = match i {
            0 => Aabb::EVERYTHING,
            1 => Aabb::EMPTY,
            2 => Aabb::new(Vec3::splat(f64::NAN), Vec3::splat(1.0)),
            3 => Aabb::centered(Vec3::splat(1e300), Vec3::splat(1e300)),
            _ => Aabb::centered(random.vector(8.0), random.size(0.01, 20.0)),
        };
        oracle.query(&region, &mut expected);
        structure.query(&region, &mut found);
        assert_eq!(found, expected, "{what}: query {region:?}");
        let mut direction = random.vector(1.0);
        if i % 4 == 0 {
            direction = [Vec3::X, -Vec3::Y, Vec3::Z, Vec3::ZERO][i / 4 % 4];
        }
        // Also starts on faces of the stack, and rays along them.
        let origin = if i % 2 == 0 { random.vector(12.0) } else { Vec3::new((i % 5) as f64, 2.0, (i % 3) as f64) };
        let ray = Ray { origin, direction, length: [f64::INFINITY, 5.0, 0.0, 1e3, f64::NAN][i % 5] };
        oracle.ray(&ray, &mut expected);
        structure.ray(&ray, &mut found);
        assert_eq!(found, expected, "{what}: {ray:?}");
    }
}

fn compare(structure: Structure) {
    for name in SCENES {
        for (seed, n) in [(1, 4), (2, 9), (3, 60), (4, 400)] {
            let random = &mut Random(seed);
            let mut boxes = scene(name, n, random);
            let (mut tested, mut oracle) = (structure.create(), brute::Brute::default());
            for update in 0..6 {
                tested.update(&boxes);
                oracle.update(&boxes);
                let what = format!("{} on {n} boxes, scene {name}, update {update}", structure.name());
                agree(&mut *tested, &mut oracle, random, &what);
                move_some(&mut boxes, random);
                match update {
                    1 => spoil(name, &mut boxes, random),
                    3 => boxes.truncate(n * 3 / 4),
                    4 => boxes.extend(scene(name, n, random)),
                    _ => {}
                }
            }
            tested.update(&[]);
            oracle.update(&[]);
            agree(&mut *tested, &mut oracle, random, "no boxes");
        }
    }
}

macro_rules! agrees_with_brute_force {
    ($($structure:ident $test:ident),*) => {$(
        #[test]
        fn $test() {
            compare(Structure::$structure);
        }
    )*};
}
agrees_with_brute_force!(
    Sweep sweep_agrees, Sweep3 sweep3_agrees, Grid grid_agrees, Hashed hashed_agrees, Hierarchical hierarchical_agrees,
    Octree octree_agrees, Kd kd_agrees, Tree tree_agrees
);

#[test]
fn the_oracle_finds_what_is_plain_to_see() {
    let unit = |x: f64| Aabb::centered(Vec3::new(x, 0.0, 0.0), Vec3::splat(0.5));
    let mut brute = brute::Brute::default();
    brute.update(&[unit(3.0), unit(0.0), unit(1.0), unit(1.5), Aabb::EMPTY]);
    let (mut pairs, mut keys) = (Vec::new(), Vec::new());
    brute.pairs(&mut pairs);
    // 0 and 1 touch at x = ½; 1.5 and 3 do not.
    assert_eq!(pairs, [(1, 2), (2, 3)]);
    brute.query(&Aabb::EVERYTHING, &mut keys);
    assert_eq!(keys, [0, 1, 2, 3]);
    let ray = Ray { origin: Vec3::new(2.2, 0.0, 0.0), direction: -Vec3::X, length: 1.0 };
    brute.ray(&ray, &mut keys);
    assert_eq!(keys, [2, 3]);
}

/// Box2D's and Box3D's limit, that a body with many new neighbours loses some, has no counterpart here.
#[test]
fn a_plate_over_twenty_thousand_cubes_keeps_every_pair() {
    let mut boxes: Vec<Aabb> = (0..20_000)
        .map(|i| Aabb::centered(Vec3::new(f64::from(i % 200) * 2.0, f64::from(i / 200) * 2.0, 0.0), Vec3::splat(0.5)))
        .collect();
    boxes.push(Aabb::centered(Vec3::new(0.0, 0.0, 5.0), Vec3::new(1e3, 1e3, 0.5)));
    for structure in Structure::ALL.into_iter().filter(|&s| s != Structure::Brute) {
        let mut tested = structure.create();
        let mut pairs = Vec::new();
        tested.update(&boxes);
        tested.pairs(&mut pairs);
        assert!(pairs.is_empty(), "{}", structure.name());
        // The plate comes down in one step, and everything below it is new.
        let plate = boxes[20_000];
        boxes[20_000] = Aabb::new(plate.min - Vec3::splat(4.2), plate.max - Vec3::splat(4.2));
        tested.update(&boxes);
        tested.pairs(&mut pairs);
        assert!(pairs.iter().enumerate().all(|(i, &pair)| pair == (i as u32, 20_000)), "{}", structure.name());
        assert_eq!(pairs.len(), 20_000, "{}", structure.name());
        boxes[20_000] = plate;
    }
}

#[test]
fn pairs_are_sorted_in_every_density() {
    let random = &mut Random(9);
    let mut sort = PairSort::default();
    for (n, keys) in [(0, 1), (1, 1), (50, 4), (50, 1000), (3000, 100)] {
        let mut pairs: Vec<Pair> =
            (0..n).map(|_| ((random.bits() % keys) as u32, (random.bits() % keys) as u32)).collect();
        let mut expected = pairs.clone();
        expected.sort_unstable();
        sort.sort(&mut pairs);
        assert_eq!(pairs, expected);
    }
}
