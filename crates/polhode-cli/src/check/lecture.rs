//! Statements of the lecture, in their right form: the number in a name is that of the slide.

use super::mass::grid;
use super::scene::{Greatest, ball, rigid, steps};
use super::slope;
use super::suite::{Check, Findings, Group, Subject, Worst};
use core::f64::consts::TAU;
use polhode::field::{Field, Wrench};
use polhode::mass::{MassProperties, Particle};
use polhode::math::curve::Frenet;
use polhode::math::{Mat3, Quat, Vec3};
use polhode::model::Body;
use polhode::shape::Shape;
use polhode::store::BodyId;
use polhode::{Error, World};

pub(super) const CHECKS: &[Check] = &[
    Check {
        group: Group::Lecture,
        name: "lecture-04-rigid",
        law: "The points of a rigid body keep their distances, over a million steps (slide 4).",
        measure: rigid_distances,
    },
    Check {
        group: Group::Lecture,
        name: "lecture-16-path",
        law: "On a helix of radius a and rise b a radian k = a/(a² + b²) and τ = b/(a² + b²); at rest and on a line there is \
              no frame (slides 10, 11, 16, 18).",
        measure: path,
    },
    Check {
        group: Group::Lecture,
        name: "lecture-21-velocity",
        law: "A point of a body moves at v + ω × r, its axes at ω × T, ω × N, ω × B, and it accelerates by the second \
              derivative of its path (slides 9, 21 to 24).",
        measure: point_velocity,
    },
    Check {
        group: Group::Lecture,
        name: "lecture-25-frames",
        law: "Seen from a turning frame a free body obeys −2 Ω × v − Ω × (Ω × r), Coriolis' and the centrifugal force (slide 25).",
        measure: turning_frame,
    },
    Check {
        group: Group::Lecture,
        name: "lecture-28-torque",
        law: "Torque is Σ (r − x) × F: with r along x and F along y it is along +z, and forces sum to one wrench (slides 28, 31, 56).",
        measure: torque,
    },
    Check {
        group: Group::Lecture,
        name: "lecture-29-gyroscope",
        law: "Torque is the rate of L, not the axis of rotation: a spinning top goes round the vertical at constant tilt (slide 29).",
        measure: gyroscope,
    },
    Check {
        group: Group::Lecture,
        name: "lecture-35-momentum",
        law: "Σ m r × v of the particles is x × M v + L about any origin, and L = J ω with J = R J₀ Rᵀ (slides 32, 35, 52, 53).",
        measure: angular_momentum,
    },
    Check {
        group: Group::Lecture,
        name: "lecture-40-puck",
        law: "A kick J moves the centre of a puck by J/m wherever it hits, and spins it by r × J over I (slides 40, 48, 54, 55).",
        measure: puck,
    },
];

/// Some turned, tumbling body.
fn tumbling() -> Result<Body, Error> {
    let rot = Quat::from_rotation_vector(Vec3::new(0.4, -1.0, 0.7));
    Ok(rigid(2.0, [0.3, 0.5, 0.6])?.rotation(rot).velocity([0.3, -0.2, 0.5]).angular_velocity([1.0, 2.0, -0.5]))
}

fn rigid_distances(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let mut world = subject.world("pdmv6")?;
    let id = world.add(tumbling()?.velocity([0.0; 3]))?;
    let points = [[0.5, 0.0, 0.0], [0.0, 0.7, 0.1], [-0.3, 0.2, 0.6], [0.1, -0.8, -0.2]].map(Vec3::from);
    // The drifting matrix where there is one: that is what the slides take for the orientation.
    let place = |world: &World, point: Vec3| match world.drifting_matrix(id) {
        Some(r) => world.body(id).center_of_mass() + r * point,
        None => world.body(id).point(point),
    };
    let distances = |world: &World| -> Vec<f64> {
        let at = points.map(|point| place(world, point));
        (0..4).flat_map(|i| (0..i).map(move |j| (at[i] - at[j]).length())).collect()
    };
    let start = distances(&world);
    let mut worst: f64 = 0.0;
    for step in 0..1_000_000 {
        world.step(0.01);
        if step % 100 == 99 {
            let now = distances(&world);
            worst = now.iter().zip(&start).map(|(a, b)| (a - b).abs()).fold(worst, f64::greatest);
        }
    }
    let because =
        "a unit quaternion, renewed in each step, stretches what it turns by some ε and no more with time: 450 ε";
    findings.at_most("largest change of a distance in 1e6 steps [m]", worst, 1e-13, because);
    Ok(findings)
}

