//! Motion under each law of force, against its closed form.

use super::scene::{Greatest, ball, rigid, steps};
use super::slope;
use super::suite::{Check, Findings, Group, Subject};
use polhode::field::{Anchor, Field, Wrench};
use polhode::math::{Quat, Vec3};
use polhode::model::Body;
use polhode::shape::Shape;
use polhode::store::BodyId;
use polhode::{Error, World};

pub(super) const CHECKS: &[Check] = &[
    Check {
        group: Group::Forces,
        name: "drag-linear",
        law: "Under F = −c v a falling body approaches m g/c: v = (m g/c)(1 − exp(−c t/m)).",
        measure: linear_drag,
    },
    Check {
        group: Group::Forces,
        name: "drag-quadratic",
        law: "Under F = −k |v| v a falling body approaches √(m g/k): v = √(m g/k) tanh(g t/√(m g/k)).",
        measure: quadratic_drag,
    },
    Check {
        group: Group::Forces,
        name: "oscillator-damped",
        law: "A mass on a damped spring swings as A exp(−δ t) cos(ω t − φ), with δ = c/2m and ω² = k/m − δ².",
        measure: damped_oscillator,
    },
    Check {
        group: Group::Forces,
        name: "spring-pair",
        law: "Two bodies on a spring swing at ω² = k (1/m₁ + 1/m₂) while their common centre goes straight on.",
        measure: spring_pair,
    },
    Check {
        group: Group::Forces,
        name: "torsion-pendulum",
        law: "A body on a torsion spring swings as θ₀ cos(√(k/I) t), with any amplitude.",
        measure: torsion_pendulum,
    },
    Check {
        group: Group::Forces,
        name: "buoyancy",
        law: "A floating box heaves at ω² = ρ g A/m about the draught m/(ρ A); a ball of half the density floats half out.",
        measure: buoyancy,
    },
    Check {
        group: Group::Forces,
        name: "work",
        law: "A constant force at a point of a body does the work F · Δr of that point, and the kinetic energy has it.",
        measure: work,
    },
    Check {
        group: Group::Forces,
        name: "impulse",
        law: "An impulse J at r changes v by J/m and ω by I⁻¹ (r × J), and so does a force in one step.",
        measure: impulse,
    },
];

const G: f64 = 9.81;

/// Under strong drag the sixth order shows less than the seventh: what the iteration for v leaves over.
const DISSIPATIVE: u32 = 4;

/// Builds a world with an integrator, and names the body that is looked at.
type Scene<'a> = dyn Fn(&str) -> Result<(World, BodyId), Error> + 'a;

/// What a body does, in a number, and when it is asked.
struct Motion<'a> {
    /// What the number is, with its unit.
    what: &'a str,
    end: f64,
    /// Builds the world.
    scene: &'a Scene<'a>,
    /// The distance of what is from what must be at a time.
    error: &'a dyn Fn(&World, BodyId, f64) -> f64,
}

impl Motion<'_> {
    /// The largest error in steps of `h`.
    fn error(&self, integrator: &str, h: f64) -> Result<f64, Error> {
        let (mut world, id) = (self.scene)(integrator)?;
        let n = (self.end / h).round() as usize;
        let mut worst: f64 = 0.0;
        for step in 1..=n {
            world.step(h);
            worst = worst.greatest((self.error)(&world, id, h * step as f64));
        }
        Ok(worst)
    }
    /// That the default is of order 2 and its compositions of theirs, up to `highest`, and that the sixth is as near as its
    /// order says.
    fn orders(&self, findings: &mut Findings, h: f64, highest: u32) -> Result<(), Error> {
        let orders = [("pdmv6", 2), ("suzuki4:pdmv10", 4), ("kahan-li6:pdmv10", 6)];
        for (integrator, order) in orders.into_iter().filter(|&(_, order)| order <= highest) {
            let name = format!("{integrator}, {}", self.what);
            slope::expect(findings, &name, order, h, |h| self.error(integrator, h))?;
        }
        let coarse = self.error("kahan-li6:pdmv10", h)?;
        let fine = self.error("kahan-li6:pdmv10", h / 8.0)?;
        let steps = 8.0 * self.end / h;
        findings.at_most(
            format!("{}, kahan-li6:pdmv10, h = {} s", self.what, h / 8.0),
            fine,
            2.0 * coarse / libm::pow(8.0, 6.0) + 9.0 * 4.0 * steps * f64::EPSILON,
            format!(
                "twice the {coarse:.1e} of h = {h} s over 8⁶, and four roundings in each of 9 stages of {steps} steps"
            ),
        );
        Ok(())
    }
}

