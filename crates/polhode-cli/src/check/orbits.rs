//! Gravitation: the ellipse of Kepler, and bodies that attract each other.

use super::scene::{Greatest, ball, steps};
use super::slope;
use super::suite::{Check, Findings, Group, Subject};
use core::f64::consts::TAU;
use polhode::field::Field;
use polhode::math::Vec3;
use polhode::model::Body;
use polhode::shape::Shape;
use polhode::store::BodyId;
use polhode::{Error, World};

pub(super) const CHECKS: &[Check] = &[
    Check {
        group: Group::Forces,
        name: "kepler",
        law: "About a centre of µ/r² a body goes along its ellipse in 2π √(a³/µ), and the ellipse stays where it is.",
        measure: kepler,
    },
    Check {
        group: Group::Forces,
        name: "two-bodies",
        law: "Two bodies that attract each other go about their common centre in 2π √(d³/G(m₁ + m₂)).",
        measure: two_bodies,
    },
    Check {
        group: Group::Forces,
        name: "dumbbells",
        law: "Two dumbbells that orbit and turn each other keep p, L and E between them.",
        measure: dumbbells,
    },
];

/// Where a body is, time t \[s\] after it was nearest to the centre on the x axis, on the ellipse of a = 1 m, µ = 1 m³/s² \[m\].
pub(super) fn kepler_position(e: f64, t: f64) -> Vec3 {
    // Kepler's equation E − e sin E = t by Newton's iteration, which contracts everywhere for the small e of use here.
    let mut anomaly = t;
    for _ in 0..50 {
        anomaly -= (anomaly - e * libm::sin(anomaly) - t) / (1.0 - e * libm::cos(anomaly));
    }
    Vec3::new(libm::cos(anomaly) - e, libm::sqrt(1.0 - e * e) * libm::sin(anomaly), 0.0)
}

/// A body nearest to the centre on an ellipse of a = 1 m about µ = 1 m³/s², whose period is 2π s.
fn orbiting(subject: Subject, integrator: &str, e: f64) -> Result<(World, BodyId), Error> {
    let mut world = subject.world(integrator)?;
    let speed = libm::sqrt((1.0 + e) / (1.0 - e));
    let id = world.add(ball(1.0)?.position([1.0 - e, 0.0, 0.0]).velocity([0.0, speed, 0.0]))?;
    world.add_field(Field::central([0.0; 3], 1.0))?;
    Ok((world, id))
}

/// v × (r × v)/µ − r/|r|: points to where the orbit is nearest, with length e.
fn laplace(world: &World, id: BodyId) -> Vec3 {
    let (r, v) = (world.body(id).center_of_mass(), world.body(id).velocity());
    v.cross(r.cross(v)) - r / r.length()
}

fn kepler(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let e = 0.6;
    let closes = |integrator: &str, h: f64| -> Result<f64, Error> {
        let (mut world, id) = orbiting(subject, integrator, e)?;
        let n = (TAU / h).round();
        steps(&mut world, n as usize, TAU / n);
        Ok((world.body(id).center_of_mass() - Vec3::new(1.0 - e, 0.0, 0.0)).length())
    };
    for (integrator, order, n) in [("pdmv6", 2, 1000.0), ("suzuki4:pdmv6", 4, 400.0), ("kahan-li8:pdmv6", 8, 150.0)] {
        let name = format!("{integrator}, place after a period");
        slope::expect(&mut findings, &name, order, TAU / n, |h| closes(integrator, h))?;
    }
    let n = 1000.0;
    // The eighth order at 1000 steps is below rounding: 150 steps err by 1e-6, and 8 · log2(1000/150) more bits follow.
    // An error of the energy becomes one of the period: 3π δE/E, at the speed of 2 m/s.
    let rounding = 4.0 * libm::sqrt(17.0 * n) * f64::EPSILON * 3.0 * core::f64::consts::PI * 2.0;
    let because = "17 stages in each of 1000 steps round as their root, and a rounding of E becomes one of the period";
    findings.at_most(
        "distance from the start after a period of 1000 steps, kahan-li8:pdmv6 [m]",
        closes("kahan-li8:pdmv6", TAU / n)?,
        rounding,
        because,
    );
    long_orbit(subject, &mut findings, e)?;
    Ok(findings)
}

/// A hundred turns with the default integrator: what stays, and what swings.
fn long_orbit(subject: Subject, findings: &mut Findings, e: f64) -> Result<(), Error> {
    let (mut world, id) = orbiting(subject, "pdmv6", e)?;
    let (turns, per_turn) = (100, 1000);
    let l = world.angular_momentum([0.0; 3]);
    let energy = world.energy().total();
    let (mut l_change, mut halves): (f64, [f64; 2]) = (0.0, [0.0; 2]);
    let mut plane: f64 = 0.0;
    for step in 0..turns * per_turn {
        world.step(TAU / f64::from(per_turn));
        l_change = l_change.greatest((world.angular_momentum([0.0; 3]) - l).length() / l.length());
        let half = &mut halves[(2 * step / (turns * per_turn)) as usize];
        *half = half.greatest((world.energy().total() / energy - 1.0).abs());
        plane = plane.greatest(laplace(&world, id).z.abs());
    }
    let n = f64::from(turns * per_turn);
    let rounding = 4.0 * libm::sqrt(n) * f64::EPSILON;
    let because = "kicks are along r and drifts along p, so only roundings change r × p; they add up as their root";
    findings.at_most("largest relative change of L in 100 turns, pdmv6", l_change, 2.0 * rounding, because);
    let because = "symplectic: the second half is no worse than the first but for a hundredth by chance of the phase";
    let growth = (halves[1] / halves[0] - 1.0).greatest(0.0);
    findings.at_most("growth of the energy error from turns 1 to 50 to turns 51 to 100, pdmv6", growth, 0.01, because);
    let because = "a central force has nothing across the plane, and multiplies zeros";
    findings.at_most("largest component of the ellipse's axis across its plane", plane, 0.0, because);

    let (mut world, id) = orbiting(subject, "kahan-li8:pdmv6", e)?;
    let axis = laplace(&world, id);
    steps(&mut world, 10_000, TAU / 1000.0);
    let because =
        "the eighth order errs below rounding; 17 stages in each of 10 000 steps round as their root, e⁻¹ times";
    findings.at_most(
        "change of the Laplace vector in 10 turns, kahan-li8:pdmv6",
        (laplace(&world, id) - axis).length(),
        4.0 * libm::sqrt(170_000.0) * f64::EPSILON / e,
        because,
    );
    Ok(())
}

