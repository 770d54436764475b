//! Laws of force, alone and together.

use polhode::prelude::*;

fn free_world() -> World {
    let mut world = World::new();
    world.set_gravity([0.0; 3]).unwrap();
    world
}

fn ball(mass: f64) -> Body {
    Body::dynamic().shape(Shape::sphere(0.1).mass(mass))
}

/// Velocity Verlet on a spring: the discrete motion is exactly harmonic with cos(Ω h) = 1 − (ω h)²/2, so after any number of
/// steps the error of the phase is known in closed form.
#[test]
fn a_spring_follows_the_discrete_closed_form() {
    let mut world = free_world();
    let id = world.add(ball(2.0).position([1.0, 0.0, 0.0])).unwrap();
    world.add_field(Field::spring(Anchor::world([0.0; 3]), Anchor::on(id, [0.0; 3]), 50.0, 0.0)).unwrap();
    let (h, w) = (0.02, 5.0);
    let phase = libm::acos(1.0 - 0.5 * w * w * h * h);
    for n in 1..=1000 {
        world.step(h);
        let exact = libm::cos(phase * f64::from(n));
        // The phase is rounded to 1e-16 a step, and so is the position.
        assert!((world.body(id).center_of_mass().x - exact).abs() < 1e-15 * f64::from(n) + 1e-15, "step {n}");
    }
}

/// Springs, torsion springs and gravitation between free bodies leave Σ p and Σ L as they were: every pair of forces is
/// equal and opposite to the bit, so what is left is the rounding of the sums.
#[test]
fn a_free_system_keeps_its_momenta() {
    let mut world = free_world();
    let mut ids = Vec::new();
    for i in 0..12 {
        let s = f64::from(i);
        let body = Body::dynamic()
            .shape(Shape::cuboid([0.2, 0.3, 0.5]))
            .position([libm::cos(s) * 2.0, libm::sin(s) * 2.0, 0.3 * s])
            .velocity([libm::sin(3.0 * s), 0.1 * s, -0.2])
            .angular_velocity([0.1, libm::cos(s), 0.5]);
        ids.push(world.add(body).unwrap());
    }
    for pair in ids.windows(2) {
        let (a, b) = (Anchor::on(pair[0], [0.1, 0.1, 0.0]), Anchor::on(pair[1], [0.0, -0.1, 0.2]));
        world.add_field(Field::spring(a, b, 4000.0, 0.5).damping(20.0)).unwrap();
    }
    world.add_field(Field::torsion_spring(Some(ids[0]), ids[5], 100.0).damping(3.0)).unwrap();
    world.add_field(Field::mutual_gravity(0.5, 0.0)).unwrap();
    let about = Vec3::new(3.0, -2.0, 1.0);
    let (p, l) = (world.momentum(), world.angular_momentum(about));
    let scale: f64 = world.bodies().map(|b| b.momentum().length()).sum();
    for _ in 0..2000 {
        world.step(0.005);
    }
    // 2000 steps × 12 bodies, each rounding a momentum of at most `scale` a few times; a random walk of that many.
    let bound = scale * f64::EPSILON * 4.0 * libm::sqrt(2000.0 * 12.0 * 4.0);
    assert!((world.momentum() - p).length() < bound, "{} {bound}", (world.momentum() - p).length());
    assert!((world.angular_momentum(about) - l).length() < 6.0 * bound, "arms of up to 6 m");
}

/// Two dumbbells on a circular orbit about each other, each turned by the tide of the other's two halves.
#[test]
fn dumbbells_orbit_each_other() {
    let mut world = free_world();
    let dumbbell = |x: f64, v: f64| {
        Body::dynamic()
            .shape(Shape::sphere(0.1).mass(1.0).at([0.075, 0.0, 0.0]))
            .shape(Shape::sphere(0.1).mass(1.0).at([-0.075, 0.0, 0.0]))
            .position([x, 0.0, 0.0])
            .rotation(Quat::from_axis_angle(Vec3::Z, 0.4))
            .velocity([0.0, v, 0.0])
    };
    // Two points of 2 kg, 4 m apart, circle with m v²/2 = G m²/4², so v = 1/2. The halves of the dumbbells add some
    // 6 (a/d)² = 0.2 % to the pull.
    let v = 0.5;
    let a = world.add(dumbbell(2.0, v)).unwrap();
    let b = world.add(dumbbell(-2.0, -v)).unwrap();
    world.add_field(Field::mutual_gravity(1.0, 0.0)).unwrap();
    let (energy, l) = (world.energy().total(), world.angular_momentum([0.0; 3]));
    let mut spun = 0.0f64;
    let (mut nearest, mut farthest) = (f64::INFINITY, 0.0f64);
    for _ in 0..20_000 {
        world.step(0.005);
        let d = (world.body(a).center_of_mass() - world.body(b).center_of_mass()).length();
        (nearest, farthest) = (nearest.min(d), farthest.max(d));
        spun = spun.max(world.body(a).angular_momentum().length());
    }
    assert!(nearest > 3.9 && farthest < 4.1, "a bound orbit: {nearest} … {farthest}");
    assert!(spun > 1e-5, "the tide turns them");
    // Verlet keeps the energy within (ω h)² = 2e-6 of the eccentric part, without drift.
    assert!((world.energy().total() - energy).abs() < 1e-7 * energy.abs());
    assert!((world.angular_momentum([0.0; 3]) - l).length() < 1e-12);
}

