//! The plane: two coordinates, one angle, one inertia.

use polhode::prelude::*;

#[test]
fn a_planar_body_stays_in_the_plane_to_the_bit() {
    let mut world = World::planar();
    let outline = [[0.0, 0.0], [2.0, 0.0], [2.0, 0.5], [0.0, 1.5]];
    let a = world.add(Body::dynamic().shape(Shape::polygon(outline)).angular_velocity([0.0, 0.0, 3.0])).unwrap();
    let b =
        world.add(Body::dynamic().shape(Shape::disc(0.5)).position([3.0, 1.0, 0.0]).velocity([1.0, 2.0, 0.0])).unwrap();
    let spring = Field::spring(Anchor::on(a, [2.0, 0.0, 0.0]), Anchor::on(b, [0.0, 0.5, 0.0]), 2000.0, 0.5);
    world.add_field(spring.damping(10.0)).unwrap();
    world.add_field(Field::custom(|_| Wrench { force: Vec3::splat(7.0), torque: Vec3::splat(5.0) })).unwrap();
    world.pin(b, [0.1, 0.2, 0.0]).unwrap();
    for _ in 0..500 {
        world.step(0.01);
    }
    for id in [a, b] {
        let body = world.body(id);
        let (w, rot) = (body.angular_velocity(), body.rotation());
        assert_eq!((body.position().z, body.velocity().z, w.x, w.y, rot.x, rot.y), (0.0, 0.0, 0.0, 0.0, 0.0, 0.0));
        assert!(w.z != 0.0 && rot.z != 0.0);
    }
}

/// The one inertia is the moment about z: of a lamina, of a solid, and of particles on a line.
#[test]
fn one_number_is_the_inertia() {
    let mut world = World::planar();
    let disc =
        world.add(Body::dynamic().shape(Shape::disc(0.5).density(3.0)).angular_velocity([0.0, 0.0, 2.0])).unwrap();
    let m = 3.0 * core::f64::consts::PI * 0.25;
    assert!((world.body(disc).angular_momentum().z - 0.5 * m * 0.25 * 2.0).abs() < 1e-15);
    let brick = world
        .add(Body::dynamic().shape(Shape::cuboid([1.0, 2.0, 3.0]).mass(12.0)).angular_velocity([0.0, 0.0, 1.0]))
        .unwrap();
    assert!((world.body(brick).angular_momentum().z - 5.0).abs() < 1e-14);
}

#[test]
fn leaving_the_plane_is_an_error() {
    let mut world = World::planar();
    let disc = || Body::dynamic().shape(Shape::disc(1.0));
    for (body, name) in [
        (disc().position([0.0, 0.0, 1.0]), "position"),
        (disc().velocity([0.0, 0.0, 1.0]), "velocity"),
        (disc().angular_velocity([1.0, 0.0, 0.0]), "angular_velocity"),
        (disc().angular_momentum([0.0, 1.0, 0.0]), "angular_momentum"),
        (disc().rotation([1.0, 1.0, 0.0, 0.0]), "rotation"),
    ] {
        let text = world.add(body).unwrap_err().to_string();
        assert!(text.starts_with(&format!("{name}: leaves the plane")), "{text}");
    }
    let id = world.add(disc()).unwrap();
    assert!(world.body_mut(id).set_velocity([0.0, 0.0, 1.0]).is_err());
    assert!(world.set_gravity([0.0, 0.0, -9.81]).is_err());
    assert!(world.pin(id, [0.0, 0.0, 0.1]).is_err());
}