fn linear_drag(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let (m, c, wind) = (2.0, 1.5, Vec3::new(0.7, 0.0, 0.0));
    let scene = |integrator: &str| {
        let mut world = subject.world(integrator)?;
        world.set_gravity([0.0, 0.0, -G])?;
        let id = world.add(rigid(m, [0.5; 3])?.velocity([4.0, 0.0, 3.0]).angular_velocity([0.0, 2.0, 0.0]))?;
        world.add_field(Field::linear_drag(c, 0.3).wind(wind))?;
        Ok((world, id))
    };
    let terminal = wind + Vec3::new(0.0, 0.0, -m * G / c);
    let error = |world: &World, id, t: f64| {
        let decay = libm::exp(-c * t / m);
        let v = terminal + (Vec3::new(4.0, 0.0, 3.0) - terminal) * decay;
        let w = Vec3::new(0.0, 2.0, 0.0) * libm::exp(-0.3 * t / 0.5);
        let body = world.body(id);
        (body.velocity() - v).length().greatest((body.angular_velocity() - w).length())
    };
    let motion = Motion { what: "v and ω", end: 2.0, scene: &scene, error: &error };
    motion.orders(&mut findings, 0.1, DISSIPATIVE)?;
    terminal_velocity(&mut findings, &scene, terminal, c / m)?;
    Ok(findings)
}

/// At rest in the flow the forces cancel; `rate` is that of the approach \[1/s\].
fn terminal_velocity(findings: &mut Findings, scene: &Scene<'_>, terminal: Vec3, rate: f64) -> Result<(), Error> {
    let (mut world, id) = scene("pdmv6")?;
    let h = 1.0 / 60.0;
    steps(&mut world, 6000, h);
    let error = (world.body(id).velocity() - terminal).length() / terminal.length();
    findings.at_most(
        "velocity after 100 s over the terminal one, minus 1",
        error,
        (1.0 / (rate * h) + 8.0) * f64::EPSILON,
        "the approach ends where a kick of h F/2 is less than half a rounding of p; some roundings of the forces besides",
    );
    Ok(())
}

fn quadratic_drag(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let (m, k) = (2.0, 0.8);
    let scene = |integrator: &str| {
        let mut world = subject.world(integrator)?;
        world.set_gravity([0.0, 0.0, -G])?;
        let id = world.add(ball(m)?)?;
        world.add_field(Field::quadratic_drag(k, 0.0))?;
        Ok((world, id))
    };
    let terminal = libm::sqrt(m * G / k);
    let error = |world: &World, id, t: f64| {
        let body = world.body(id);
        let z = -terminal * terminal / G * libm::log(libm::cosh(G * t / terminal));
        let v = -terminal * libm::tanh(G * t / terminal);
        (body.velocity().z - v).abs().greatest((body.center_of_mass().z - z).abs())
    };
    let motion = Motion { what: "v and z", end: 1.0, scene: &scene, error: &error };
    motion.orders(&mut findings, 0.05, DISSIPATIVE)?;
    terminal_velocity(&mut findings, &scene, Vec3::new(0.0, 0.0, -terminal), 2.0 * k * terminal / m)?;
    Ok(findings)
}