/// Falling with drag: v = v∞ (1 − e^{−t/T}) and v∞ tanh(t/T), at order 2.
#[test]
fn drag_follows_its_closed_forms_at_second_order() {
    let run = |field: fn() -> Field, h: f64| {
        let mut world = World::new();
        let id = world.add(ball(2.0)).unwrap();
        world.add_field(field()).unwrap();
        for _ in 0..(2.0 / h) as usize {
            world.step(h);
        }
        -world.body(id).velocity().z
    };
    let linear = 2.0 * 9.81 / 3.0 * (1.0 - libm::exp(-3.0 / 2.0 * 2.0));
    let terminal = libm::sqrt(2.0 * 9.81 / 0.7);
    let quadratic = terminal * libm::tanh(9.81 * 2.0 / terminal);
    for (field, exact) in
        [((|| Field::linear_drag(3.0, 0.0)) as fn() -> Field, linear), (|| Field::quadratic_drag(0.7, 0.0), quadratic)]
    {
        let (a, b) = ((run(field, 0.0125) - exact).abs(), (run(field, 0.00625) - exact).abs());
        let slope = libm::log2(a / b);
        assert!((slope - 2.0).abs() < 0.1, "slope {slope}: {a} {b}");
    }
}

/// A floating cuboid rests at its draught and a floating sphere at the root of its cubic; energy is conserved on the way.
#[test]
fn things_float_where_archimedes_says() {
    let mut world = World::new();
    let raft = world
        .add(Body::dynamic().shape(Shape::cuboid([2.0, 3.0, 1.0]).density(600.0)).position([0.0, 0.0, 0.3]))
        .unwrap();
    let ball = world.add(Body::dynamic().shape(Shape::sphere(0.5).density(500.0)).position([9.0, 0.0, 0.4])).unwrap();
    world.add_field(Field::buoyancy(1000.0, 0.0)).unwrap();
    let energy = world.energy().total();
    for _ in 0..2000 {
        world.step(0.002);
    }
    // The potential has kinks in its second derivative where a face leaves the water: Verlet keeps 1e-4 of m g · 0.3 m.
    assert!((world.energy().total() - energy).abs() < 1e-4 * 3600.0 * 9.81 * 0.3);
    world.add_field(Field::linear_drag(8000.0, 0.0)).unwrap();
    for _ in 0..10_000 {
        world.step(0.002);
    }
    assert!((world.body(raft).position().z + 0.1).abs() < 1e-9, "draught 0.6 m of 1 m");
    assert!(world.body(ball).position().z.abs() < 1e-9, "half under water");
    let cone = Body::dynamic().name("buoy").shape(Shape::cone(0.5, 1.0));
    assert!(world.add(cone).unwrap_err().to_string().contains("body buoy has another shape"));
}

#[test]
fn a_torsion_pendulum_swings_with_its_period() {
    let mut world = free_world();
    let id = world
        .add(Body::dynamic().shape(Shape::sphere(0.5).mass(4.0)).rotation(Quat::from_axis_angle(Vec3::Z, 0.5)))
        .unwrap();
    let (k, inertia) = (10.0, 0.4 * 4.0 * 0.25);
    world.add_field(Field::torsion_spring(None, id, k)).unwrap();
    let period = core::f64::consts::TAU * libm::sqrt(inertia / k);
    let n = 4000;
    for _ in 0..n {
        world.step(period / f64::from(n));
    }
    // Verlet's period is off by (ω h)²/24 = 1e-7; the swing returns to second order in that.
    let back = world.body(id).rotation().to_rotation_vector();
    assert!((back - Vec3::new(0.0, 0.0, 0.5)).length() < 1e-6);
}

/// A force that is no number stops neither the others nor, but for that force, its own body.
#[test]
fn a_force_that_is_no_number_is_dropped_and_reported() {
    let mut world = World::new();
    let (a, b) = (world.add(ball(1.0)).unwrap(), world.add(ball(1.0).position([1.0, 0.0, 0.0])).unwrap());
    world
        .add_field(Field::custom(move |body| {
            let force = if body.id == a { Vec3::splat(f64::NAN) } else { Vec3::X };
            Wrench { force, torque: Vec3::ZERO }
        }))
        .unwrap();
    let report = world.step(0.01);
    assert_eq!(report.quarantined, [a]);
    assert!(world.body(a).position().is_finite() && world.body(b).velocity().x > 0.0);
}

