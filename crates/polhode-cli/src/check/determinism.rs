//! The same bits again: in another run, with other threads and lanes, after poison; and the way back in time.

use super::scene::{Greatest, ball, rigid, steps};
use super::suite::{Check, Findings, Group, Subject};
use crate::random::Random;
use polhode::field::{Anchor, Field, Wrench};
use polhode::integrate::lanes::Lanes;
use polhode::math::{Quat, Vec3};
use polhode::model::Body;
use polhode::record::state_hash;
use polhode::shape::Shape;
use polhode::{Error, World};

pub(super) const CHECKS: &[Check] = &[
    Check {
        group: Group::Determinism,
        name: "same-bits",
        law: "A world with every law of force has the same state, to the bit, in every run, with any number of threads, with \
              one lane or many, and with poisoned memory.",
        measure: same_bits,
    },
    Check {
        group: Group::Determinism,
        name: "hash",
        law: "The hash of a state changes with any one bit of it.",
        measure: hash,
    },
    Check {
        group: Group::Determinism,
        name: "reversal",
        law: "A symmetric scheme that steps back as often as forth is where it was.",
        measure: reversal,
    },
];

/// Enough for several blocks of every stage, and some over.
const N_BODIES: usize = 301;

/// A world in which everything pushes.
fn everything(subject: Subject, integrator: &str) -> Result<World, Error> {
    let mut random = Random::new(3);
    let mut world = subject.world(integrator)?;
    world.set_gravity([0.0, 0.0, -9.81])?;
    let (mut ids, mut floating) = (Vec::new(), Vec::new());
    for i in 0..N_BODIES {
        let density = random.between(300.0, 900.0);
        let shape = match i % 4 {
            0 => Shape::sphere(random.between(0.1, 0.3)),
            1 => Shape::cuboid(random.vector(0.2) + Vec3::splat(0.4)),
            2 => Shape::cylinder(0.1, 0.4),
            _ => Shape::capsule(0.1, 0.3).rotated(Quat::from_rotation_vector(random.vector(2.0)).normalized()),
        };
        let body = Body::dynamic().shape(shape.density(density)).position(random.vector(8.0));
        let id = world.add(body.velocity(random.vector(2.0)).angular_velocity(random.vector(6.0)))?;
        ids.push(id);
        if i % 4 < 2 {
            floating.push(id);
        }
    }
    let moved = world.add(Body::kinematic().velocity([0.5, 0.0, 0.0]).angular_velocity([0.0, 0.0, 1.0]))?;
    world.add_field(Field::central([0.0, 0.0, -20.0], 50.0))?;
    world.add_field(Field::linear_drag(0.3, 0.02).wind([1.0, 0.0, 0.0]))?;
    world.add_field(Field::quadratic_drag(0.1, 0.01))?;
    world.add_field(Field::buoyancy(1000.0, 0.0).only(floating))?;
    world.add_field(Field::mutual_gravity(1e-3, 0.1))?;
    world.add_field(Field::custom(|body| Wrench {
        force: Vec3::new(libm::sin(body.time), 0.0, 0.0) * body.mass,
        torque: body.w.cross(Vec3::Z) * 0.01,
    }))?;
    for pair in ids.chunks_exact(2).take(40) {
        let ends = (Anchor::on(pair[0], random.vector(0.1)), Anchor::on(pair[1], random.vector(0.1)));
        world.add_field(Field::spring(ends.0, ends.1, 200.0, 0.5).damping(1.0))?;
    }
    world.add_field(Field::spring(Anchor::on(moved, [0.1, 0.0, 0.0]), Anchor::on(ids[100], [0.0; 3]), 300.0, 1.0))?;
    world.add_field(Field::torsion_spring(Some(ids[101]), ids[102], 5.0).damping(0.1))?;
    world.add_field(Field::torsion_spring(None, ids[103], 5.0))?;
    // Pins ask for a scheme that closes them; the others are tested without.
    if world.integrator().closes_pins() {
        for (i, &id) in ids[200..220].iter().enumerate() {
            for _ in 0..=i % 3 {
                world.pin(id, random.vector(0.3))?;
            }
        }
    }
    world.keep_forces(true);
    for &id in &ids[150..170] {
        world.body_mut(id).apply_force_at(random.vector(20.0), random.vector(8.0))?;
        world.body_mut(id).apply_torque(random.vector(3.0))?;
    }
    Ok(world)
}