fn damped_oscillator(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let (m, k, c, rest) = (2.0, 18.0, 1.2, 0.5);
    let scene = |integrator: &str| {
        let mut world = subject.world(integrator)?;
        let id = world.add(ball(m)?.position([rest + 0.2, 0.0, 0.0]))?;
        let (fixed, end) = (Anchor::world([0.0; 3]), Anchor::on(id, [0.0; 3]));
        world.add_field(Field::spring(fixed, end, k, rest).damping(c))?;
        Ok((world, id))
    };
    let delta = c / (2.0 * m);
    let w = libm::sqrt(k / m - delta * delta);
    let error = |world: &World, id, t: f64| {
        let x = 0.2 * libm::exp(-delta * t) * (libm::cos(w * t) + delta / w * libm::sin(w * t));
        (world.body(id).center_of_mass().x - rest - x).abs()
    };
    Motion { what: "x [m]", end: 4.0, scene: &scene, error: &error }.orders(&mut findings, 0.1, 6)?;
    Ok(findings)
}

fn spring_pair(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let (m1, m2, k, rest) = (1.0, 3.0, 12.0, 1.0);
    let (drift, stretch) = (Vec3::new(0.3, 0.1, 0.0), 0.1);
    let scene = |integrator: &str| {
        let mut world = subject.world(integrator)?;
        let a = world.add(ball(m1)?.velocity(drift))?;
        let b = world.add(ball(m2)?.position([rest + stretch, 0.0, 0.0]).velocity(drift))?;
        world.add_field(Field::spring(Anchor::on(a, [0.0; 3]), Anchor::on(b, [0.0; 3]), k, rest))?;
        Ok((world, b))
    };
    let w = libm::sqrt(k * (1.0 / m1 + 1.0 / m2));
    let error = |world: &World, b, t: f64| {
        // The common centre starts at x = (rest + stretch) m₂/M, and b is m₁/M of the distance beyond it.
        let distance = rest + stretch * libm::cos(w * t);
        let x = Vec3::X * ((rest + stretch) * m2 / (m1 + m2) + distance * m1 / (m1 + m2)) + drift * t;
        (world.body(b).center_of_mass() - x).length()
    };
    Motion { what: "x [m]", end: 4.0, scene: &scene, error: &error }.orders(&mut findings, 0.05, 6)?;
    Ok(findings)
}

fn torsion_pendulum(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let (inertia, k, amplitude) = (Vec3::new(0.5, 0.8, 0.6), 2.4, 2.5);
    let scene = |integrator: &str| {
        let mut world = subject.world(integrator)?;
        let id = world.add(rigid(1.0, inertia)?.rotation(Quat::from_axis_angle(Vec3::Z, amplitude)))?;
        world.add_field(Field::torsion_spring(None, id, k))?;
        Ok((world, id))
    };
    let w = libm::sqrt(k / inertia.z);
    let error = |world: &World, id, t: f64| {
        let expected = Quat::from_axis_angle(Vec3::Z, amplitude * libm::cos(w * t));
        world.body(id).rotation().angle_to(expected)
    };
    Motion { what: "attitude [rad]", end: 4.0, scene: &scene, error: &error }.orders(&mut findings, 0.05, 6)?;
    Ok(findings)
}

fn buoyancy(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let (size, density, water) = (Vec3::new(1.0, 2.0, 0.4), 600.0, 1000.0);
    let draught = size.z * density / water;
    let scene = |integrator: &str| {
        let mut world = subject.world(integrator)?;
        world.set_gravity([0.0, 0.0, -G])?;
        let height = 0.5 * size.z - draught + 0.05;
        let id = world.add(Body::dynamic().shape(Shape::cuboid(size).density(density)).position([0.0, 0.0, height]))?;
        world.add_field(Field::buoyancy(water, 0.0))?;
        Ok((world, id))
    };
    let w = libm::sqrt(G / draught);
    let error = |world: &World, id, t: f64| {
        let z = 0.5 * size.z - draught + 0.05 * libm::cos(w * t);
        (world.body(id).center_of_mass().z - z).abs()
    };
    Motion { what: "z [m]", end: 2.0, scene: &scene, error: &error }.orders(&mut findings, 0.05, 6)?;

    let mut world = subject.world("pdmv6")?;
    world.set_gravity([0.0, 0.0, -G])?;
    let ball = world.add(Body::dynamic().shape(Shape::sphere(0.3).density(0.5 * water)))?;
    world.add_field(Field::buoyancy(water, 0.0))?;
    let weight = world.body(ball).mass() * G;
    let because = "lift and weight are the same number by two ways, each of some four roundings";
    let error = world.body(ball).wrench().force.length() / weight;
    findings.at_most("force on the ball that floats half out, over its weight", error, 8.0 * f64::EPSILON, because);
    steps(&mut world, 600, 1.0 / 60.0);
    let fallen = world.body(ball).center_of_mass().length();
    let because = "what is left of the force, 8 ε g, moves it no farther in 10 s than a free body";
    findings.at_most("its way in 10 s [m]", fallen, 8.0 * f64::EPSILON * G * 50.0, because);
    Ok(findings)
}

