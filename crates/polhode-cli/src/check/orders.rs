//! Every integrator: its order by slope, where nothing pushes, under a torque, and along an orbit; and what it conserves.

use super::orbits::kepler_position;
use super::report::figure;
use super::scene::{Greatest, ball, rigid, same_bits, steps};
use super::slope::{self, ROOM};
use super::suite::{Check, Findings, Group, Subject, Table};
use polhode::field::{Field, Wrench};
use polhode::integrate::{Drift, Integrator};
use polhode::math::{Quat, Vec3};
use polhode::{Error, World};

pub(super) const CHECKS: &[Check] = &[Check {
    group: Group::Free,
    name: "orders",
    law: "Each integrator has its order, for a free top, for a heavy one and along an orbit, and conserves what it claims.",
    measure,
}];

/// What becomes of the energy of a free top.
#[derive(Clone, Copy, PartialEq)]
enum Energy {
    /// Stays, but for rounding.
    Kept,
    /// Swings about a value close to it.
    Bounded,
    /// Goes away.
    Drifts,
}
use Energy::{Bounded, Drifts, Kept};

/// A scheme, its orders and its claims. An order of 0 is exact, or none at all.
struct Scheme {
    name: &'static str,
    /// For a free top, a heavy top, an orbit.
    orders: [u32; 3],
    energy: Energy,
    symmetric: bool,
}

const fn scheme(name: &'static str, orders: [u32; 3], energy: Energy, symmetric: bool) -> Scheme {
    Scheme { name, orders, energy, symmetric }
}

const SCHEMES: [Scheme; 26] = [
    scheme("explicit-euler", [1, 1, 1], Drifts, false),
    scheme("slides", [1, 1, 1], Drifts, false),
    scheme("slides-gram-schmidt", [1, 1, 1], Drifts, false),
    scheme("kick-explicit", [1, 1, 1], Drifts, false),
    scheme("symplectic-euler", [1, 1, 1], Drifts, false),
    scheme("verlet", [1, 1, 2], Drifts, false),
    scheme("buss", [2, 2, 2], Drifts, false),
    scheme("lie-midpoint", [2, 2, 2], Drifts, false),
    scheme("crouch-grossman3", [3, 3, 3], Drifts, false),
    scheme("rk4", [4, 4, 4], Drifts, false),
    scheme("rkmk4", [4, 4, 4], Drifts, false),
    scheme("commutator-free4", [4, 4, 4], Drifts, false),
    scheme("dormand-prince", [0, 0, 0], Drifts, false),
    scheme("implicit-midpoint", [2, 2, 2], Kept, true),
    scheme("splitting", [2, 2, 2], Bounded, true),
    scheme("symmetric-top", [2, 2, 2], Bounded, true),
    scheme("dmv", [2, 2, 2], Kept, true),
    scheme("pdmv4", [4, 2, 2], Kept, true),
    scheme("pdmv6", [6, 2, 2], Kept, true),
    scheme("pdmv8", [8, 2, 2], Kept, true),
    scheme("pdmv10", [10, 2, 2], Kept, true),
    scheme("exact", [0, 2, 2], Kept, true),
    scheme("yoshida4:splitting", [4, 4, 4], Bounded, true),
    scheme("suzuki4:dmv", [4, 4, 4], Kept, true),
    scheme("kahan-li6:splitting", [6, 6, 6], Bounded, true),
    scheme("kahan-li8:splitting", [8, 8, 8], Bounded, true),
];

/// The free top: nearly a plate, which is hard on the high orders [kg·m²].
const INERTIA: Vec3 = Vec3 { x: 0.3, y: 0.75, z: 1.0 };
/// Its angular velocity at the start \[rad/s\].
const W: Vec3 = Vec3 { x: 1.0, y: 2.0, z: -2.0 };

/// How long the errors of an order are followed \[s\].
const TIME: f64 = 2.0;

/// Steps in [`TIME`] at which a scheme of an order is past its first fumbling and well above rounding; half as long, again.
fn n_steps(order: u32, composed: bool) -> usize {
    match (order, composed) {
        (1, _) => 3200,
        (2, _) => 320,
        (3, _) => 160,
        (4, _) => 80,
        (6, true) => 48,
        (_, true) => 16,
        // pDMV divides rotations of more than 0.25 or 0.5 rad, and 28 steps are of 0.23 rad.
        (_, false) => 28,
    }
}

