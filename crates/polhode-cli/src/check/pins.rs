//! Bodies that are held at points: pendulums, hinges, and what the pins carry.

use super::reference;
use super::scene::{Greatest, rigid, steps, visit};
use super::slope;
use super::suite::{Check, Findings, Group, Subject, Worst};
use core::f64::consts::{PI, TAU};
use polhode::mass::MassProperties;
use polhode::math::{Mat3, Quat, Vec3};
use polhode::model::Body;
use polhode::shape::Shape;
use polhode::{Error, World};

pub(super) const CHECKS: &[Check] = &[
    Check {
        group: Group::Pins,
        name: "pendulum-periods",
        law: "A pinned rod swings in 2π √(I/(m g d)) times the ratio of its amplitude, 1° to 179°, in space and in the plane.",
        measure: periods,
    },
    Check {
        group: Group::Pins,
        name: "pendulum-a01",
        law: "The simple pendulum of benchmark A01 goes as in the reference for 10 s.",
        measure: simple_pendulum,
    },
    Check {
        group: Group::Pins,
        name: "pendulum-conical",
        law: "A pinned ball circles at the tilt θ with Ω² = g/(d cos θ).",
        measure: conical,
    },
    Check {
        group: Group::Pins,
        name: "pendulum-energy",
        law: "A pendulum that falls from the horizontal keeps its energy: an hour of steps loses none.",
        measure: energy,
    },
    Check {
        group: Group::Pins,
        name: "hinge",
        law: "A body pinned at two points swings about the line between them, 2π √(I/(m g d)) times the ratio of 90°.",
        measure: hinge,
    },
    Check {
        group: Group::Pins,
        name: "pin-reaction",
        law: "A pin carries what changes the momentum beyond the weight; a body at rest hangs with its weight on it.",
        measure: reaction,
    },
];

const G: f64 = 9.81;
/// T/T0 of a pendulum that falls from the horizontal.
const RATIO_90: f64 = 1.180340599016096226;

/// Time from the start to where `side`, negative or positive there, is zero first \[s\].
fn time_to_zero(world: &mut World, h: f64, side: impl Fn(&World) -> f64) -> Result<f64, Error> {
    let sign = side(world).signum();
    let mut before = world.state().clone();
    for _ in 0..100_000 {
        before.clone_from(world.state());
        world.step(h);
        if side(world) * sign <= 0.0 {
            break;
        }
    }
    // Regula falsi within the last step, by steps of parts of it; it contracts by more than 10 each time.
    let mut at = |part: f64| -> Result<f64, Error> {
        world.restore(&before)?;
        if part != 0.0 {
            world.step(part);
        }
        Ok(side(world))
    };
    let (mut a, mut b, mut fa, mut fb) = (0.0, h, at(0.0)?, at(h)?);
    for _ in 0..60 {
        let c = b - fb * (b - a) / (fb - fa);
        if !(c.is_finite() && (c - b).abs() > 1e-17 * h) {
            break;
        }
        (a, fa, b) = (b, fb, c);
        fb = at(c)?;
    }
    Ok(before.time + before.time_error + b)
}

/// A rod of 1 m pinned at its end and held at an angle from the downward vertical, and its period at small amplitudes \[s\].
fn rod(subject: Subject, integrator: &str, planar: bool, angle: f64) -> Result<(World, f64), Error> {
    let (mut world, down, axis, shape) = if planar {
        (subject.planar_world(integrator)?, -Vec3::Y, Vec3::Z, Shape::rectangle([0.1, 1.0]))
    } else {
        (subject.world(integrator)?, -Vec3::Z, -Vec3::Y, Shape::cylinder(0.02, 1.0))
    };
    world.set_gravity(down * G)?;
    let id = world
        .add(Body::dynamic().shape(shape.mass(2.0).at(down * 0.5)).rotation(Quat::from_axis_angle(axis, angle)))?;
    world.pin(id, Vec3::ZERO)?;
    let body = world.body(id);
    let inertia = axis.dot(body.inertia() * axis) + body.mass() * 0.25;
    let period = TAU * libm::sqrt(inertia / (body.mass() * G * 0.5));
    Ok((world, period))
}

