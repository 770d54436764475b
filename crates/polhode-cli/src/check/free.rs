//! Bodies that nothing pushes: attitude, angular momentum, energy.

use super::reference::{self, FreeTop};
use super::scene::{Greatest, rigid, same_bits, steps, visit};
use super::suite::{Check, Findings, Group, Subject, Worst};
use polhode::integrate::Drift;
use polhode::math::{Quat, Vec3};
use polhode::{Error, World};

pub(super) const CHECKS: &[Check] = &[
    Check {
        group: Group::Free,
        name: "free-hv",
        law: "A free top of moments (0.6, 0.8, 1) goes as in the reference, 10 s in steps of 25 ms.",
        measure: |subject| {
            let top = reference::hv()?;
            let bounds = [
                ("pdmv4", 2.2e-5, TWICE),
                ("pdmv6", 3.4e-9, TWICE),
                ("pdmv8", 3.2e-13, TWICE),
                ("pdmv10", 1e-13, "400 steps that each round a few times, 450 ε in all"),
                ("exact", 1e-13, "400 steps that each round a few times, 450 ε in all"),
            ];
            attitudes(subject, &top, 0.025, &bounds)
        },
    },
    Check {
        group: Group::Free,
        name: "free-box",
        law: "The box of the Gazebo benchmark, next to its separatrix, goes as in the reference, 10 s in steps of 25 ms.",
        measure: |subject| {
            let top = reference::gazebo_box()?;
            let bounds = [
                ("pdmv4", 5.6e-4, TWICE),
                ("pdmv6", 5.2e-7, TWICE),
                ("pdmv8", 4.2e-10, TWICE),
                ("pdmv10", 1e-9, "next to the separatrix roundings grow by some 1e5"),
                ("exact", 1e-9, "next to the separatrix roundings grow by some 1e5"),
            ];
            attitudes(subject, &top, 0.025, &bounds)
        },
    },
    Check {
        group: Group::Free,
        name: "free-water",
        law: "The free rotation with the moments of the water molecule, which no rigid body quite has, goes as in the \
              reference, 10 s in steps of 12.5 ms.",
        measure: water,
    },
    Check {
        group: Group::Free,
        name: "free-dzhanibekov",
        law: "A top turning about its middle axis flips as in the reference, 60 s in steps of 0.1 s.",
        measure: |subject| {
            let top = reference::dzhanibekov()?;
            // The flips' times follow from the logarithm of the distance from the separatrix, 1 − m = 2e-6, which a
            // rounding changes by ε, and the unstable rate is 1/√3 a second. 600 independent roundings add up as their root.
            let roundings = 4.0 * libm::sqrt(600.0);
            let rounding = roundings * f64::EPSILON / 2e-6 * libm::sqrt(3.0);
            one_step_bound(&top, 0.1, rounding, |integrator| worst_attitude(subject, &top, integrator, 0.1))
        },
    },
    Check {
        group: Group::Free,
        name: "free-exact",
        law: "The exact solution, from the start to any time in one step, meets every row of the four references.",
        measure: exact_rows,
    },
    Check {
        group: Group::Free,
        name: "free-hard",
        law: "The exact solution is as good as its input next to every limit: symmetric, separatrix, needle, any time.",
        measure: hard_cases,
    },
    Check {
        group: Group::Free,
        name: "free-periods",
        law: "After ten of its periods a free top turns about the same body axis as at the start.",
        measure: periods,
    },
    Check {
        group: Group::Free,
        name: "free-million",
        law: "In a million steps of free flight the angular momentum keeps every bit and the energy 12 digits.",
        measure: million,
    },
];

const TWICE: &str = "twice the error of an independent implementation of the method";

/// A world with the top in it, at the start.
fn with_top(subject: Subject, top: &FreeTop, integrator: &str) -> Result<World, Error> {
    let mut world = subject.world(integrator)?;
    world.add(rigid(1.0, top.inertia)?.angular_velocity(top.w))?;
    Ok(world)
}