fn path(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let (radius, rise, turning) = (0.5, 0.3, Vec3::new(0.0, 0.0, 2.0));
    let mut world = subject.world("rk4")?;
    // F = m Ω × v turns the velocity and keeps its length, as a magnet does to a charge.
    world.add_field(Field::custom(move |body| Wrench {
        force: turning.cross(body.v) * body.mass,
        torque: Vec3::ZERO,
    }))?;
    let body = tumbling()?.position([radius, 0.0, 0.0]);
    let id = world.add(body.velocity(Vec3::new(0.0, radius, rise) * turning.z))?;
    let (n, h) = (10_000, 1e-3);
    let (mut bend, mut screw, mut square, mut apart): (f64, f64, f64, f64) = (0.0, 0.0, 0.0, 0.0);
    let size = radius * radius + rise * rise;
    let nothing = (f64::NAN, f64::NAN, [Vec3::splat(f64::NAN); 3]);
    for _ in 0..n {
        world.step(h);
        let body = world.body(id);
        let a = body.acceleration().0;
        let frame = Frenet::new(body.velocity(), a, turning.cross(a), 0.0);
        let axes = [frame.tangent, frame.normal, frame.binormal];
        let (k, torsion, [t, n, b]) = match (frame.curvature, frame.torsion, axes) {
            (Some(k), Some(torsion), [Some(t), Some(n), Some(b)]) => (k, torsion, [t, n, b]),
            _ => nothing,
        };
        bend = bend.greatest((k * size / radius - 1.0).abs());
        screw = screw.greatest((torsion * size / rise - 1.0).abs());
        square = square.greatest((Mat3::from_cols(t, n, b).determinant() - 1.0).abs());
        let of_body = body.axes();
        apart = apart.greatest(of_body.cols[0].cross(t).length());
    }
    // (hΩ)⁵/120 a step is 3e-16 of v.
    let rounding = 4.0 * f64::from(n) * f64::EPSILON;
    let because = "10 000 steps round v a few times each, and the fourth order errs by less";
    findings.at_most("largest relative error of the curvature", bend, rounding, because);
    findings.at_most("largest relative error of the torsion", screw, rounding, because);
    let because = "three unit vectors of a few roundings each";
    findings.at_most("largest difference of det [T N B] from 1", square, 16.0 * f64::EPSILON, because);
    let because =
        "the frame is of the path and not of the body, whose axis at some time is across T by more than half a radian";
    findings.at_most("sin 0.5 over that of the largest angle of an axis to T", libm::sin(0.5) / apart, 1.0, because);
    let (still, line) = (Frenet::new(Vec3::ZERO, Vec3::X, Vec3::Y, 0.0), Frenet::new(Vec3::X, Vec3::X, Vec3::Y, 0.0));
    let there = [still.tangent, still.normal, still.binormal, line.normal, line.binormal];
    let count = there.iter().filter(|v| v.is_some()).count();
    findings.none("vectors where there is no frame", count, "T needs a velocity, N a curvature");
    Ok(findings)
}