/// The hash after some steps, `turn` having been given the world before and between them.
fn hash_after(mut world: World, n: usize, mut turn: impl FnMut(&mut World)) -> u64 {
    for _ in 0..n {
        turn(&mut world);
        world.step(1.0 / 120.0);
    }
    state_hash(&world)
}

fn same_bits(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let because = "no sum, no choice and no order depends on it";
    for (integrator, n) in [("pdmv6", 30), ("suzuki4:pdmv10", 6), ("rk4", 15)] {
        let scene = || everything(subject, integrator);
        let mut expected = scene()?;
        expected.set_lanes(Lanes::One);
        let expected = hash_after(expected, n, |_| ());
        let mut different = Vec::new();
        let mut compare = |name: &str, hash: u64| {
            if hash != expected {
                different.push(name.to_string());
            }
        };
        compare("another run", hash_after(scene()?, n, |_| ()));
        for threads in [1, 2, 3] {
            for lanes in [Lanes::One, Lanes::Native] {
                let mut world = scene()?;
                world.set_threads(threads)?;
                world.set_lanes(lanes);
                compare(&format!("{threads} threads, lanes {lanes:?}"), hash_after(world, n, |_| ()));
            }
        }
        compare("poisoned", hash_after(scene()?, n, World::poison));
        let those = if different.is_empty() { String::new() } else { format!(": {}", different.join("; ")) };
        let what =
            format!("of 8 ways to take {n} steps with {integrator}, those that do not end in {expected:016x}{those}");
        findings.none(what, different.len(), because);
    }
    Ok(findings)
}

fn hash(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let mut world = everything(subject, "pdmv6")?;
    steps(&mut world, 3, 0.01);
    let (state, expected) = (world.state().clone(), state_hash(&world));
    let flip = |x: &mut f64, bit: u32| *x = f64::from_bits(x.to_bits() ^ (1 << bit));
    let (mut tried, mut unseen) = (0, 0);
    for body in [0, 1, 150, N_BODIES - 1] {
        for bit in 0..64 {
            for number in 0..6 {
                let mut other = state.clone();
                let bodies = &mut other.bodies;
                match number {
                    0 => flip(&mut bodies.x[body].x, bit),
                    1 => flip(&mut bodies.p[body].y, bit),
                    2 => flip(&mut bodies.l[body].z, bit),
                    3 => flip(&mut bodies.rot[body].w, bit),
                    4 => flip(&mut bodies.rot[body].z, bit),
                    _ => flip(&mut other.time, bit),
                }
                world.restore(&other)?;
                tried += 1;
                unseen += usize::from(state_hash(&world) == expected);
            }
        }
    }
    findings.none(
        format!("of {tried} single bits, those that the hash does not see"),
        unseen,
        "a word in, another word out",
    );
    world.restore(&state)?;
    let because = "the hash is of the state and of nothing else";
    findings.none(
        "whether the hash of the restored state differs",
        usize::from(state_hash(&world) != expected),
        because,
    );
    // What takes a body astray must be seen in the end, or a hash of nothing would do. Not the last bit, which the next
    // rounding may well remove again.
    let mut other = world.clone();
    let mut astray = state.clone();
    flip(&mut astray.bodies.p[7].x, 30);
    other.restore(&astray)?;
    steps(&mut world, 10, 0.01);
    steps(&mut other, 10, 0.01);
    let same = usize::from(state_hash(&world) == state_hash(&other));
    findings.none(
        "whether worlds that were one bit apart have one hash ten steps later",
        same,
        "they went different ways",
    );
    Ok(findings)
}

