//! The centre of mass: the parabola, and the oscillator by which schemes are told apart.

use super::scene::{Greatest, ball, steps};
use super::suite::{Check, Findings, Group, Subject, Worst};
use polhode::field::{Anchor, Field};
use polhode::math::{Mat3, Vec3};
use polhode::store::BodyId;
use polhode::{Error, World};

pub(super) const CHECKS: &[Check] = &[
    Check {
        group: Group::Translation,
        name: "parabola",
        law: "A thrown body goes along its parabola, x = v t + g t²/2, exactly but for rounding, at any time step.",
        measure: parabola,
    },
    Check {
        group: Group::Translation,
        name: "oscillator-growth",
        law: "Explicit Euler lets the amplitude of an oscillator grow by √(1 + h²ω²) in each step.",
        measure: growth,
    },
    Check {
        group: Group::Translation,
        name: "oscillator-invariants",
        law: "Symplectic Euler keeps v² + ω²x² − hω²xv and Verlet v² + ω²x²(1 − h²ω²/4): their energy swings and stays.",
        measure: invariants,
    },
    Check {
        group: Group::Translation,
        name: "oscillator-phase",
        law: "Verlet's oscillator is x = A cos nθ with cos θ = 1 − h²ω²/2, exactly.",
        measure: phase,
    },
    Check {
        group: Group::Translation,
        name: "matrix-drift",
        law: "Explicit Euler on the matrix R, at 10 rad/s and 60 Hz, stretches the columns across ω to 3.71e3 in 10 s; \
              Gram–Schmidt does not let it, and other schemes need no such repair.",
        measure: matrix_drift,
    },
];

fn parabola(subject: Subject) -> Result<Findings, Error> {
    let mut worst: [Worst; 2] = Default::default();
    let (v, g) = (Vec3::new(3.0, -2.0, 20.0), Vec3::new(0.1, 0.2, -9.81));
    for h in [1e-4, 1.0 / 240.0, 1.0 / 60.0, 0.1, 0.37, 1.0 / 3.0, 1.7, 10.0] {
        let mut world = subject.world("pdmv6")?;
        world.set_gravity(g)?;
        let body = ball(2.5)?.velocity(v).angular_velocity([0.3, 2.0, 0.1]);
        let id = world.add(body)?;
        let n = (10.0_f64 / h).round().greatest(1.0);
        steps(&mut world, n as usize, h);
        let t = n * h;
        let (x, speed) = (v * t + g * (0.5 * t * t), (v + g * t).length().greatest(v.length()));
        // Half a rounding of x a step; half of one of v a kick, of which there are two, which lasts to the end.
        let rounding = (n + 4.0) * f64::EPSILON;
        let body = world.body(id);
        let [position, velocity] = &mut worst;
        position.see(
            format!("distance from the parabola after {n} steps of {h} s [m]"),
            (body.center_of_mass() - x).length(),
            rounding * (x.length().greatest(v.length() * t) + t * speed),
            "half a rounding of x in each step, two of v, and these carried on to the end",
        );
        velocity.see(
            format!("velocity after {n} steps of {h} s [m/s]"),
            (body.velocity() - (v + g * t)).length(),
            rounding * speed,
            "half a rounding of v in each of two kicks a step",
        );
    }
    let mut findings = Findings::default();
    for worst in worst {
        findings.worst(worst);
    }
    Ok(findings)
}

/// Angular frequency of the oscillator \[rad/s\].
const FREQUENCY: f64 = 4.0;

/// A mass of 2 kg on a spring, 1 m from where it would rest.
fn oscillator(subject: Subject, integrator: &str) -> Result<(World, BodyId), Error> {
    let mass = 2.0;
    let mut world = subject.world(integrator)?;
    let id = world.add(ball(mass)?.position([1.0, 0.0, 0.0]))?;
    let (fixed, end) = (Anchor::world([0.0; 3]), Anchor::on(id, [0.0; 3]));
    world.add_field(Field::spring(fixed, end, mass * FREQUENCY * FREQUENCY, 0.0))?;
    Ok((world, id))
}

fn growth(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    for integrator in ["explicit-euler", "kick-explicit", "slides"] {
        let mut worst = Worst::default();
        for h in [1e-3, 1.0 / 60.0, 0.1] {
            let (mut world, _) = oscillator(subject, integrator)?;
            let n: usize = 1000;
            let before = world.energy().total();
            steps(&mut world, n, h);
            let amplitude = libm::sqrt(world.energy().total() / before);
            let expected = libm::pow(1.0 + h * h * FREQUENCY * FREQUENCY, 0.5 * n as f64);
            worst.see(
                format!(
                    "amplitude after {n} steps of {h} s over its closed form, {expected:.4e}, minus 1, {integrator}"
                ),
                (amplitude / expected - 1.0).abs(),
                4.0 * n as f64 * f64::EPSILON,
                "each step rounds x and v twice",
            );
        }
        findings.worst(worst);
    }
    Ok(findings)
}

