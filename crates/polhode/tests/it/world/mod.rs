//! The laws that a world obeys.

mod bodies;
mod determinism;
mod free_flight;
mod forces;
mod pins;
mod planar;

use polhode::prelude::*;

/// A scene in which every law of force and every kind of body takes part.
pub(crate) fn busy_world(integrator: &str) -> World {
    let mut world = World::new();
    world.set_integrator(integrator.parse().unwrap()).unwrap();
    let mut ids = Vec::new();
    for i in 0..37 {
        let s = f64::from(i);
        let body = Body::dynamic()
            .shape(Shape::cuboid([0.3, 0.5 + 0.01 * s, 0.8]).density(700.0))
            .shape(Shape::sphere(0.2).at([0.1, 0.2, 0.3]))
            .position([1.5 * s, libm::sin(s), libm::cos(1.7 * s)])
            .rotation(Quat::from_rotation_vector(Vec3::new(0.1 * s, 0.3, -0.2 * s)))
            .velocity([libm::cos(s), 0.3, -0.1 * s])
            .angular_velocity([libm::sin(2.0 * s), 1.0 + 0.2 * s, -2.0]);
        ids.push(world.add(body).unwrap());
    }
    let carousel = world.add(Body::kinematic().angular_velocity([0.0, 0.0, 1.0]).velocity([0.1, 0.0, 0.0])).unwrap();
    world.add(Body::fixed().shape(Shape::half_space([0.0, 0.0, 1.0]))).unwrap();
    for pair in ids[..20].windows(2) {
        let spring =
            Field::spring(Anchor::on(pair[0], [0.1, 0.0, 0.2]), Anchor::on(pair[1], [-0.1, 0.1, 0.0]), 300.0, 1.0);
        world.add_field(spring.damping(4.0)).unwrap();
    }
    world
        .add_field(Field::spring(Anchor::on(carousel, [1.0, 0.0, 0.0]), Anchor::on(ids[0], [0.0; 3]), 50.0, 0.5))
        .unwrap();
    world.add_field(Field::torsion_spring(Some(ids[3]), ids[4], 20.0).damping(1.0)).unwrap();
    world.add_field(Field::central([0.0, 5.0, 0.0], 30.0)).unwrap();
    world.add_field(Field::linear_drag(0.5, 0.1).wind([1.0, 0.0, 0.0])).unwrap();
    world.add_field(Field::quadratic_drag(0.2, 0.01).only(ids[5..9].to_vec())).unwrap();
    world.add_field(Field::buoyancy(1000.0, -1.0)).unwrap();
    world.add_field(Field::mutual_gravity(1e-3, 0.1)).unwrap();
    let swirl =
        |b: &polhode::field::BodyView| Wrench { force: Vec3::Z.cross(b.v) * 2.0, torque: b.w.cross(b.x) * 0.01 };
    world.add_field(Field::custom(swirl)).unwrap();
    if world.integrator().closes_pins() {
        world.pin(ids[30], [0.0, 0.0, 0.5]).unwrap();
        world.pin(ids[31], [0.1, 0.0, 0.5]).unwrap();
        world.pin(ids[31], [0.1, 0.3, 0.2]).unwrap();
    }
    world.keep_forces(true);
    world.body_mut(ids[10]).apply_force_at([1.0, 2.0, 3.0], [15.0, 0.2, 0.1]).unwrap();
    world
}