fn two_bodies(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let (g, m1, m2, d) = (0.5, 3.0, 1.0, 2.0);
    let w = libm::sqrt(g * (m1 + m2) / (d * d * d));
    let after_a_turn = |integrator: &str, h: f64| -> Result<f64, Error> {
        let mut world = subject.world(integrator)?;
        let (r1, r2) = (d * m2 / (m1 + m2), d * m1 / (m1 + m2));
        let drift = Vec3::new(0.2, -0.1, 0.4);
        let a = world.add(ball(m1)?.position([-r1, 0.0, 0.0]).velocity(drift - Vec3::Y * (r1 * w)))?;
        let b = world.add(ball(m2)?.position([r2, 0.0, 0.0]).velocity(drift + Vec3::Y * (r2 * w)))?;
        world.add_field(Field::mutual_gravity(g, 0.0))?;
        let n = (TAU / w / h).round();
        steps(&mut world, n as usize, TAU / w / n);
        let t = TAU / w;
        let (xa, xb) = (world.body(a).center_of_mass(), world.body(b).center_of_mass());
        Ok((xa - drift * t + Vec3::X * r1).length().greatest((xb - drift * t - Vec3::X * r2).length()))
    };
    for (integrator, order, n) in [("pdmv6", 2, 200.0), ("suzuki4:pdmv6", 4, 100.0), ("kahan-li6:pdmv6", 6, 60.0)] {
        slope::expect(&mut findings, integrator, order, TAU / w / n, |h| after_a_turn(integrator, h))?;
    }
    Ok(findings)
}

/// Two dumbbells of 2 kg and 3 kg, 4 m apart, at the speeds of point masses in a circle.
fn two_dumbbells(subject: Subject) -> Result<(World, BodyId), Error> {
    let mut world = subject.world("pdmv6")?;
    let dumbbell = |heavy: f64| {
        Body::dynamic()
            .shape(Shape::sphere(0.1).mass(heavy).at([0.5, 0.0, 0.0]))
            .shape(Shape::sphere(0.1).mass(1.0).at([-0.5, 0.0, 0.0]))
    };
    let (a, b) = (dumbbell(1.0), dumbbell(2.0).rotation([0.8, 0.0, 0.6, 0.0]));
    let w = libm::sqrt(5.0 / 64.0);
    let a = world.add(a.position([-2.4, 0.0, 0.0]).velocity([0.0, -2.4 * w, 0.1]).angular_velocity([0.0, 0.3, 0.2]))?;
    world.add(b.position([1.6, 0.0, 0.2]).velocity([0.0, 1.6 * w, 0.0]))?;
    world.add_field(Field::mutual_gravity(1.0, 0.0))?;
    Ok((world, a))
}

fn dumbbells(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let (mut world, a) = two_dumbbells(subject)?;
    let (p, l) = (world.momentum(), world.angular_momentum([0.0; 3]));
    let spin = world.body(a).angular_momentum();
    let (mut dp, mut dl, mut exchanged, mut size_p, mut size_l): (f64, f64, f64, f64, f64) = Default::default();
    let n = 20_000;
    for _ in 0..n {
        world.step(0.005);
        dp = dp.greatest((world.momentum() - p).length());
        dl = dl.greatest((world.angular_momentum([0.0; 3]) - l).length());
        exchanged = exchanged.greatest((world.body(a).angular_momentum() - spin).length());
        let moment = |b: polhode::world::BodyRef| {
            b.center_of_mass().length() * b.momentum().length() + b.angular_momentum().length()
        };
        size_p = size_p.greatest(world.bodies().map(|b| b.momentum().length()).sum());
        size_l = size_l.greatest(world.bodies().map(moment).sum());
    }
    let rounding = 4.0 * libm::sqrt(2.0 * f64::from(n)) * f64::EPSILON;
    let because =
        "40 000 kicks round each p and its forces; independent roundings add up as their root, here four times it";
    findings.at_most("largest change of Σp [kg·m/s]", dp, rounding * size_p, because);
    let because =
        "40 000 kicks and 20 000 drifts round p, l and x; independent roundings add up as their root, four times";
    findings.at_most("largest change of Σ(x × p + L) [kg·m²/s]", dl, 2.0 * rounding * size_l, because);
    let because = "a torque there must be, or this check would be empty: at least a tenth of the spin goes over";
    findings.at_most(
        "a tenth of the first one's spin, over what it exchanged",
        0.1 * spin.length() / exchanged,
        1.0,
        because,
    );
    slope::expect(&mut findings, "pdmv6, largest energy error of 20 s", 2, 0.05, |h| {
        let (mut world, _) = two_dumbbells(subject)?;
        let energy = world.energy().total();
        let mut worst: f64 = 0.0;
        for _ in 0..(20.0 / h).round() as usize {
            world.step(h);
            worst = worst.greatest((world.energy().total() - energy).abs());
        }
        Ok(worst)
    })?;
    Ok(findings)
}
