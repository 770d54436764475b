//! `polhode bench broad`: every structure of the broad phase on every scene, and how its time grows with the number of boxes.

use crate::terminal::{FAINT, HEADING, styled};
use crate::{Outcome, Refusal, Terminal};
use polhode::collide::Aabb;
use polhode::collide::broad::Structure;
use polhode::collide::broad::tree::pairs::Pairs;
use polhode::collide::broad::tree::{Margin, Tree};
use polhode::math::Vec3;
use std::io::{self, Write};
use std::time::Instant;

/// A measurement longer than this is the last of its structure and scene \[s\]: the next n would be ten times as much or worse.
const LONGEST: f64 = 1.0;
/// Updates that are averaged.
const UPDATES: usize = 5;
/// Queries that are averaged.
const QUERIES: usize = 200;

/// The structures that find overlapping boxes, by scene and number of boxes
#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// Numbers of boxes
    #[arg(long, value_name = "N", value_delimiter = ',', default_values_t = [100, 1000, 10_000, 100_000],
        value_parser = clap::value_parser!(u32).range(2..=10_000_000))]
    n: Vec<u32>,
    /// Also 1,000,000 boxes
    #[arg(long)]
    large: bool,
    /// Only these scenes
    #[arg(long, value_name = "SCENE", value_delimiter = ',')]
    scene: Vec<Scene>,
}

/// Where the boxes are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
enum Scene {
    /// Cubes anywhere in a cube, a few neighbours each
    Random,
    /// Cubes in a hundred heaps far from each other
    Clusters,
    /// Cubes along a line
    Line,
    /// Cubes in a layer, side by side
    Layer,
    /// Boxes with edges from 1 cm to 10 m
    Scales,
    /// Random cubes under one plate that overlaps all
    Plate,
}

impl Arguments {
    /// Measures and prints the tables.
    pub(super) fn execute(&self, terminal: &mut Terminal) -> Result<Outcome, Refusal> {
        let mut sizes = self.n.clone();
        sizes.extend(self.large.then_some(1_000_000));
        sizes.sort_unstable();
        sizes.dedup();
        let all = <Scene as clap::ValueEnum>::value_variants();
        let scenes = if self.scene.is_empty() { all } else { &self.scene };
        writeln!(terminal.out, "{}", styled(HEADING, "Boxes that overlap"))?;
        let units = "build, update, pairs in ns per box; query and ray in ns each; memory in bytes per box. A tenth of the boxes \
                     moves by 1 % of their edge between updates. Slope: by which power of n update + pairs grow.";
        writeln!(terminal.out, "{}", styled(FAINT, units))?;
        for &scene in scenes {
            table(scene, &sizes, terminal.out)?;
        }
        fixed(*sizes.last().unwrap_or(&2) as usize, terminal.out)?;
        Ok(Outcome::Done)
    }
}

/// splitmix64 (G. Steele, D. Lea, C. Flood, OOPSLA 2014).
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }
    fn vector(&mut self, half: f64) -> Vec3 {
        let mut at = || (2.0 * self.unit() - 1.0) * half;
        Vec3::new(at(), at(), at())
    }
}

fn boxes(scene: Scene, n: usize) -> Vec<Aabb> {
    let random = &mut Random(1);
    // A box for each 2 m³: with cubes of 1 m two to four neighbours each.
    let half = 0.5 * libm::cbrt(2.0 * n as f64);
    let row = (n as f64).sqrt().ceil() as usize;
    let unit = Vec3::splat(0.5);
    let mut all: Vec<Aabb> = (0..n)
        .map(|i| match scene {
            Scene::Random | Scene::Plate => Aabb::centered(random.vector(half), unit),
            Scene::Clusters => {
                let heap = Vec3::new((i % 10) as f64, (i / 10 % 10) as f64, 0.0) * (20.0 * half);
                Aabb::centered(heap + random.vector(half / libm::cbrt(100.0)), unit)
            }
            Scene::Line => Aabb::centered(Vec3::X * (0.8 * i as f64) + random.vector(0.1), unit),
            Scene::Layer => {
                let at = Vec3::new((i % row) as f64, (i / row) as f64, 0.0) * 1.1;
                Aabb::centered(at + random.vector(0.1), unit)
            }
            Scene::Scales => {
                // The count of boxes halves three times for each doubling of the edge.
                let edge = 0.01 / libm::cbrt(random.unit()).max(1e-3);
                Aabb::centered(random.vector(0.05 * half), Vec3::splat(0.5 * edge))
            }
        })
        .collect();
    if scene == Scene::Plate {
        all[0] = Aabb::centered(Vec3::ZERO, Vec3::new(2.0 * half, 2.0 * half, 2.0 * half));
    }
    all
}

/// What one structure needs for one scene of n boxes \[s; bytes\].
struct Cost {
    n: usize,
    build: f64,
    update: f64,
    pairs: f64,
    query: f64,
    ray: f64,
    memory: usize,
    n_pairs: usize,
}

fn seconds(work: impl FnOnce()) -> f64 {
    let start = Instant::now();
    work();
    start.elapsed().as_secs_f64()
}

/// A tenth of the boxes moves by a hundredth of its edge.
fn stir(boxes: &mut [Aabb], random: &mut Random) {
    for b in boxes.iter_mut().filter(|_| random.unit() < 0.1) {
        let d = 0.01 * b.size().x * Vec3::new(0.6, 0.0, -0.8);
        *b = Aabb::new(b.min + d, b.max + d);
    }
}