/// How far the first body's centre is to the side of the vertical \[m\].
fn sideways(world: &World) -> f64 {
    world.bodies().next().map_or(f64::NAN, |b| b.center_of_mass().x)
}

fn periods(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let n = 400.0;
    for (planar, place) in [(false, "in space"), (true, "in the plane")] {
        let mut worst = Worst::default();
        for (degrees, ratio) in reference::pendulum_periods()? {
            let angle = degrees * PI / 180.0;
            let (mut world, period) = rod(subject, "kahan-li8:pdmv10", planar, angle)?;
            let quarter = time_to_zero(&mut world, period / n, sideways)?;
            // The eighth order at 400 steps a period is below rounding; of n/4 times the ratio steps each of 17 stages rounds
            // the energy, which changes the period the more the nearer the amplitude is to 180°.
            let sensitivity = 1.0 + 1.0 / libm::cos(angle / 2.0);
            let tolerance = 4.0 * libm::sqrt(17.0 * n / 4.0 * ratio) * f64::EPSILON * sensitivity;
            worst.see(
                format!("period at {degrees}° over its closed form, minus 1, {place}, kahan-li8:pdmv10"),
                (4.0 * quarter / (period * ratio) - 1.0).abs(),
                tolerance,
                "17 stages in each step of a quarter round as their root, 4 times, enlarged near the upright",
            );
        }
        findings.worst(worst);
    }
    for (integrator, order, n) in [("pdmv6", 2, 200.0), ("suzuki4:pdmv6", 4, 48.0), ("kahan-li6:pdmv6", 6, 32.0)] {
        let name = format!("{integrator}, period at 90°");
        let exact = rod(subject, integrator, false, PI / 2.0)?.1 * RATIO_90;
        // Parts of a step at the end would bend the slope: n is a multiple of 4.
        slope::expect(&mut findings, &name, order, exact / n, |h| {
            let (mut world, _) = rod(subject, integrator, false, PI / 2.0)?;
            Ok((4.0 * time_to_zero(&mut world, h, sideways)? / exact - 1.0).abs())
        })?;
    }
    Ok(findings)
}

/// A ball with the pendulum length of 1 m: I/(m d) + d = 1 with d = 0.5 m.
fn ball_on_pin(subject: Subject, integrator: &str, tilt: f64, w: Vec3) -> Result<World, Error> {
    let (d, inertia) = (0.5, 0.25);
    let mut world = subject.world(integrator)?;
    world.set_gravity([0.0, 0.0, -G])?;
    let properties = MassProperties::new(1.0, [0.0, 0.0, -d], Mat3::diagonal(Vec3::splat(inertia)))?;
    let rot = Quat::from_axis_angle(Vec3::Y, tilt);
    let body = Body::dynamic().mass_properties(properties).rotation(rot).angular_velocity(w);
    let id = world.add(body.velocity(w.cross(rot.rotate(Vec3::new(0.0, 0.0, -d)))))?;
    world.pin(id, Vec3::ZERO)?;
    Ok(world)
}

fn simple_pendulum(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let rows = reference::simple_pendulum()?;
    let error = |integrator: &str, h: f64| -> Result<f64, Error> {
        let mut world = ball_on_pin(subject, integrator, PI / 2.0, Vec3::ZERO)?;
        let mut worst: f64 = 0.0;
        visit(&mut world, h, rows.iter().map(|r| r.0), |row, world| {
            for body in world.bodies() {
                // The point at the end of the pendulum length of 1 m, twice as far as the centre of mass.
                let end = body.center_of_mass() * 2.0;
                let [x, z] = rows[row].1;
                worst = worst.greatest((end - Vec3::new(x, 0.0, z)).length());
            }
        });
        Ok(worst)
    };
    let h = 0.1 / 16.0;
    // 1600 steps, and the swing's angle of 10 s at 2π/2.37 rad/s.
    let tolerance = 4.0 * libm::sqrt(17.0 * 1600.0) * f64::EPSILON * (10.0 * TAU / 2.37);
    let because =
        "the eighth order is below rounding; 17 stages in 1600 steps round as their root, which grows over 27 rad";
    let what = "largest distance from the reference, kahan-li8:pdmv10, h = 6.25 ms [m]";
    findings.at_most(what, error("kahan-li8:pdmv10", h)?, tolerance, because);
    for (integrator, order, h) in [("pdmv6", 2, 0.01), ("suzuki4:pdmv6", 4, 0.02), ("kahan-li6:pdmv6", 6, 0.05)] {
        slope::expect(&mut findings, integrator, order, h, |h| error(integrator, h))?;
    }
    Ok(findings)
}

