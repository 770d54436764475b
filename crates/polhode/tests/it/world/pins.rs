//! Pinned points: the free top about a point, and RATTLE where several pins hold.

use polhode::prelude::*;

/// The heavy top of Brüls and others: 15 kg, its centre 1 m from the tip, spinning at 150 rad/s.
fn heavy_top(scheme: &str, times: usize) -> (World, BodyId) {
    let mut world = World::new();
    world.set_integrator(scheme.parse().unwrap()).unwrap();
    let j = [[0.234375, 0.0, 0.0], [0.0, 0.46875, 0.0], [0.0, 0.0, 0.234375]];
    let w = Vec3::new(0.0, 150.0, -4.61538);
    let body = Body::dynamic()
        .mass_properties(MassProperties::new(15.0, [0.0, 1.0, 0.0], j).unwrap())
        .velocity(w.cross(Vec3::Y))
        .angular_velocity(w);
    let id = world.add(body).unwrap();
    for _ in 0..times {
        world.pin(id, [0.0; 3]).unwrap();
    }
    (world, id)
}

/// From the 22-digit trajectory: the centre of mass at t = 2 s.
const AT_2_S: Vec3 = Vec3::new(-0.15041682274564175, -0.7241655916368956, -0.6730222695604441);

fn error_at_2_s(scheme: &str, times: usize, h: f64) -> f64 {
    let (mut world, id) = heavy_top(scheme, times);
    for _ in 0..libm::round(2.0 / h) as usize {
        world.step(h);
    }
    (world.body(id).center_of_mass() - AT_2_S).length()
}

#[test]
fn a_pinned_top_is_a_free_top_about_its_pin() {
    assert!(error_at_2_s("pdmv10", 1, 1e-3) < 1e-5);
    assert!(error_at_2_s("suzuki4:pdmv10", 1, 1e-3) < 1e-10);
    let slope = libm::log2(error_at_2_s("pdmv10", 1, 2e-3) / error_at_2_s("pdmv10", 1, 1e-3));
    assert!((slope - 2.0).abs() < 0.05, "slope {slope}");
}

/// The same point pinned twice: six rows of rank three, by RATTLE. It converges to the same motion at the same order, and
/// every composition lifts it.
#[test]
fn rattle_with_redundant_rows_converges_to_the_same_motion() {
    for (scheme, h, order) in [("pdmv6", 5e-4, 2.0), ("suzuki4:pdmv6", 1e-3, 4.0)] {
        let (coarse, fine) = (error_at_2_s(scheme, 2, h), error_at_2_s(scheme, 2, 0.5 * h));
        let slope = libm::log2(coarse / fine);
        assert!((slope - order).abs() < 0.15, "{scheme}: slope {slope}, errors {coarse} {fine}");
    }
    // Divided into two parts a stage, alike in all its stages, a composition is as good as at half the step.
    let (divided, half) = (error_at_2_s("kahan-li6:pdmv10", 2, 2.5e-3), error_at_2_s("kahan-li6:pdmv10", 2, 1.25e-3));
    assert!(divided < 1.1 * half, "{divided} {half}");
}

#[test]
fn pins_stay_closed_and_the_energy_stays() {
    for times in [1, 2] {
        let (mut world, id) = heavy_top("pdmv6", times);
        let pins: Vec<_> = world.model().pin_ids.clone();
        let energy = world.energy().total();
        let mut worst = 0.0f64;
        for _ in 0..4000 {
            let report = world.step(5e-4);
            assert!(report.pins.gap < 1e-14, "{}", report.pins.gap);
            worst = worst.max((world.energy().total() - energy).abs());
        }
        for pin in pins {
            assert!(world.pin_gap(pin).unwrap() < 1e-14);
        }
        assert!(world.body(id).velocity_at([0.0; 3]).length() < 1e-12);
        // Second order in h|ω| = 0.075: some 1e-4 m g l for RATTLE, far less about the pin.
        assert!(worst < 1e-3 * 15.0 * 9.81, "{worst}");
    }
}

/// Two pins are a hinge: a physical pendulum, whose period is known.
#[test]
fn two_pins_make_a_hinge() {
    let mut world = World::new();
    let rod = Body::dynamic().shape(Shape::cuboid([1.0, 0.1, 0.1]).mass(2.0)).position([0.5, 0.0, 0.0]);
    let id = world.add(rod).unwrap();
    for y in [-0.05, 0.05] {
        world.pin(id, [-0.5, y, 0.0]).unwrap();
    }
    // From the horizontal: T/T0 = 1.180340599016096, with T0 = 2π √(I/(m g d)).
    let inertia = 2.0 * (1.0 + 0.01) / 12.0 + 2.0 * 0.25;
    let period = 1.180_340_599_016_096 * core::f64::consts::TAU * libm::sqrt(inertia / (2.0 * 9.81 * 0.5));
    let steps = 4000;
    for _ in 0..steps {
        world.step(period / f64::from(steps));
    }
    // It has swung there and back: at rest again, to second order in the step; (ω h)² is 6e-6.
    let b = world.body(id);
    assert!((b.position() - Vec3::new(0.5, 0.0, 0.0)).length() < 2e-5, "{:?}", b.position());
    assert!(b.rotation().vector().x.abs() < 1e-12 && b.rotation().vector().z.abs() < 1e-12, "it turned about y only");
}