fn measure(structure: Structure, mut boxes: Vec<Aabb>) -> Cost {
    let n = boxes.len();
    let random = &mut Random(2);
    let mut tested = structure.create();
    let (mut pairs, mut found) = (Vec::new(), Vec::new());
    let build = seconds(|| tested.update(&boxes));
    let first_pairs = seconds(|| tested.pairs(&mut pairs));
    let (mut update, mut later_pairs) = (0.0, 0.0);
    let rounds = if build + first_pairs > LONGEST { 1 } else { UPDATES };
    for _ in 0..rounds {
        stir(&mut boxes, random);
        update += seconds(|| tested.update(&boxes)) / rounds as f64;
        later_pairs += seconds(|| tested.pairs(&mut pairs)) / rounds as f64;
    }
    let around = boxes.iter().fold(Aabb::EMPTY, |a, b| a.merged(b));
    let at: Vec<Vec3> = (0..QUERIES).map(|_| around.center() + random.vector(0.5).scale(around.size())).collect();
    let query = seconds(|| at.iter().for_each(|&p| tested.query(&Aabb::centered(p, Vec3::splat(0.5)), &mut found)));
    let ray = |&p: &Vec3| polhode::collide::Ray { origin: p, direction: Vec3::new(0.6, 0.64, 0.48), length: 20.0 };
    let rays = seconds(|| at.iter().for_each(|p| tested.ray(&ray(p), &mut found)));
    Cost {
        n,
        build: build + first_pairs,
        update,
        pairs: later_pairs,
        query: query / QUERIES as f64,
        ray: rays / QUERIES as f64,
        memory: tested.memory(),
        n_pairs: pairs.len(),
    }
}

fn table(scene: Scene, sizes: &[u32], out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "\n{}", styled(HEADING, &format!("{scene:?}").to_lowercase()))?;
    writeln!(
        out,
        "  {:<18}{:>9}{:>10}{:>10}{:>10}{:>10}{:>10}{:>9}{:>12}{:>7}",
        "structure", "n", "build", "update", "pairs", "query", "ray", "memory", "overlaps", "slope"
    )?;
    for structure in Structure::ALL {
        let mut last: Option<Cost> = None;
        for &n in sizes {
            // n²/2 questions: beyond this they tell nothing that the slope has not.
            if structure == Structure::Brute && n > 50_000 {
                break;
            }
            let cost = measure(structure, boxes(scene, n as usize));
            row(structure, &cost, last.as_ref(), out)?;
            let (grown, total) = (last.as_ref().map_or(1.0, |l| f64::from(n) / l.n as f64), cost.build + cost.pairs);
            last = Some(cost);
            // A structure that grows as n² would take a hundred times as long for the next.
            if total > LONGEST / grown.max(2.0) && structure != Structure::Tree {
                break;
            }
        }
    }
    Ok(())
}

fn row(structure: Structure, cost: &Cost, last: Option<&Cost>, out: &mut dyn Write) -> io::Result<()> {
    let n = cost.n as f64;
    let each = |time: f64| time / n * 1e9;
    write!(out, "  {:<18}{:>9}", structure.name(), cost.n)?;
    for value in [each(cost.build), each(cost.update), each(cost.pairs), cost.query * 1e9, cost.ray * 1e9] {
        write!(out, "{value:>10.0}")?;
    }
    write!(out, "{:>9.0}{:>12}", cost.memory as f64 / n, cost.n_pairs)?;
    match last {
        Some(last) => {
            let ratio = (cost.update + cost.pairs) / (last.update + last.pairs).max(1e-12);
            writeln!(out, "{:>7.2}", libm::log(ratio) / libm::log(n / last.n as f64))
        }
        None => writeln!(out),
    }
}

/// The engine's own way with n fixed boxes: building once, a step in which nothing moves, and one in which a hundred things do.
fn fixed(n: usize, out: &mut dyn Write) -> io::Result<()> {
    let ground = boxes(Scene::Layer, n);
    let mut fixed = Tree::new(Vec3::ZERO, Margin::NONE);
    let build = seconds(|| fixed.build(&ground));
    let mut moving = Tree::new(Vec3::ZERO, Margin::default());
    let mut pairs = Pairs::default();
    let step = |k: usize, moving: &mut Tree, fixed: &mut Tree, pairs: &mut Pairs, m: usize| {
        seconds(|| {
            for i in 0..m {
                let at = ground[i * (n / 100).max(1) % n].center() + Vec3::new(0.05 * k as f64, 0.0, 0.9);
                moving.place((n + i) as u32, &Aabb::centered(at, Vec3::splat(0.5)), Vec3::new(0.05, 0.0, 0.0));
            }
            moving.mend();
            pairs.update(moving, &[fixed]);
            moving.forget_changes();
            fixed.forget_changes();
        })
    };
    step(0, &mut moving, &mut fixed, &mut pairs, 100);
    let mut busy = 0.0;
    for k in 1..=100 {
        busy += step(k, &mut moving, &mut fixed, &mut pairs, 100) / 100.0;
    }
    let still = (0..100).map(|_| step(0, &mut moving, &mut fixed, &mut pairs, 0)).sum::<f64>() / 100.0;
    let (nodes, lanes, levels) = fixed.shape();
    writeln!(out, "\n{}", styled(HEADING, &format!("{n} fixed boxes in the tree")))?;
    writeln!(out, "  built in {build:.3} s: {nodes} nodes of {lanes:.1} lanes, {levels} levels")?;
    writeln!(
        out,
        "  a step in which nothing moves: {:.2} µs; one in which 100 boxes move: {:.1} µs",
        still * 1e6,
        busy * 1e6
    )?;
    writeln!(out, "  {} bytes per box", fixed.memory() / n)
}