fn conical(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let (d, tilt) = (0.5, 0.7);
    let rate = libm::sqrt(G / (d * libm::cos(tilt)));
    let error = |integrator: &str, n: f64| -> Result<f64, Error> {
        let mut world = ball_on_pin(subject, integrator, tilt, Vec3::new(0.0, 0.0, rate))?;
        let start = world.bodies().next().map(|b| b.center_of_mass()).unwrap_or_default();
        let mut worst: f64 = 0.0;
        for step in 1..=n as usize {
            world.step(TAU / rate / n);
            let there = Quat::from_axis_angle(Vec3::Z, TAU * step as f64 / n).rotate(start);
            worst = world.bodies().map(|b| (b.center_of_mass() - there).length()).fold(worst, f64::greatest);
        }
        Ok(worst)
    };
    for (integrator, order, n) in [("pdmv6", 2, 100.0), ("suzuki4:pdmv6", 4, 50.0), ("kahan-li6:pdmv6", 6, 30.0)] {
        slope::expect(&mut findings, integrator, order, TAU / rate / n, |h| {
            error(integrator, (TAU / rate / h).round())
        })?;
    }
    let n: f64 = 400.0;
    let because = "the eighth order is below rounding; 17 stages in 400 steps round as their root, which grows over 2π";
    let tolerance = 4.0 * libm::sqrt(17.0 * n) * f64::EPSILON * TAU;
    let what = "largest distance from the circle, kahan-li8:pdmv10, 400 steps a turn [m]";
    findings.at_most(what, error("kahan-li8:pdmv10", n)?, tolerance, because);
    Ok(findings)
}

fn energy(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let (mut world, _) = rod(subject, "pdmv6", false, PI / 2.0)?;
    let start = world.energy().total();
    let (n, h) = (216_000, 1.0 / 60.0);
    let mut quarters = [0.0_f64; 4];
    for step in 0..n {
        world.step(h);
        let quarter = &mut quarters[4 * step / n];
        *quarter = quarter.greatest((world.energy().total() - start).abs());
    }
    // 2 kg whose centre is 0.5 m below the pin.
    let fall = 2.0 * G * 0.5;
    let because = "symplectic: the last quarter is no worse than the first, but for a hundredth by chance of the phase";
    let what = "growth of the energy error from the first to the last quarter of an hour at 60 Hz";
    findings.at_most(what, (quarters[3] / quarters[0] - 1.0).greatest(0.0), 0.01, because);
    // Verlet's modified energy differs from the true one by at most (hΩ)²/4 of what swings, where Ω² is the largest rate of
    // change of the force: m g d/I = 3g/2L for the rod.
    let because = "(hΩ)²/4 of the fall, the share that Verlet's own energy is off, with Ω² = 3g/2L";
    let what = "largest energy error in an hour at 60 Hz, over m g d";
    findings.at_most(what, quarters[0].greatest(quarters[3]) / fall, 0.25 * h * h * 1.5 * G, because);
    Ok(findings)
}

/// A body of no symmetry pinned at two points of the y axis, its centre level with them; its period at 90° \[s\].
fn hinged(subject: Subject, integrator: &str) -> Result<(World, f64), Error> {
    let mut world = subject.world(integrator)?;
    world.set_gravity([0.0, 0.0, -G])?;
    let (m, d) = (2.0, 0.4);
    let inertia = Mat3::from_rows([0.3, 0.05, -0.02].into(), [0.05, 0.2, 0.03].into(), [-0.02, 0.03, 0.25].into());
    let properties = MassProperties::new(m, [d, 0.1, 0.0], inertia)?;
    let id = world.add(Body::dynamic().mass_properties(properties))?;
    world.pin(id, [0.0, -0.3, 0.0])?;
    world.pin(id, [0.0, 0.5, 0.0])?;
    let period = TAU * libm::sqrt((0.2 + m * d * d) / (m * G * d)) * RATIO_90;
    Ok((world, period))
}