fn point_velocity(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let point = Vec3::new(0.3, -0.4, 0.2);
    let mut world = subject.world("exact")?;
    world.set_gravity([0.0, 0.0, -9.81])?;
    let id = world.add(tumbling()?)?;
    world.step(0.7);
    let state = world.state().clone();
    let here = world.body(id);
    let at = here.point(point);
    let (v, a, w) = (here.velocity_at(at), here.acceleration_at(at), here.angular_velocity());
    let rates = here.axes().cols.map(|column| w.cross(column));
    let mut after = |h: f64| -> Result<(Vec3, Mat3), Error> {
        world.restore(&state)?;
        world.step(h);
        Ok((world.body(id).point(point), world.body(id).axes()))
    };
    let mut errors = |h: f64| -> Result<[f64; 3], Error> {
        let (ahead, behind) = (after(h)?, after(-h)?);
        let velocity = (ahead.0 - behind.0) / (2.0 * h);
        let acceleration = (ahead.0 - at * 2.0 + behind.0) / (h * h);
        let axes = (0..3).map(|i| ((ahead.1.cols[i] - behind.1.cols[i]) / (2.0 * h) - rates[i]).length());
        Ok([(velocity - v).length(), (acceleration - a).length(), axes.fold(0.0, f64::greatest)])
    };
    let h = 0.01;
    let (coarse, fine) = (errors(h)?, errors(0.5 * h)?);
    for (i, what) in ["velocity of a point", "acceleration of a point", "rates of the axes"].into_iter().enumerate() {
        let slope = slope::slope(coarse[i], fine[i]);
        let what = format!("{what} by differences: slope of the error {slope:.3} for 2 (h = {h} and {} s)", 0.5 * h);
        let because = "central differences err by h² times the third or fourth derivative; the next term is (h|ω|)² = 5e-4 of it, \
                       rounding over h² some 1e-3";
        findings.at_most(what, (slope - 2.0).abs(), 0.01, because);
    }
    // One Richardson step removes h²: what is left is h⁴ |ω|⁵ |r|, with |ω| = 2.4 and |r| = 0.54, over 30, and rounding/h.
    let h4 = libm::pow(h, 4.0) * libm::pow(2.4, 5.0) * 0.54;
    let velocity = ((fine[0] * 4.0 - coarse[0]) / 3.0).abs();
    let because = "extrapolated to h = 0: (h|ω|)⁴ |v| and a rounding over h";
    findings.at_most(
        "velocity of a point by differences, at h = 0 [m/s]",
        velocity,
        h4 + 8.0 * f64::EPSILON / h,
        because,
    );
    Ok(findings)
}

fn turning_frame(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let turning = Vec3::new(0.2, -0.1, 0.7);
    let (x, v) = (Vec3::new(1.0, 0.5, -0.3), Vec3::new(0.4, -0.6, 0.2));
    let error = |integrator: &str, h: f64| -> Result<f64, Error> {
        let mut world = subject.world(integrator)?;
        let id = world.add(ball(1.5)?.position(x).velocity(v - turning.cross(x)))?;
        world.add_field(Field::custom(move |body| {
            let a = body.v.cross(turning) * 2.0 - turning.cross(turning.cross(body.x));
            Wrench { force: a * body.mass, torque: Vec3::ZERO }
        }))?;
        let n = (4.0 / h).round() as usize;
        let mut worst: f64 = 0.0;
        for step in 1..=n {
            world.step(h);
            let t = h * step as f64;
            let seen = Quat::from_rotation_vector(turning * -t).rotate(x + v * t);
            worst = worst.greatest((world.body(id).center_of_mass() - seen).length());
        }
        Ok(worst)
    };
    for (integrator, order, h) in [("pdmv6", 2, 0.05), ("suzuki4:pdmv6", 4, 0.1), ("rk4", 4, 0.05)] {
        slope::expect(&mut findings, integrator, order, h, |h| error(integrator, h))?;
    }
    let (coarse, fine) = (error("rk4", 0.05)?, error("rk4", 0.005)?);
    let because = "twice the error of ten times the step over 10⁴, and four stages of 800 steps rounded";
    findings.at_most(
        "largest distance from the straight path as seen, rk4, h = 5 ms [m]",
        fine,
        2e-4 * coarse + 3200.0 * f64::EPSILON,
        because,
    );
    Ok(findings)
}

/// The torque of a force at an arm, or as slide 40 prints it.
fn torque_of(subject: Subject, arm: Vec3, force: Vec3) -> Vec3 {
    if subject.as_on_the_slides() { force.cross(arm) } else { arm.cross(force) }
}

