//! Tops in gravity: Brüls' top as a body with a pinned point, Lagrange's as a rotation about its fixed point.

use super::reference::{self, HeavyTop};
use super::report::figure;
use super::scene::{Greatest, steps, visit};
use super::slope;
use super::suite::{Check, Findings, Group, Subject, Table};
use polhode::field::{Field, Wrench};
use polhode::mass::MassProperties;
use polhode::math::{Mat3, Vec3};
use polhode::model::Body;
use polhode::{Error, World};

pub(super) const CHECKS: &[Check] = &[
    Check {
        group: Group::Heavy,
        name: "heavy-bruls",
        law: "Brüls' fast top, a body pinned at a point, goes as in the reference, 2 s in steps of 1 ms.",
        measure: bruls,
    },
    Check {
        group: Group::Heavy,
        name: "heavy-bruls-twice",
        law: "The same top pinned twice in one point, which leaves redundant rows to RATTLE, goes the same way.",
        measure: bruls_twice,
    },
    Check {
        group: Group::Heavy,
        name: "heavy-lagrange",
        law: "Lagrange's top released at 30°, as a rotation about its fixed point, goes as in the reference for 10 s.",
        measure: lagrange,
    },
];

/// Brüls' top at its start, with so many pins in its fixed point.
fn pinned_top(subject: Subject, top: &HeavyTop, integrator: &str, pins: usize) -> Result<World, Error> {
    let mut world = subject.world(integrator)?;
    world.set_gravity([0.0, 0.0, -top.gravity])?;
    let c = top.center;
    // Parallel axes, from the fixed point to the centre of mass.
    let about_center = Mat3::diagonal(top.inertia)
        - (Mat3::diagonal(Vec3::splat(c.length_squared())) - Mat3::outer(c, c)).scaled(top.mass);
    let body = Body::dynamic()
        .mass_properties(MassProperties::new(top.mass, c, about_center)?)
        .angular_velocity(top.w)
        .velocity(top.w.cross(c));
    let id = world.add(body)?;
    for _ in 0..pins {
        world.pin(id, Vec3::ZERO)?;
    }
    Ok(world)
}

/// The largest distance of the centre of mass from the reference up to a time \[m\].
fn bruls_error(
    subject: Subject,
    top: &HeavyTop,
    integrator: &str,
    pins: usize,
    h: f64,
    end: f64,
) -> Result<f64, Error> {
    let mut world = pinned_top(subject, top, integrator, pins)?;
    let mut worst: f64 = 0.0;
    visit(&mut world, h, top.rows.iter().map(|r| r.0).take_while(|&t| t <= end), |row, world| {
        for body in world.bodies() {
            worst = worst.greatest((body.center_of_mass() - top.rows[row].2).length());
        }
    });
    Ok(worst)
}

fn bruls(subject: Subject) -> Result<Findings, Error> {
    let top = reference::bruls()?;
    let mut findings = Findings::default();
    let bounds = [
        ("pdmv10", 1e-5, "twice the attitude error of an independent implementation, 4.6e-6 rad, over an arm of 1 m"),
        ("suzuki4:pdmv10", 1e-10, "required of this benchmark: the fourth order, of which the second misses 1e4 times"),
        ("kahan-li6:pdmv10", 1.4e-12, TWICE),
        ("kahan-li8:pdmv10", 8e-12, TWICE),
    ];
    for (integrator, tolerance, because) in bounds {
        let error = bruls_error(subject, &top, integrator, 1, 1e-3, 2.0)?;
        findings.at_most(format!("largest error of the centre of mass, {integrator} [m]"), error, tolerance, because);
    }
    for (integrator, order, h) in [("pdmv10", 2, 2e-3), ("suzuki4:pdmv10", 4, 4e-3)] {
        slope::expect(&mut findings, integrator, order, h, |h| bruls_error(subject, &top, integrator, 1, h, 2.0))?;
    }
    for (integrator, tolerance, because) in [("pdmv10", 3e-7, TWICE), ("suzuki4:pdmv10", 1.8e-13, TWICE)] {
        let mut world = pinned_top(subject, &top, integrator, 1)?;
        let (energy, vertical) = (world.energy().total(), world.angular_momentum([0.0; 3]).z);
        let (mut worst_energy, mut worst_vertical): (f64, f64) = (0.0, 0.0);
        visit(&mut world, 1e-3, (1..=2000).map(|i| f64::from(i) * 1e-3), |_, world| {
            worst_energy = worst_energy.greatest((world.energy().total() / energy - 1.0).abs());
            worst_vertical = worst_vertical.greatest((world.angular_momentum([0.0; 3]).z - vertical).abs());
        });
        findings.at_most(
            format!("largest relative change of the energy, {integrator}"),
            worst_energy,
            tolerance,
            because,
        );
        // About the fixed point L has the length of the spin about the axis and of the swing across it.
        let size = top.inertia.scale(top.w).length();
        findings.at_most(
            format!("largest change of L_z about the pin, {integrator} [kg·m²/s]"),
            worst_vertical,
            2000.0 * f64::EPSILON * size,
            "neither weight nor pin has a torque about the vertical: 2000 steps round |L| by ε each",
        );
    }
    Ok(findings)
}