fn hinge(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    for (integrator, order, n) in [("pdmv6", 2, 200.0), ("suzuki4:pdmv6", 4, 100.0), ("kahan-li6:pdmv10", 6, 40.0)] {
        let (_, period) = hinged(subject, integrator)?;
        let name = format!("{integrator}, period");
        slope::expect(&mut findings, &name, order, period / n, |h| {
            let (mut world, period) = hinged(subject, integrator)?;
            Ok((4.0 * time_to_zero(&mut world, h, sideways)? / period - 1.0).abs())
        })?;
    }
    let (mut world, _) = hinged(subject, "pdmv6")?;
    let (mut off, mut gap): (f64, f64) = (0.0, 0.0);
    for _ in 0..6000 {
        gap = gap.greatest(world.step(1.0 / 60.0).pins.gap);
        off = world.bodies().map(|b| (b.axes().cols[1] - Vec3::Y).length()).fold(off, f64::greatest);
    }
    let because = "Newton's iteration ends where rounding stops it: a few roundings of lengths below 1 m";
    findings.at_most("largest gap of the pins in 100 s at 60 Hz [m]", gap, 16.0 * f64::EPSILON, because);
    let because = "two gaps over 0.8 m between the pins";
    findings.at_most("largest turn of the hinge's line [rad]", off, 2.0 * 16.0 * f64::EPSILON / 0.8, because);
    Ok(findings)
}

fn reaction(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let (m, weight) = (3.0, Vec3::new(0.0, 0.0, -3.0 * G));
    for pins in [1, 2] {
        let mut world = subject.world("pdmv6")?;
        world.set_gravity(weight / m)?;
        let body = rigid(m, [0.3, 0.4, 0.5])?.rotation(Quat::from_axis_angle(Vec3::X, 1.0));
        let id = world.add(body.angular_velocity([1.0, 2.0, 3.0]))?;
        let mut names = Vec::new();
        for i in 0..pins {
            names.push(world.pin(id, [0.1 + 0.2 * f64::from(i), -0.2, 0.3])?);
        }
        let h = 0.005;
        let (mut error, mut largest): (f64, f64) = (0.0, 0.0);
        for _ in 0..400 {
            let before = world.body(id).momentum();
            world.step(h);
            let carried: Vec3 = names.iter().filter_map(|&pin| world.pin_reaction(pin)).sum();
            let change = world.body(id).momentum() - before;
            error = error.greatest((carried * h - (change - weight * h)).length());
            largest = largest.greatest(change.length() + before.length() + weight.length() * h);
        }
        let because = "half a dozen impulses are added to p and each rounds it once, some 16 roundings with their sums";
        findings.at_most(
            format!("reaction minus change of momentum and weight, {pins} pins [N·s]"),
            error,
            16.0 * f64::EPSILON * largest,
            because,
        );
    }
    let mut world = ball_on_pin(subject, "pdmv6", 0.0, Vec3::ZERO)?;
    steps(&mut world, 100, 1.0 / 60.0);
    let pin = world.model().pin_ids.first().copied();
    let carried = pin.and_then(|pin| world.pin_reaction(pin)).unwrap_or_default();
    let because = "the impulses of a step are added up and divided by it again, some 8 roundings";
    findings.at_most(
        "reaction to a ball at rest, over its weight, minus 1",
        (carried.z / G - 1.0).abs(),
        8.0 * f64::EPSILON,
        because,
    );
    let moved =
        world.bodies().map(|b| (b.center_of_mass() - Vec3::new(0.0, 0.0, -0.5)).length()).fold(0.0, f64::greatest);
    findings.at_most("how far it moved in 100 steps [m]", moved, 0.0, "it hangs from its pin with nothing to move it");
    Ok(findings)
}
