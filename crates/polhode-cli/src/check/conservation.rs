//! What bodies that push each other keep between them.

use super::scene::{Greatest, rigid, same_bits};
use super::suite::{Check, Findings, Group, Subject};
use crate::random::Random;
use polhode::field::{Anchor, Field, Law, MutualGravity};
use polhode::math::Vec3;
use polhode::store::BodyId;
use polhode::{Error, World};

pub(super) const CHECKS: &[Check] = &[
    Check {
        group: Group::Forces,
        name: "momentum",
        law: "Fifty bodies on springs that attract each other keep Σp and, about any point, Σ(x × p + L), for 10 000 steps.",
        measure: momentum,
    },
    Check {
        group: Group::Forces,
        name: "third-law",
        law: "What a law puts on one body it puts on the other with the opposite sign, to the bit.",
        measure: third_law,
    },
];

const N_BODIES: usize = 50;

/// Fifty bodies, each on a damped spring to the next, in their common gravitation.
fn web(subject: Subject) -> Result<(World, Vec<BodyId>), Error> {
    let mut random = Random::new(1);
    let mut world = subject.world("pdmv6")?;
    let mut ids = Vec::new();
    for _ in 0..N_BODIES {
        let mass = random.between(0.5, 2.0);
        let inertia = Vec3::new(random.between(0.2, 0.3), random.between(0.2, 0.3), random.between(0.2, 0.3));
        let body = rigid(mass, inertia)?.position(random.vector(5.0)).velocity(random.vector(1.0));
        ids.push(world.add(body.angular_velocity(random.vector(2.0)))?);
    }
    for (i, &a) in ids.iter().enumerate() {
        let b = ids[(i + 1) % N_BODIES];
        let (end_a, end_b) = (Anchor::on(a, random.vector(0.3)), Anchor::on(b, random.vector(0.3)));
        world.add_field(Field::spring(end_a, end_b, random.between(1.0, 5.0), 1.0).damping(0.02))?;
    }
    world.add_field(Field::mutual_gravity(0.02, 0.1))?;
    Ok((world, ids))
}

fn momentum(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let (mut world, _) = web(subject)?;
    let points = [Vec3::ZERO, Vec3::new(30.0, -20.0, 10.0)];
    let p = world.momentum();
    let l = points.map(|point| world.angular_momentum(point));
    let (mut dp, mut dl, mut size_p, mut size_l): (f64, [f64; 2], f64, [f64; 2]) = (0.0, [0.0; 2], 0.0, [0.0; 2]);
    let n = 10_000;
    for _ in 0..n {
        world.step(0.005);
        dp = dp.greatest((world.momentum() - p).length());
        size_p = size_p.greatest(world.bodies().map(|b| b.momentum().length()).sum());
        for (i, &point) in points.iter().enumerate() {
            dl[i] = dl[i].greatest((world.angular_momentum(point) - l[i]).length());
            let sizes = world
                .bodies()
                .map(|b| (b.center_of_mass() - point).length() * b.momentum().length() + b.angular_momentum().length());
            size_l[i] = size_l[i].greatest(sizes.sum());
        }
    }
    // A kick rounds p and l by half an ε each, and what it adds by a few ε of that.
    let rounding = 4.0 * libm::sqrt(2.0 * f64::from(n)) * f64::EPSILON;
    let because = "20 000 kicks round each p; independent roundings add up as their root, here four times it";
    findings.at_most("largest change of Σp [kg·m/s]", dp, rounding * size_p, because);
    for (i, name) in ["the origin", "(30, −20, 10)"].into_iter().enumerate() {
        let because = "20 000 kicks and 10 000 drifts round p, l and x; they add up as their root, here four times it";
        findings.at_most(
            format!("largest change of Σ((x − o) × p + L), o = {name} [kg·m²/s]"),
            dl[i],
            2.0 * rounding * size_l[i],
            because,
        );
    }
    Ok(findings)
}

fn third_law(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let mut random = Random::new(2);
    let law = MutualGravity { constant: 0.3, softening: 0.01 };
    let mut unequal = 0;
    for _ in 0..100_000 {
        let (m_a, m_b) = (random.between(0.1, 9.0), random.between(0.1, 9.0));
        let (a, b) = (random.vector(3.0), random.vector(3.0));
        unequal += usize::from(!same_bits(law.pull(m_a, a, m_b, b), -law.pull(m_b, b, m_a, a)));
    }
    let because = "d becomes −d, and products round alike in either order";
    findings.none("of 100 000 pairs, those whose gravitation is not equal and opposite to the bit", unequal, because);

    let (mut world, _) = web(subject)?;
    let (mut forces, mut unequal) = (0, 0);
    for _ in 0..100 {
        world.step(0.01);
        for field in &world.model().fields {
            let Law::Spring(spring) = &field.law else { continue };
            let bodies = [spring.a.body, spring.b.body].map(|id| id.and_then(|id| world.get(id)));
            let [a, b] = bodies.each_ref().map(|body| body.as_ref().map(polhode::world::BodyRef::view));
            let (on_a, on_b) = spring.wrenches(a.as_ref(), b.as_ref());
            forces += 1;
            unequal += usize::from(!same_bits(on_a.force, -on_b.force));
        }
    }
    let because = "one is computed, and the other is its negative";
    findings.none(format!("of {forces} springs' forces, those not equal and opposite to the bit"), unequal, because);
    Ok(findings)
}