fn invariants(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let (n, h): (usize, f64) = (100_000, 1.0 / 60.0);
    let (w, hw) = (FREQUENCY, h * FREQUENCY);
    for (integrator, name) in [("symplectic-euler", "symplectic Euler"), ("pdmv6", "Verlet")] {
        let (mut world, id) = oscillator(subject, integrator)?;
        let symplectic_euler = integrator == "symplectic-euler";
        let of = |world: &World| {
            let body = world.body(id);
            let (x, v) = (body.center_of_mass().x, body.velocity().x);
            let kept = if symplectic_euler {
                v * v + w * w * x * x - hw * w * x * v
            } else {
                v * v + w * w * x * x * (1.0 - hw * hw / 4.0)
            };
            (kept, v * v + w * w * x * x)
        };
        let start = of(&world);
        let (mut change, mut swing): (f64, f64) = (0.0, 0.0);
        for _ in 0..n {
            world.step(h);
            let (kept, energy) = of(&world);
            change = change.greatest((kept / start.0 - 1.0).abs());
            swing = swing.greatest((energy / start.1 - 1.0).abs());
        }
        findings.at_most(
            format!("largest relative change of the invariant of {name} in {n} steps"),
            change,
            4.0 * n as f64 * f64::EPSILON,
            "each step rounds x and v twice",
        );
        // The invariant is a quadratic form between (1 − b) and (1 + b) times the energy.
        let b = if symplectic_euler { 0.5 * hw } else { 0.25 * hw * hw };
        findings.at_most(
            format!("largest relative swing of the energy of {name} in {n} steps"),
            swing,
            2.0 * b / (1.0 - b),
            format!("the invariant lies within 1 ± {b:.1e} of the energy, at the start and now"),
        );
    }
    Ok(findings)
}

fn phase(subject: Subject) -> Result<Findings, Error> {
    let mut worst = Worst::default();
    for h in [1.0 / 60.0, 0.1, 0.3] {
        let (mut world, id) = oscillator(subject, "pdmv6")?;
        let theta = libm::acos(1.0 - 0.5 * h * h * FREQUENCY * FREQUENCY);
        let (mut largest, n): (f64, usize) = (0.0, 1000);
        for step in 1..=n {
            world.step(h);
            let expected = libm::cos(step as f64 * theta);
            largest = largest.greatest((world.body(id).center_of_mass().x - expected).abs());
        }
        // A rounding of x or v is a change of phase and amplitude, which stays; the angle nθ is rounded as well, and θ is
        // the worse known the smaller it is.
        let tolerance = n as f64 * f64::EPSILON * (4.0 + theta + 1.0 / libm::sin(theta));
        let what = format!("largest distance from A cos nθ in {n} steps of {h} s [m]");
        worst.see(what, largest, tolerance, "each step rounds x and v twice, and the angle nθ with its cosine once");
    }
    let mut findings = Findings::default();
    findings.worst(worst);
    Ok(findings)
}

fn matrix_drift(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let (n, h, w): (usize, f64, f64) = (600, 1.0 / 60.0, 10.0);
    let spinning = |integrator: &str| -> Result<(World, BodyId), Error> {
        let mut world = subject.world(integrator)?;
        let id = world.add(super::scene::rigid(1.0, [0.6, 0.8, 1.0])?.angular_velocity([0.0, 0.0, w]))?;
        steps(&mut world, n, h);
        Ok((world, id))
    };
    let off = |r: Mat3| (r.transposed() * r - Mat3::IDENTITY).max_abs();
    let missing = || Error::new("integrator", "keeps no matrix that could drift");

    let (world, id) = spinning("slides")?;
    let r = world.drifting_matrix(id).ok_or_else(missing)?;
    let expected = libm::pow(1.0 + h * h * w * w, 0.5 * n as f64);
    let tolerance = 4.0 * n as f64 * f64::EPSILON;
    for (name, column) in [("first", r.cols[0]), ("second", r.cols[1])] {
        findings.at_most(
            format!(
                "length of the {name} column, {:.4e}, over (1 + 1/36)^300 = {expected:.4e}, minus 1",
                column.length()
            ),
            (column.length() / expected - 1.0).abs(),
            tolerance,
            "600 steps round the column twice each",
        );
    }
    findings.at_most(
        "length of the column along ω, minus 1",
        (r.cols[2].length() - 1.0).abs(),
        tolerance,
        "nothing moves it but rounding",
    );
    let (world, id) = spinning("slides-gram-schmidt")?;
    let r = world.drifting_matrix(id).ok_or_else(missing)?;
    let because = "made orthonormal after each step: only the last one's roundings are left";
    findings.at_most("‖RᵀR − 1‖ after 10 s with Gram–Schmidt", off(r), 8.0 * f64::EPSILON, because);
    let (world, id) = spinning("pdmv6")?;
    let r = world.body(id).axes();
    let because = "a unit quaternion is a rotation: its norm is renewed in each step";
    findings.at_most("‖RᵀR − 1‖ after 10 s of pDMV", off(r), 8.0 * f64::EPSILON, because);
    Ok(findings)
}