/// A top under its weight, a body in orbit, a mass on a spring, and where the scheme allows, a pinned one and a hinged one.
fn there_and_back(subject: Subject, integrator: &str) -> Result<World, Error> {
    let mut world = subject.world(integrator)?;
    let top = world.add(rigid(1.0, [0.6, 0.8, 1.0])?.angular_velocity([0.3, 0.5, 2.0]))?;
    let (center, weight) = (Vec3::new(0.1, 0.0, 0.2), Vec3::new(0.0, 0.0, -9.81));
    let torque = move |body: &polhode::field::BodyView| Wrench {
        force: Vec3::ZERO,
        torque: body.rot.rotate(center).cross(weight),
    };
    world.add_field(Field::conservative(torque, move |body| -weight.dot(body.rot.rotate(center))).only([top]))?;
    let planet = world.add(ball(1.0)?.position([0.7, 0.0, 0.0]).velocity([0.0, 1.3, 0.0]))?;
    world.add_field(Field::central([0.0; 3], 1.0).only([planet]))?;
    let mass = world.add(rigid(2.0, [0.3, 0.2, 0.4])?.position([1.5, 0.0, 0.0]).angular_velocity([0.2, 1.0, 0.1]))?;
    world.add_field(Field::spring(Anchor::world([0.0; 3]), Anchor::on(mass, [0.1, 0.2, 0.0]), 20.0, 1.0))?;
    if world.integrator().closes_pins() {
        world.set_gravity([0.0, 0.0, -1.0])?;
        for pins in [1, 2] {
            let id = world.add(rigid(1.0, [0.3, 0.2, 0.4])?.angular_velocity([1.0, 0.5, 2.0]))?;
            for i in 0..pins {
                world.pin(id, [0.1, 0.3 * f64::from(i), 0.4])?;
            }
        }
    }
    Ok(world)
}

fn reversal(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let schemes = [
        ("pdmv6", 1.0),
        ("pdmv10", 1.0),
        ("dmv", 1.0),
        ("implicit-midpoint", 1.0),
        ("splitting", 1.0),
        ("symmetric-top", 1.0),
        ("exact", 1.0),
        ("yoshida4:pdmv6", 3.0),
        ("suzuki4:pdmv10", 5.0),
        ("kahan-li6:pdmv6", 9.0),
        ("kahan-li8:exact", 17.0),
    ];
    let (n, h) = (500, 0.01);
    for (integrator, stages) in schemes {
        let mut world = there_and_back(subject, integrator)?;
        let start = world.state().bodies.clone();
        steps(&mut world, n, h);
        steps(&mut world, n, -h);
        let now = &world.state().bodies;
        let mut error: f64 = 0.0;
        for slot in 0..world.len() {
            for (a, b) in [(&now.x, &start.x), (&now.p, &start.p), (&now.l, &start.l)] {
                error = error.greatest((a[slot] - b[slot]).length());
            }
            error = error.greatest(now.rot[slot].angle_to(start.rot[slot]));
        }
        // Numbers of some 4 at most; what a rounding does to a rate grows over the 10 rad of the fastest of them.
        let tolerance = 4.0 * libm::sqrt(2.0 * n as f64 * stages) * f64::EPSILON * 4.0 * 10.0;
        findings.at_most(
            format!("largest difference in x, p, L [SI] or angle [rad] after {n} steps forth and back, {integrator}"),
            error,
            tolerance,
            "roundings of every stage as their root, four times, of numbers up to 4, grown over 10 rad of motion",
        );
        let clock = "the clock is a compensated sum of steps of one size";
        findings.at_most(format!("time on the clock, {integrator} [s]"), world.time().abs(), 0.0, clock);
    }
    Ok(findings)
}