fn work(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let (force, point) = (Vec3::new(1.0, -2.0, 0.5), Vec3::new(0.3, 0.1, -0.2));
    let scene = |integrator: &str| {
        let mut world = subject.world(integrator)?;
        let id =
            world.add(rigid(1.5, [0.3, 0.4, 0.5])?.velocity([0.1, 0.2, 0.3]).angular_velocity([1.0, -0.5, 2.0]))?;
        world.add_field(Field::conservative(
            move |body| Wrench::at(force, body.rot.rotate(point)),
            move |body| -force.dot(body.x + body.rot.rotate(point)),
        ))?;
        Ok((world, id))
    };
    let (start, id) = scene("pdmv6")?;
    let kinetic = |world: &World, id| {
        let (translation, rotation) = world.body(id).kinetic_energy();
        translation + rotation
    };
    let (energy, place) = (kinetic(&start, id), start.body(id).point(point));
    let error =
        |world: &World, id, _| (kinetic(world, id) - energy - force.dot(world.body(id).point(point) - place)).abs();
    Motion { what: "energy minus work [J]", end: 2.0, scene: &scene, error: &error }.orders(&mut findings, 0.05, 6)?;
    Ok(findings)
}

fn impulse(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let (m, inertia) = (2.0, Vec3::new(0.3, 0.4, 0.6));
    let turned = Quat::from_rotation_vector(Vec3::new(0.4, -0.3, 1.1));
    let (at, j) = (Vec3::new(0.5, -0.2, 0.3), Vec3::new(1.0, 2.0, -0.7));
    let expected = turned.rotate(turned.inverse_rotate(at.cross(j)).scale(Vec3::new(
        1.0 / inertia.x,
        1.0 / inertia.y,
        1.0 / inertia.z,
    )));
    let mut world = subject.world("pdmv6")?;
    let id = world.add(rigid(m, inertia)?.rotation(turned))?;
    world.body_mut(id).apply_impulse_at(j, at)?;
    let body = world.body(id);
    let because = "a product, a sum and four rotations of a vector, some 16 roundings";
    let rounding = 16.0 * f64::EPSILON;
    findings.at_most(
        "v − J/m after an impulse [m/s]",
        (body.velocity() - j / m).length(),
        rounding * j.length() / m,
        because,
    );
    let error = (body.angular_velocity() - expected).length();
    findings.at_most("ω − I⁻¹ (r × J) after an impulse [rad/s]", error, rounding * expected.length(), because);

    let h = 0.01;
    let mut world = subject.world("pdmv6")?;
    let id = world.add(rigid(m, inertia)?.rotation(turned))?;
    world.body_mut(id).apply_force_at(j / h, at)?;
    world.step(h);
    let body = world.body(id);
    findings.at_most("p − F h after a step [kg·m/s]", (body.momentum() - j).length(), rounding * j.length(), because);
    let error = (body.angular_momentum() - at.cross(j)).length();
    findings.at_most("L − (r × F) h after a step [kg·m²/s]", error, rounding * at.length() * j.length(), because);
    Ok(findings)
}