const TWICE: &str = "twice the error of an independent implementation of the method";

fn bruls_twice(subject: Subject) -> Result<Findings, Error> {
    let top = reference::bruls()?;
    let mut findings = Findings::default();
    let end = 0.5;
    for (integrator, order, h) in [("pdmv10", 2, 5e-4), ("suzuki4:pdmv10", 4, 1e-3)] {
        slope::expect(&mut findings, integrator, order, h, |h| bruls_error(subject, &top, integrator, 2, h, end))?;
        let apart = |h: f64| -> Result<f64, Error> {
            let mut once = pinned_top(subject, &top, integrator, 1)?;
            let mut twice = pinned_top(subject, &top, integrator, 2)?;
            let n = (end / h).round() as usize;
            steps(&mut once, n, h);
            steps(&mut twice, n, h);
            let gap =
                once.bodies().zip(twice.bodies()).map(|(a, b)| (a.center_of_mass() - b.center_of_mass()).length());
            Ok(gap.fold(0.0, f64::greatest))
        };
        let (coarse, fine) = (apart(1e-3)?, apart(1.25e-4)?);
        findings.at_most(
            format!("distance between the tops pinned once and twice, {integrator}, h = 0.125 ms [m]"),
            fine,
            2.0 * coarse / libm::pow(8.0, f64::from(order)),
            format!("twice the {coarse:.1e} m of h = 1 ms, over 8 to the power of the order: it vanishes with h"),
        );
    }
    let mut world = pinned_top(subject, &top, "pdmv10", 2)?;
    let mut gap: f64 = 0.0;
    for _ in 0..2000 {
        gap = gap.greatest(world.step(1e-3).pins.gap);
    }
    let because = "Newton's iteration ends at rounding: a few roundings of an arm of 1 m";
    findings.at_most("largest gap of the pins, h = 1 ms [m]", gap, 16.0 * f64::EPSILON, because);
    Ok(findings)
}

/// Lagrange's top at its start: what turns it is the torque of its weight about the fixed point.
fn turning_top(subject: Subject, top: &HeavyTop, integrator: &str) -> Result<World, Error> {
    let mut world = subject.world(integrator)?;
    let start = top.rows.first().map(|row| row.1).unwrap_or_default();
    let properties = MassProperties::new(top.mass, Vec3::ZERO, Mat3::diagonal(top.inertia))?;
    let body = Body::dynamic().mass_properties(properties).rotation(start).angular_velocity(start.rotate(top.w));
    world.add(body)?;
    let (center, weight) = (top.center, Vec3::new(0.0, 0.0, -top.mass * top.gravity));
    world.add_field(Field::conservative(
        move |body| Wrench { force: Vec3::ZERO, torque: body.rot.rotate(center).cross(weight) },
        move |body| -weight.dot(body.rot.rotate(center)),
    ))?;
    Ok(world)
}

/// The largest attitude error over all rows \[rad\].
pub(super) fn lagrange_error(
    subject: Subject,
    top: &HeavyTop,
    integrator: &str,
    h: f64,
    end: f64,
) -> Result<f64, Error> {
    let mut world = turning_top(subject, top, integrator)?;
    let mut worst: f64 = 0.0;
    visit(&mut world, h, top.rows.iter().map(|r| r.0).take_while(|&t| t <= end), |row, world| {
        for body in world.bodies() {
            worst = worst.greatest(body.rotation().angle_to(top.rows[row].1));
        }
    });
    Ok(worst)
}

fn lagrange(subject: Subject) -> Result<Findings, Error> {
    let top = reference::lagrange()?;
    let mut findings = Findings::default();
    let bounds = [
        ("splitting", 8.4e-3),
        ("pdmv4", 1.84e-1),
        ("pdmv10", 4.4e-4),
        ("suzuki4:pdmv10", 1.04e-7),
        ("kahan-li6:pdmv10", 8e-10),
        ("kahan-li8:pdmv10", 2e-12),
    ];
    for (integrator, tolerance) in bounds {
        let error = lagrange_error(subject, &top, integrator, 0.01, 10.0)?;
        let what = format!("largest attitude error, {integrator}, h = 10 ms [rad]");
        findings.at_most(what, error, tolerance, TWICE);
    }
    let orders =
        [("pdmv10", 2, 0.02), ("suzuki4:pdmv10", 4, 0.02), ("kahan-li6:pdmv10", 6, 0.025), ("kahan-li8:exact", 8, 0.1)];
    for (integrator, order, h) in orders {
        slope::expect(&mut findings, integrator, order, h, |h| lagrange_error(subject, &top, integrator, h, 10.0))?;
    }
    let mut table = Table {
        columns: vec!["attitude error [rad]", "h = 50 ms", "25 ms", "12.5 ms", "10 ms", "5 ms", "2.5 ms"],
        note: "Largest error over 10 s. A turn is 157 ms long.",
        ..Table::default()
    };
    for (integrator, _) in bounds {
        let mut row = vec![integrator.to_string()];
        for h in [0.05, 0.025, 0.0125, 0.01, 0.005, 0.0025] {
            row.push(figure(lagrange_error(subject, &top, integrator, h, 10.0)?));
        }
        table.rows.push(row);
    }
    findings.table = Some(table);
    Ok(findings)
}