/// At rest the pin carries the weight; swinging through the lowest point it carries m g + m v²/l besides.
#[test]
fn reactions_are_statics_and_dynamics() {
    let mut world = World::new();
    let bob = Body::dynamic().shape(Shape::sphere(0.05).mass(3.0)).position([0.0, 0.0, -2.0]);
    let id = world.add(bob).unwrap();
    let pin = world.pin(id, [0.0, 0.0, 2.0]).unwrap();
    world.step(1e-3);
    assert!((world.pin_reaction(pin).unwrap() - Vec3::new(0.0, 0.0, 3.0 * 9.81)).length() < 1e-9);
    assert!(world.body(id).acceleration_at([0.0; 3]).length() < 1e-12, "the pinned point does not accelerate");
    world.body_mut(id).set_velocity([1.0, 0.0, 0.0]).unwrap();
    // The bearing takes what a translation alone would do to the pinned point: the ball swings about it.
    let w = world.body(id).angular_velocity().length();
    let (m, l, i) = (3.0, 2.0, 0.4 * 3.0 * 0.0025);
    assert!((w - m * l * 1.0 / (i + m * l * l)).abs() < 1e-12);
    let before = world.body(id).velocity().length();
    world.step(1e-5);
    let reaction = world.pin_reaction(pin).unwrap();
    // Over 1e-5 s the pendulum moves by 1e-5 rad: the mean reaction differs by second order.
    assert!((reaction.z - (m * 9.81 + m * before * before / l)).abs() < 1e-6, "{reaction:?}");
}

#[test]
fn pins_refuse_what_would_tear_them() {
    let (mut world, id) = heavy_top("pdmv6", 1);
    let error = world.body_mut(id).set_pose([1.0, 0.0, 0.0], Quat::IDENTITY).unwrap_err();
    assert!(error.to_string().contains("a pin holds the body"), "{error}");
    world.body_mut(id).set_pose([0.0; 3], Quat::from_axis_angle(Vec3::X, 0.3)).unwrap();
    assert!(world.set_integrator("rk4".parse().unwrap()).is_err());
    let pin = world.model().pin_ids[0];
    assert!(world.unpin(pin) && !world.unpin(pin));
    world.set_integrator("rk4".parse().unwrap()).unwrap();
    let ground = world.add(Body::fixed()).unwrap();
    world.set_integrator(Integrator::default()).unwrap();
    assert!(world.pin(ground, [0.0; 3]).unwrap_err().to_string().contains("is not dynamic"));
    assert!(world.pin(id, [f64::NAN, 0.0, 0.0]).is_err());
}

/// A hinge at any speed, at the end of a bar and through its centre: the drift is divided where RATTLE would let it open.
#[test]
fn hinges_hold_at_any_speed() {
    for end in [0.5, 0.0] {
        for w in [1.0, 10.0, 18.0, 21.0, 26.0, 36.0, 60.0, 150.0, 1000.0] {
            for gravity in [0.0, -9.81] {
                let mut world = World::new();
                world.set_gravity([0.0, 0.0, gravity]).unwrap();
                let bar = Body::dynamic()
                    .shape(Shape::cuboid([1.0, 0.2, 0.1]))
                    .velocity([0.0, 0.0, -end * w])
                    .angular_velocity([0.0, w, 0.0]);
                let id = world.add(bar).unwrap();
                for y in [-0.05, 0.05] {
                    world.pin(id, [-end, y, 0.0]).unwrap();
                }
                let energy = world.energy().kinetic();
                for _ in 0..2000 {
                    let report = world.step(1.0 / 60.0);
                    assert!(report.pins.gap < 1e-13, "{end} m, {w} rad/s: gap {}", report.pins.gap);
                }
                // Without a moment of weight the speed stays, but for a rounding in each of at most 2000 · 67 parts; the
                // weight at the end moves the energy by at most m g times 1 m.
                let weight = if end == 0.0 { 0.0 } else { 20.0 * gravity.abs() };
                let allowed = 2000.0 * 67.0 * f64::EPSILON * energy + weight;
                let change = (world.energy().kinetic() - energy).abs();
                assert!(change < allowed, "{end} m, {w} rad/s, gravity {gravity}: {change} of {energy}");
            }
        }
    }
}

/// The reaction is the mean over the step, in every composition: it is what the momentum lacks.
#[test]
fn reactions_are_what_the_momentum_lacks() {
    for scheme in ["pdmv6", "yoshida4:pdmv6", "kahan-li8:pdmv6"] {
        for times in [1, 2] {
            let (mut world, id) = heavy_top(scheme, times);
            let dt = 1e-3;
            for _ in 0..10 {
                let before = world.body(id).momentum();
                world.step(dt);
                let pins = world.model().pin_ids.clone();
                let reaction: Vec3 = pins.iter().map(|&pin| world.pin_reaction(pin).unwrap()).sum();
                let lacking = (world.body(id).momentum() - before) / dt - world.gravity() * 15.0;
                // Momenta of 70 kg·m/s, rounded some hundred times, over a millisecond.
                assert!((reaction - lacking).length() < 1e-9, "{scheme}: {:?}", reaction - lacking);
            }
        }
    }
}