fn measure(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let mut table = Table {
        columns: vec![
            "integrator",
            "free",
            "slope",
            "heavy",
            "slope",
            "orbit",
            "slope",
            "energy change",
            "L changes",
            "return error",
        ],
        note: "Order and slope of the error for a free top, a heavy top and an orbit. Largest relative change of a free \
               top's energy in 10 000 steps of 0.15 rad; steps in which L differs in a bit; attitude error after 200 steps \
               forth and back.",
        ..Table::default()
    };
    let heavy = HeavyPath::new()?;
    for scheme in &SCHEMES {
        let Scheme { name, orders, .. } = *scheme;
        let composed = name.contains(':');
        let mut row = vec![name.to_string()];
        for (motion, &order) in orders.iter().enumerate() {
            let n = n_steps(order, composed);
            let error = |n: usize| match motion {
                0 => free_error(subject, name, n),
                1 => heavy.error(subject, name, n),
                _ => orbit_error(subject, name, n),
            };
            let [motion, where_] = [["free", "free top"], ["heavy", "heavy top"], ["orbit", "orbit"]][motion];
            if order == 0 {
                let error = error(n)?;
                let because = "no order: each step is exact, or adapted, to 1e-13, and 160 of them add up";
                findings.at_most(format!("largest error of {name}, {where_}"), error, 160.0 * 1e-13, because);
                row.extend(["-".to_string(), figure(error)]);
                continue;
            }
            let finer = if order > 8 { n * 5 / 4 } else { 2 * n };
            let errors = [error(n)?, error(finer)?];
            let slope = libm::log(errors[0] / errors[1]) / libm::log(finer as f64 / n as f64);
            let [coarse, fine] = errors.map(figure);
            let what = format!("order of {name}, {motion}: slope {slope:.2} for {order}, errors {coarse} and {fine}");
            findings.at_most(what, (slope - f64::from(order)).abs(), ROOM, slope::WHY);
            row.extend([order.to_string(), format!("{slope:.2}")]);
        }
        conserves(&mut findings, &mut row, subject, scheme)?;
        table.rows.push(row);
    }
    findings.table = Some(table);
    let unlisted = Integrator::names().filter(|(name, _)| SCHEMES.iter().all(|s| s.name != *name)).count();
    findings.none("integrators that this table leaves out", unlisted, "every scheme states its order");
    Ok(findings)
}

fn first(world: &World) -> (Quat, Vec3) {
    world.bodies().next().map_or((Quat::IDENTITY, Vec3::ZERO), |b| (b.rotation(), b.center_of_mass()))
}

/// The largest attitude error against the exact solution \[rad\].
fn free_error(subject: Subject, integrator: &str, n: usize) -> Result<f64, Error> {
    let mut world = free_world(subject, integrator)?;
    let k = Vec3::new(1.0 / INERTIA.x, 1.0 / INERTIA.y, 1.0 / INERTIA.z);
    let h = TIME / n as f64;
    let mut worst: f64 = 0.0;
    for step in 1..=n {
        world.step(h);
        let exact = Drift::Exact.rotate(Quat::IDENTITY, INERTIA.scale(W), k, h * step as f64);
        worst = worst.greatest(first(&world).0.angle_to(exact));
    }
    Ok(worst)
}

fn free_world(subject: Subject, integrator: &str) -> Result<World, Error> {
    let mut world = subject.world(integrator)?;
    world.add(rigid(1.0, INERTIA)?.angular_velocity(W))?;
    Ok(world)
}

/// A top without symmetry under the torque of its weight, and where it goes.
struct HeavyPath {
    /// Attitudes at 1/16 of [`TIME`] and its multiples.
    attitudes: Vec<Quat>,
}

impl HeavyPath {
    const POINTS: usize = 16;