#[test]
fn fields_refuse_what_they_cannot_do() {
    let mut world = World::new();
    let id = world.add(ball(1.0)).unwrap();
    let gone = world.add(ball(1.0)).unwrap();
    world.remove(gone);
    let mut refused = |field: Field, text: &str| {
        let error = world.add_field(field).expect_err(text).to_string();
        assert!(error.starts_with(text), "got: {error}");
    };
    refused(Field::linear_drag(-1.0, 0.0), "linear: is -1 N·s/m; it must be finite and at least 0");
    refused(Field::central([f64::NAN, 0.0, 0.0], 1.0), "center: is [NaN, 0.0, 0.0]");
    refused(Field::mutual_gravity(1.0, -1.0), "softening");
    refused(Field::mutual_gravity(1.0, 0.0).only([id]), "only: mutual gravitation acts between all");
    refused(
        Field::spring(Anchor::world([0.0; 3]), Anchor::on(gone, [0.0; 3]), 1.0, 0.0),
        "b: names a body that is not",
    );
    refused(Field::spring(Anchor::world([0.0; 3]), Anchor::on(id, [0.0; 3]), 1.0, f64::NAN), "rest_length");
    let spring = Field::spring(Anchor::world([0.0; 3]), Anchor::on(id, [0.0; 3]), 1.0, 0.0);
    refused(spring.only([id]), "only: a spring names its two bodies itself");
    refused(Field::torsion_spring(None, id, 1.0).rest_rotation(Quat::new(2.0, 0.0, 0.0, 0.0)), "rest: is no rotation");
    refused(Field::linear_drag(1.0, 0.0).only([gone]), "only[0]: names a body that is not");
    refused(Field::buoyancy(f64::INFINITY, 0.0), "density");
}

/// However strong the damping, a step is stable and every body settles at its terminal velocity.
#[test]
fn stiff_damping_is_stable() {
    for c in [1.0, 100.0, 1e3, 1e5] {
        let mut world = World::new();
        let id = world.add(ball(4.0).velocity([5.0, 0.0, 3.0]).angular_velocity([1.0, 2.0, 3.0])).unwrap();
        world.add_field(Field::linear_drag(c, c)).unwrap();
        let (speed, spin) = (world.body(id).velocity().length(), world.body(id).angular_velocity().length());
        for _ in 0..20_000 {
            let report = world.step(1.0 / 60.0);
            assert_eq!(report.unconverged, 0, "c = {c}");
            let b = world.body(id);
            assert!(b.velocity().length() < 2.0 * speed + 40.0 && b.angular_velocity().length() <= spin * (1.0 + 1e-9));
        }
        if c <= 1e3 {
            // The trapezoidal rule damps by (z − 1)/(z + 1) a step, z = h c/(2m): within 20,000 steps to rounding.
            assert!((world.body(id).velocity() - Vec3::new(0.0, 0.0, -4.0 * 9.81 / c)).length() < 1e-9, "c = {c}");
        }
    }
    let mut world = World::new();
    let id = world.add(ball(4.0).velocity([1000.0, 0.0, 0.0])).unwrap();
    world.add_field(Field::quadratic_drag(1.0, 0.0)).unwrap();
    for _ in 0..3000 {
        assert_eq!(world.step(1.0 / 60.0).unconverged, 0);
        assert!(world.body(id).velocity().length() <= 1000.0);
    }
    assert!((world.body(id).velocity().z + libm::sqrt(4.0 * 9.81)).abs() < 1e-6);
}

/// A law that is no number for a body takes nothing else from it, and nothing from its partner.
#[test]
fn one_bad_law_leaves_the_others() {
    let mut world = World::new();
    let (a, b) = (world.add(ball(1.0)).unwrap(), world.add(ball(1.0).position([1.0, 0.0, 0.0])).unwrap());
    world.add_field(Field::spring(Anchor::on(a, [0.0; 3]), Anchor::on(b, [0.0; 3]), 10.0, 0.5)).unwrap();
    world.add_field(Field::custom(|_| Wrench { force: Vec3::splat(f64::NAN), torque: Vec3::ZERO }).only([a])).unwrap();
    for _ in 0..10 {
        assert_eq!(world.step(0.01).quarantined, [a]);
    }
    assert!((world.body(a).velocity().z + 0.981).abs() < 1e-12, "gravity still pulls");
    assert!(world.momentum().x.abs() < 1e-15, "and the spring pulls both alike");
}
