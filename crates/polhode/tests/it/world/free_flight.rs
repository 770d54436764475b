//! Free flight: what is conserved to the bit, and what to rounding.

use polhode::integrate::pdmv::Order;
use polhode::integrate::{Drift, Integrator};
use polhode::prelude::*;

fn tumbling(integrator: Integrator) -> (World, BodyId) {
    let mut world = World::new();
    world.set_integrator(integrator).unwrap();
    let body = Body::dynamic()
        .shape(Shape::cuboid([0.1, 0.4, 0.9]))
        .velocity([-2.0, 2.0, 8.0])
        .angular_velocity([0.1, 5.0, 0.1]);
    let id = world.add(body).unwrap();
    (world, id)
}

/// |L| and its direction are the same bits after a million steps in every order; the energy of rotation is within rounding.
#[test]
fn angular_momentum_is_constant_to_the_bit() {
    for order in [Order::Two, Order::Four, Order::Six, Order::Eight, Order::Ten] {
        let (mut world, id) = tumbling(Integrator::verlet(Drift::Pdmv(order)));
        let l = world.body(id).angular_momentum();
        let energy = world.energy().rotation;
        let mut worst = 0.0f64;
        for _ in 0..1000 {
            for _ in 0..1000 {
                world.step(0.01);
            }
            worst = worst.max((world.energy().rotation / energy - 1.0).abs());
        }
        assert_eq!(world.body(id).angular_momentum(), l, "{order:?}");
        // The bar of the energy: a random walk of 1e6 roundings of 1e-16 is 1e-13.
        assert!(worst < 1e-12, "{order:?}: energy off by {worst}");
    }
}

/// The default scheme follows a parabola exactly, whatever the step: what is left is the rounding of each step's sums.
#[test]
fn parabolas_are_exact_at_any_step() {
    for dt in [1e-3, 0.01, 1.0 / 60.0, 0.37, 5.0] {
        let (mut world, id) = tumbling(Integrator::default());
        let (x0, v0, g) = (Vec3::ZERO, Vec3::new(-2.0, 2.0, 8.0), world.gravity());
        for n in 1..=1000 {
            world.step(dt);
            let t = f64::from(n) * dt;
            let exact = x0 + v0 * t + g * (0.5 * t * t);
            let size = x0.length() + v0.length() * t + g.length() * t * t;
            let error = (world.body(id).center_of_mass() - exact).length();
            // Each of n steps rounds sums of at most `size` twice.
            assert!(error <= f64::EPSILON * size * f64::from(n), "dt {dt}, step {n}: {error}");
        }
    }
}

/// A body that spins too fast for the map is still turned right: by the exact solution.
#[test]
fn no_spin_is_too_fast() {
    let spin = |w: f64, dt: f64, integrator: &str| {
        let mut world = World::new();
        world.set_integrator(integrator.parse().unwrap()).unwrap();
        let id = world
            .add(Body::dynamic().shape(Shape::cuboid([0.1, 0.4, 0.9])).angular_velocity([0.3 * w, w, 0.1 * w]))
            .unwrap();
        world.step(dt);
        world.body(id).rotation()
    };
    for w in [10.0, 1e3, 1e5] {
        let (a, b) = (spin(w, 1.0 / 60.0, "pdmv10"), spin(w, 1.0 / 60.0, "exact"));
        // 64 sub-rotations of at most 0.25 rad are right to 4e-12 each; beyond them both are the exact solution.
        assert!(a.angle_to(b) < 3e-10, "{w} rad/s: {}", a.angle_to(b));
    }
}

/// A time step that is no number, or zero, moves nothing.
#[test]
fn steps_of_no_time() {
    let (mut world, id) = tumbling(Integrator::default());
    let start = world.body(id).pose();
    for dt in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0] {
        world.step(dt);
        assert!(
            (world.body(id).pose().x - start.x).length() == 0.0
                && world.body(id).rotation().angle_to(start.rot) < 1e-15
        );
    }
}