    fn new() -> Result<Self, Error> {
        // 480 steps of the eighth order: (2/480 s · 3 rad/s)^8 is below rounding.
        let mut world = Self::world(Subject::default(), "kahan-li8:exact")?;
        let h = TIME / 480.0;
        let attitudes = (0..Self::POINTS).map(|_| {
            steps(&mut world, 480 / Self::POINTS, h);
            first(&world).0
        });
        Ok(Self { attitudes: attitudes.collect() })
    }
    fn world(subject: Subject, integrator: &str) -> Result<World, Error> {
        let mut world = subject.world(integrator)?;
        world.add(rigid(1.0, [0.6, 0.8, 1.0])?.angular_velocity([0.3, 0.5, 2.0]))?;
        let (center, weight) = (Vec3::new(0.1, 0.0, 0.2), Vec3::new(0.0, 0.0, -9.81));
        world.add_field(Field::conservative(
            move |body| Wrench { force: Vec3::ZERO, torque: body.rot.rotate(center).cross(weight) },
            move |body| -weight.dot(body.rot.rotate(center)),
        ))?;
        Ok(world)
    }
    fn error(&self, subject: Subject, integrator: &str, n: usize) -> Result<f64, Error> {
        let mut world = Self::world(subject, integrator)?;
        // Whole steps between the points at which the path is known.
        let each = n.div_ceil(Self::POINTS);
        let h = TIME / (each * Self::POINTS) as f64;
        let mut worst: f64 = 0.0;
        for attitude in &self.attitudes {
            steps(&mut world, each, h);
            worst = worst.greatest(first(&world).0.angle_to(*attitude));
        }
        Ok(worst)
    }
}

/// The largest distance from the ellipse's point at the time, for a = 1 m, µ = 1 m³/s², e = 0.3 \[m\].
fn orbit_error(subject: Subject, integrator: &str, n: usize) -> Result<f64, Error> {
    let e = 0.3;
    let mut world = subject.world(integrator)?;
    world.add(ball(1.0)?.position([1.0 - e, 0.0, 0.0]).velocity([0.0, libm::sqrt((1.0 + e) / (1.0 - e)), 0.0]))?;
    world.add_field(Field::central([0.0; 3], 1.0))?;
    let h = TIME / n as f64;
    let mut worst: f64 = 0.0;
    for step in 1..=n {
        world.step(h);
        worst = worst.greatest((first(&world).1 - kepler_position(e, h * step as f64)).length());
    }
    Ok(worst)
}

/// What becomes of the energy and of L in 10 000 steps, and of the way back.
fn conserves(findings: &mut Findings, row: &mut Vec<String>, subject: Subject, scheme: &Scheme) -> Result<(), Error> {
    let Scheme { name, energy, symmetric, .. } = *scheme;
    let mut world = free_world(subject, name)?;
    let (l, start) = (world.angular_momentum([0.0; 3]), world.energy().total());
    let (n, h) = (10_000, 0.05);
    let (mut changes, mut halves) = (0, [0.0_f64; 2]);
    for step in 0..n {
        world.step(h);
        changes += usize::from(!same_bits(world.angular_momentum([0.0; 3]), l));
        let half = &mut halves[2 * step / n];
        *half = half.greatest((world.energy().total() / start - 1.0).abs());
    }
    let largest = halves[0].greatest(halves[1]);
    findings.none(format!("steps in which L changes, {name}"), changes, "every scheme has L for its state");
    match energy {
        Kept => {
            let because = "conserved by the scheme: 10 000 steps of rounding are far below the 1e-12 of a million";
            findings.at_most(format!("largest relative change of the energy, {name}"), largest, 1e-12, because);
        }
        Bounded => {
            let because = "no drift: the second half is no worse than the first, but for a tenth by chance of the phase, \
                           and for 1e-12, the rounding of a million steps";
            let what = format!("energy error of the second half beyond 1.1 times that of the first, {name}");
            findings.at_most(what, (halves[1] - 1.1 * halves[0]).greatest(0.0), 1e-12, because);
        }
        Drifts => {}
    }
    let mut back = free_world(subject, name)?;
    let there = 200;
    steps(&mut back, there, h);
    steps(&mut back, there, -h);
    let error = first(&back).0.angle_to(Quat::IDENTITY);
    if symmetric {
        // A rounding in one step becomes a change of speed, and that an angle that grows over the turns left.
        let angle = there as f64 * h * W.length();
        let tolerance = 4.0 * libm::sqrt(2.0 * there as f64) * f64::EPSILON * angle;
        let because = "a symmetric scheme goes back on its way: 400 roundings as their root, each grown over 30 rad";
        findings.at_most(
            format!("attitude error after {there} steps forth and back, {name} [rad]"),
            error,
            tolerance,
            because,
        );
    }
    row.extend([figure(largest), changes.to_string(), figure(error)]);
    Ok(())
}