fn torque(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let mut world = subject.world("pdmv6")?;
    let id = world.add(rigid(2.0, [0.3, 0.4, 0.6])?)?;
    world.body_mut(id).apply_force_at(Vec3::Y, Vec3::X)?;
    let found = world.body(id).wrench();
    let because = "unit vectors, whose products are exact";
    findings.at_most(
        "τ of F = ŷ at r = x̂, minus ẑ [N·m]",
        (found.torque - torque_of(subject, Vec3::X, Vec3::Y)).length(),
        0.0,
        because,
    );
    findings.at_most("its F, minus ŷ [N]", (found.force - Vec3::Y).length(), 0.0, because);
    let tilted = (torque_of(subject, Vec3::X, Vec3::Y) - Vec3::Z).length();
    findings.at_most("x̂ × ŷ − ẑ", tilted, 0.0, because);

    let mut world = subject.world("pdmv6")?;
    let x = Vec3::new(0.3, -0.5, 0.8);
    let id = world.add(rigid(2.0, [0.3, 0.4, 0.6])?.position(x))?;
    let mut random = crate::random::Random::new(31);
    let (mut force, mut moment, mut size) = (Vec3::ZERO, Vec3::ZERO, 0.0);
    let h = 0.01;
    for _ in 0..50 {
        let (f, r) = (random.vector(3.0), random.vector(2.0));
        world.body_mut(id).apply_force_at(f, r)?;
        force += f;
        moment += torque_of(subject, r - x, f);
        size += f.length() * (1.0 + (r - x).length());
    }
    world.step(h);
    let body = world.body(id);
    let rounding = 50.0 * f64::EPSILON * size * h;
    let because = "50 terms are summed in one order or the other, each rounded by half an ε a few times";
    findings.at_most(
        "p − h ΣF after a step with 50 forces [kg·m/s]",
        (body.momentum() - force * h).length(),
        rounding,
        because,
    );
    let error = (body.angular_momentum() - moment * h).length();
    findings.at_most("L − h Σ (r − x) × F after the same step [kg·m²/s]", error, rounding, because);
    Ok(findings)
}

fn gyroscope(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    // A symmetric top about its fixed point: i1 across, i3 along its axis; distance d, tilt θ, precession Ω. It is steady
    // if m g d = Ω (i3 ω3 − i1 Ω cos θ), with ω3 = spin + Ω cos θ the part of ω along the axis.
    let (m, d, g, i1, i3, tilt, precession): (f64, f64, f64, f64, f64, f64, f64) =
        (1.5, 0.2, 9.81, 0.08, 0.01, 0.9, 3.0);
    let cos = libm::cos(tilt);
    let along = (m * g * d / precession + i1 * precession * cos) / i3;
    let rot = Quat::from_axis_angle(Vec3::Y, tilt);
    let axis = rot.rotate(Vec3::Z);
    let w = Vec3::Z * precession + axis * (along - precession * cos);
    let error = |integrator: &str, n: f64| -> Result<f64, Error> {
        let mut world = subject.world(integrator)?;
        world.set_gravity([0.0, 0.0, -g])?;
        let across = i1 - m * d * d;
        let properties = MassProperties::new(m, [0.0, 0.0, d], Mat3::diagonal(Vec3::new(across, across, i3)))?;
        let body = Body::dynamic().mass_properties(properties).rotation(rot).angular_velocity(w);
        let id = world.add(body.velocity(w.cross(axis * d)))?;
        world.pin(id, Vec3::ZERO)?;
        let mut worst: f64 = 0.0;
        for step in 1..=n as usize {
            world.step(TAU / precession / n);
            let there = Quat::from_axis_angle(Vec3::Z, TAU * step as f64 / n).rotate(axis);
            worst = worst.greatest((world.body(id).axes().cols[2] - there).length());
        }
        Ok(worst)
    };
    for (integrator, order, n) in [("pdmv10", 2, 2000.0), ("suzuki4:pdmv10", 4, 1000.0), ("kahan-li6:exact", 6, 100.0)]
    {
        let h = TAU / precession / n;
        slope::expect(&mut findings, integrator, order, h, |h| error(integrator, (TAU / precession / h).round()))?;
    }
    let n: f64 = 4000.0;
    // The axis turns by 2π while the spin turns by this.
    let angle = w.length() * TAU / precession;
    let because = format!(
        "the sixth order errs below rounding: 9 stages in {n} steps as their root, four times, over {angle:.0} rad of spin"
    );
    let tolerance = 4.0 * libm::sqrt(9.0 * n) * f64::EPSILON * angle;
    findings.at_most(
        "largest distance of the axis from its cone, kahan-li6:pdmv10",
        error("kahan-li6:pdmv10", n)?,
        tolerance,
        because,
    );
    Ok(findings)
}