fn attitude(world: &World) -> Quat {
    world.bodies().next().map_or(Quat::IDENTITY, |body| body.rotation())
}

/// The largest attitude error over all rows \[rad\].
fn worst_attitude(subject: Subject, top: &FreeTop, integrator: &str, h: f64) -> Result<f64, Error> {
    let mut world = with_top(subject, top, integrator)?;
    let mut worst: f64 = 0.0;
    visit(&mut world, h, top.rows.iter().map(|r| r.0), |row, world| {
        worst = worst.greatest(attitude(world).angle_to(top.rows[row].1));
    });
    Ok(worst)
}

fn attitudes(subject: Subject, top: &FreeTop, h: f64, bounds: &[(&str, f64, &str)]) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    for &(integrator, tolerance, because) in bounds {
        let error = worst_attitude(subject, top, integrator, h)?;
        findings.at_most(format!("largest attitude error, {integrator} [rad]"), error, tolerance, because);
    }
    Ok(findings)
}

/// Worst error of one step among 20 000 random bodies at h|ω| = 0.1 \[rad\].
const ONE_STEP: [(&str, f64); 5] =
    [("pdmv4", 2e-7), ("pdmv6", 1e-10), ("pdmv8", 9e-14), ("pdmv10", 2e-16), ("exact", 2e-16)];

/// Tops that turn by less than 0.1 rad a step: errors of single steps add up, and so do roundings.
fn one_step_bound(
    top: &FreeTop,
    h: f64,
    rounding: f64,
    error: impl Fn(&str) -> Result<f64, Error>,
) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let n = top.rows.last().map_or(0.0, |row| (row.0 / h).round());
    for (integrator, step) in ONE_STEP {
        let tolerance = 2.0 * n * step + rounding;
        let more = match rounding {
            0.0 => String::new(),
            _ => format!(", and roundings that the instability raises to {rounding:.0e}"),
        };
        let because = format!("{n} steps of at most {step:.0e} rad each at h|ω| ≤ 0.1, doubled{more}");
        findings.at_most(format!("largest attitude error, {integrator} [rad]"), error(integrator)?, tolerance, because);
    }
    Ok(findings)
}

/// The free rotation of a top at its start over `time` in `n` steps.
fn rotated(drift: Drift, inertia: Vec3, w: Vec3, time: f64, n: u32) -> Quat {
    let (l, k) = (inertia.scale(w), Vec3::new(1.0 / inertia.x, 1.0 / inertia.y, 1.0 / inertia.z));
    (0..n).fold(Quat::IDENTITY, |rot, _| drift.rotate(rot, l, k, time / f64::from(n)))
}

fn water(subject: Subject) -> Result<Findings, Error> {
    let (top, h) = (reference::water()?, 0.0125);
    one_step_bound(&top, h, 0.0, |integrator| {
        let drift = subject.drift(integrator)?;
        let error = |&(time, attitude, _): &(f64, Quat, Vec3)| {
            rotated(drift, top.inertia, top.w, time, (time / h).round() as u32).angle_to(attitude)
        };
        Ok(top.rows.iter().map(error).fold(0.0, f64::greatest))
    })
}

fn exact_rows(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let drift = subject.drift("exact")?;
    for top in [reference::hv()?, reference::water()?, reference::gazebo_box()?, reference::dzhanibekov()?] {
        let mut worst = Worst::default();
        for &(time, attitude, _) in &top.rows {
            let end = |inertia, w| rotated(drift, inertia, w, time, 1);
            let rot = end(top.inertia, top.w);
            // The attitude change by a relative change of each input, by differences.
            let d = 1e-7;
            let mut condition = 0.0;
            for axis in 0..3 {
                let (mut inertia, mut w) = (top.inertia, top.w);
                inertia[axis] *= 1.0 + d;
                w[axis] *= 1.0 + d;
                condition += (end(inertia, top.w).angle_to(rot) + end(top.inertia, w).angle_to(rot)) / d;
            }
            let because =
                "the inputs are rounded a few times, 4 ε, and the motion enlarges that as is measured beside it";
            let what = format!("attitude error, {}, t = {time} s [rad]", top.name);
            worst.see(what, rot.angle_to(attitude), 4.0 * f64::EPSILON * (1.0 + condition), because);
        }
        findings.worst(worst);
    }
    Ok(findings)
}

