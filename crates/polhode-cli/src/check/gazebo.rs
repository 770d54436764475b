//! The published benchmark "boxes" of S. Peters and J. Hsu for the engines of Gazebo: a free box, simple and complex.

use super::reference;
use super::report::figure;
use super::scene::{Greatest, visit};
use super::suite::{Check, Findings, Group, Subject, Table, Worst};
use polhode::math::{Quat, Vec3};
use polhode::model::Body;
use polhode::shape::Shape;
use polhode::{Error, World};
use std::time::Instant;

pub(super) const CHECKS: &[Check] = &[Check {
    group: Group::Free,
    name: "gazebo",
    law: "The published Gazebo benchmark \"boxes\": a box of 10 kg flies for 10 s; its centre goes along a parabola, its \
          angular momentum and energy stay, its attitude is known.",
    measure,
}];

/// One of the two scenarios.
struct Scenario {
    name: &'static str,
    gravity: Vec3,
    v: Vec3,
    w: Vec3,
    /// Times \[s\] and attitudes.
    attitudes: Vec<(f64, Quat)>,
    /// Energy at the start, where height is measured from \[J\].
    start_energy: f64,
    /// What roundings are enlarged by: 1, or 1/(1 − m) next to a separatrix.
    sensitivity: f64,
}

fn scenarios() -> Result<[Scenario; 2], Error> {
    let simple = |i: u32| (0.1 * f64::from(i), Quat::from_axis_angle(Vec3::X, 0.05 * f64::from(i)));
    Ok([
        Scenario {
            name: "simple",
            gravity: Vec3::ZERO,
            v: Vec3::new(-0.9, 0.4, 0.1),
            w: Vec3::new(0.5, 0.0, 0.0),
            attitudes: (0..=100).map(simple).collect(),
            start_energy: 5.0,
            sensitivity: 1.0,
        },
        Scenario {
            name: "complex",
            gravity: Vec3::new(0.0, 0.0, -9.8),
            v: Vec3::new(-2.0, 2.0, 8.0),
            w: Vec3::new(0.1, 5.0, 0.1),
            attitudes: reference::gazebo_box()?.rows.iter().map(|&(time, rot, _)| (time, rot)).collect(),
            start_energy: 368.5,
            sensitivity: 7e3,
        },
    ])
}

/// The largest errors of a flight.
#[derive(Default)]
struct Errors {
    position: f64,
    velocity: f64,
    angle: f64,
    /// Relative.
    l: f64,
    /// Relative.
    energy: f64,
    /// Wall time over simulated time.
    ratio: f64,
}

fn fly(subject: Subject, scenario: &Scenario, integrator: &str, dt: f64) -> Result<Errors, Error> {
    let mut world = subject.world(integrator)?;
    world.set_gravity(scenario.gravity)?;
    let shape = Shape::cuboid([0.1, 0.4, 0.9]).mass(10.0);
    let id = world.add(Body::dynamic().shape(shape).velocity(scenario.v).angular_velocity(scenario.w))?;
    let (l, energy) = (world.body(id).angular_momentum(), world.energy().total());
    let mut e = Errors::default();
    let see = |row: usize, world: &World| {
        let (time, attitude) = scenario.attitudes[row];
        let (v, t) = (scenario.v, time);
        let body = world.body(id);
        let x = v * t + scenario.gravity * (0.5 * t * t);
        e.position = e.position.greatest((body.center_of_mass() - x).length());
        e.velocity = e.velocity.greatest((body.velocity() - (v + scenario.gravity * t)).length());
        e.angle = e.angle.greatest(body.rotation().angle_to(attitude));
        e.l = e.l.greatest((body.angular_momentum() - l).length() / l.length());
        e.energy = e.energy.greatest((world.energy().total() / energy - 1.0).abs());
    };
    let start = Instant::now();
    visit(&mut world, dt, scenario.attitudes.iter().map(|a| a.0), see);
    e.ratio = start.elapsed().as_secs_f64() / world.time();
    Ok(e)
}

fn measure(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let mut table = Table {
        columns: vec![
            "scenario",
            "integrator",
            "dt [s]",
            "position [m]",
            "velocity [m/s]",
            "angle [rad]",
            "|L|",
            "energy",
            "wall/sim",
        ],
        note: "Largest errors over 10 s; of |L| and the energy relative. wall/sim: the time it took over the time it covers.",
        ..Table::default()
    };
    for scenario in &scenarios()? {
        let mut worst: [Worst; 5] = Default::default();
        for integrator in ["pdmv6", "pdmv10"] {
            for dt in [1e-4, 1e-3, 0.005, 0.01, 0.025] {
                let e = fly(subject, scenario, integrator, dt)?;
                bound(&mut worst, scenario, integrator, dt, &e);
                let mut row = vec![scenario.name.to_string(), integrator.to_string(), dt.to_string()];
                row.extend([e.position, e.velocity, e.angle, e.l, e.energy, e.ratio].map(figure));
                table.rows.push(row);
            }
        }
        for worst in worst {
            findings.worst(worst);
        }
    }
    findings.table = Some(table);
    Ok(findings)
}

/// Compares the errors with what rounding and the method may do.
fn bound(worst: &mut [Worst; 5], scenario: &Scenario, integrator: &str, dt: f64, e: &Errors) {
    let case = format!("{}, {integrator}, dt = {dt} s", scenario.name);
    let [position, velocity, angle, momentum, energy] = worst;
    let n = 10.0 / dt;
    let g = scenario.gravity.length();
    let v = (scenario.v + scenario.gravity * 10.0).length().greatest(scenario.v.length());
    let roundings = (0.5 * n + 4.0) * f64::EPSILON;
    let (dv, dx) = (roundings * v, roundings * 2.0 * (10.0 * v));
    position.see(
        format!("position, {case} [m]"),
        e.position,
        dx,
        "the parabola is exact but for half a rounding of x, and 10 s of one of v, in each step",
    );
    velocity.see(format!("velocity, {case} [m/s]"), e.velocity, dv, "half a rounding of v in each step");
    let rounding = 8.0 * libm::sqrt(n) * f64::EPSILON * scenario.sensitivity;
    // The largest step has the error of the method, the others less by its order.
    let (order, largest) = if integrator == "pdmv10" { (10.0, 1e-9) } else { (6.0, 5.2e-7) };
    angle.see(
        format!("angle, {case} [rad]"),
        e.angle,
        largest * libm::pow(dt / 0.025, order) + rounding,
        format!("the bound of dt = 25 ms by the method's order, and the roundings of {n} steps: {rounding:.0e} rad"),
    );
    momentum.see(format!("relative error of |L|, {case}"), e.l, 0.0, "no torque, so not a bit changes");
    let (mass, start) = (10.0, scenario.start_energy);
    energy.see(
        format!("relative error of the energy, {case}"),
        e.energy,
        mass * (v * dv + g * dx) / start + 2.0 * roundings,
        "what the roundings of v and x are worth, and those of the attitude",
    );
}