fn angular_momentum(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let particles: Vec<Particle> = grid(Vec3::new(0.4, 0.7, 1.0), 4)
        .iter()
        .enumerate()
        .map(|(i, p)| Particle { mass: p.mass * (1.0 + 0.01 * i as f64), ..*p })
        .collect();
    let mut world = subject.world("pdmv6")?;
    let body = Body::dynamic().mass_properties(MassProperties::from_particles(&particles)?);
    let id: BodyId =
        world.add(body.position([3.0, -1.0, 2.0]).velocity([0.3, 0.8, -0.4]).angular_velocity([2.0, -1.0, 3.0]))?;
    let mut worst: [Worst; 3] = Default::default();
    for _ in 0..20 {
        steps(&mut world, 10, 0.02);
        let body = world.body(id);
        let (x, w) = (body.center_of_mass(), body.angular_velocity());
        let because =
            "64 particles, up to 5 m from the origin at up to 5 m/s, each with some 30 roundings of half an ε";
        let rounding = 16.0 * f64::EPSILON * 64.0;
        for o in [Vec3::ZERO, Vec3::new(-4.0, 2.0, 7.0)] {
            let sum: Vec3 = particles
                .iter()
                .map(|p| body.point(p.position))
                .zip(&particles)
                .map(|(at, p)| (at - o).cross(body.velocity_at(at)) * p.mass)
                .sum();
            let split = (x - o).cross(body.momentum()) + body.angular_momentum();
            let size = 10.0 * body.momentum().length() + body.angular_momentum().length();
            worst[0].see(
                "Σ m (r − o) × v − (x − o) × M v − L [kg·m²/s]",
                (sum - split).length(),
                rounding * size,
                because,
            );
        }
        let momentum: Vec3 = particles.iter().map(|p| body.velocity_at(body.point(p.position)) * p.mass).sum();
        worst[1].see(
            "Σ m v − p [kg·m/s]",
            (momentum - body.momentum()).length(),
            rounding * momentum.length(),
            because,
        );
        // J summed anew over the turned particles, about the centre of mass.
        let summed = particles
            .iter()
            .fold(Mat3::ZERO, |sum, p| sum + Particle::new(body.point(p.position) - x, p.mass).inertia_about_origin());
        let l = body.angular_momentum();
        let apart = (summed * w - l).length() + (body.inertia() * w - l).length();
        worst[2].see(
            "J ω − L, with J summed anew, and with J = R J₀ Rᵀ [kg·m²/s]",
            apart,
            2.0 * rounding * l.length(),
            because,
        );
    }
    for worst in worst {
        findings.worst(worst);
    }
    Ok(findings)
}

fn puck(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let (m, radius) = (0.16, 0.038);
    let (kick, mut worst) = (Vec3::new(0.0, 0.5, 0.0), <[Worst; 2]>::default());
    for offset in [-1.0, -0.5, 0.0, 0.25, 0.9] {
        let mut world = subject.planar_world("pdmv6")?;
        let id = world.add(Body::dynamic().shape(Shape::disc(radius).mass(m)))?;
        let at = Vec3::new(offset * radius, 0.0, 0.0);
        if subject.as_on_the_slides() {
            // Slide 40: F (F · r) on the centre, and F × r for the torque.
            world.body_mut(id).apply_impulse(kick * kick.dot(at))?;
            world.body_mut(id).apply_angular_impulse(kick.cross(at))?;
        } else {
            world.body_mut(id).apply_impulse_at(kick, at)?;
        }
        let body = world.body(id);
        let because = "a division and a product or two, each of half an ε";
        let (v, w) = (kick / m, at.cross(kick) / (0.5 * m * radius * radius));
        let what = format!("v − J/m, hit at {offset} radii [m/s]");
        worst[0].see(what, (body.velocity() - v).length(), 4.0 * f64::EPSILON * v.length(), because);
        let what = format!("ω − r × J/I, hit at {offset} radii [rad/s]");
        worst[1].see(what, (body.angular_velocity() - w).length(), 8.0 * f64::EPSILON * w.length(), because);
    }
    for worst in worst {
        findings.worst(worst);
    }
    Ok(findings)
}