fn hard_cases(subject: Subject) -> Result<Findings, Error> {
    let drift = subject.drift("exact")?;
    let mut worst = Worst::default();
    let cases = reference::hard_free_bodies()?;
    for case in &cases {
        let k = Vec3::new(1.0 / case.inertia.x, 1.0 / case.inertia.y, 1.0 / case.inertia.z);
        let rot = drift.rotate(Quat::IDENTITY, case.l, k, case.time);
        let because =
            "reciprocal moments round the input by ε and the formula by a few more, which the motion enlarges";
        let what = format!("attitude error, the worst of {} bodies [rad]", cases.len());
        worst.see(what, rot.angle_to(case.attitude), 4.0 * f64::EPSILON * (1.0 + case.condition), because);
    }
    let mut findings = Findings::default();
    findings.worst(worst);
    Ok(findings)
}

fn periods(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    // 1/(1 − m), from the closed forms: what a relative change of the invariants does to the period, in periods.
    for (top, separatrix) in
        [(reference::hv()?, 1.2), (reference::gazebo_box()?, 7e3), (reference::dzhanibekov()?, 5e5)]
    {
        let time = 10.0 * reference::free_period(top.name)?;
        let angle = time * top.w.length();
        // A step of at most a tenth of a radian, in which the tenth order errs by rounding alone.
        let n = (angle / 0.1).ceil();
        let mut world = with_top(subject, &top, "pdmv10")?;
        steps(&mut world, n as usize, time / n);
        let body_w = world.bodies().next().map_or(Vec3::ZERO, |b| b.rotation().inverse_rotate(b.angular_velocity()));
        let error = (body_w - top.w).length() / top.w.length();
        let tolerance = (4.0 * libm::sqrt(n) + angle) * f64::EPSILON * separatrix;
        let because = format!(
            "the roundings of {n} steps, four times their root, and of the input, once a radian; the distance from the \
             separatrix enlarges them by {separatrix:.0e}"
        );
        findings.at_most(format!("|ω − ω(0)|/|ω|, {}", top.name), error, tolerance, because);
    }
    Ok(findings)
}

fn million(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let (hv, gazebo) = (reference::hv()?, reference::gazebo_box()?);
    for integrator in ["dmv", "pdmv4", "pdmv6", "pdmv8", "pdmv10"] {
        let mut world = with_top(subject, &hv, integrator)?;
        world.add(rigid(10.0, gazebo.inertia)?.angular_velocity(gazebo.w).velocity([1.0, 2.0, 3.0]))?;
        let start = world.state().bodies.l.clone();
        let energies = |world: &World| -> Vec<f64> { world.bodies().map(|b| b.kinetic_energy().1).collect() };
        let before = energies(&world);
        let (mut changed, mut energy): (usize, f64) = (0, 0.0);
        for step in 0..1_000_000 {
            world.step(0.02);
            changed += world.state().bodies.l.iter().zip(&start).filter(|&(&a, &b)| !same_bits(a, b)).count();
            // Every hundredth step is enough for an error that grows slowly.
            if step % 100 == 99 {
                energy = energies(&world)
                    .iter()
                    .zip(&before)
                    .fold(energy, |worst, (e, e0)| worst.greatest((e / e0 - 1.0).abs()));
            }
        }
        findings.none(
            format!("steps after which a bit of L differs, {integrator}"),
            changed,
            "L is the state, and nothing changes it",
        );
        let because =
            "the map conserves the energy, and 1e6 roundings of ε walk to some 1e3 ε, four times which is 1e-12";
        findings.at_most(format!("largest relative change of the energy, {integrator}"), energy, 1e-12, because);
    }
    Ok(findings)
}
