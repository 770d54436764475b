//! Adding, removing, reading and moving bodies.

use polhode::prelude::*;
use polhode::store::Group;

fn brick() -> Body {
    Body::dynamic().shape(Shape::cuboid([1.0, 2.0, 3.0]).density(2.0))
}

#[test]
fn what_is_given_is_read_back() {
    let mut world = World::new();
    let rot = Quat::from_rotation_vector(Vec3::new(0.3, -0.4, 1.0));
    let offset = Shape::cuboid([1.0, 2.0, 3.0])
        .at([0.5, -0.2, 0.1])
        .rotated(Quat::from_rotation_vector(Vec3::new(1.0, 0.2, 0.4)));
    let body = Body::dynamic()
        .name("brick")
        .shape(offset)
        .position([1.0, 2.0, 3.0])
        .rotation(rot)
        .velocity([4.0, 5.0, 6.0])
        .angular_velocity([0.7, 0.8, 0.9]);
    let id = world.add(body).unwrap();
    let b = world.body(id);
    assert_eq!((b.id(), b.name(), b.group()), (id, Some("brick"), Group::Dynamic));
    // The body is stored about its centre of mass and principal axes: two rotations of numbers below 4.
    assert!((b.position() - Vec3::new(1.0, 2.0, 3.0)).length() < 4e-15);
    assert!(b.rotation().angle_to(rot) < 2e-15);
    assert!((b.velocity() - Vec3::new(4.0, 5.0, 6.0)).length() < 4e-15);
    assert!((b.angular_velocity() - Vec3::new(0.7, 0.8, 0.9)).length() < 4e-15);
    assert!((b.center_of_mass() - b.point([0.5, -0.2, 0.1])).length() < 4e-15);
    assert_eq!(b.mass(), 6000.0);
    let l = b.inertia() * b.angular_velocity();
    assert!((b.angular_momentum() - l).length() < 1e-14 * l.length(), "L = J ω");
    let (linear, angular) = b.kinetic_energy();
    assert!((linear - 0.5 * 6000.0 * 77.0).abs() < 1e-9 && (angular - 0.5 * l.dot(b.angular_velocity())).abs() < 1e-9);
}

/// The velocity of a material point is v + ω × r; its acceleration adds ω̇ × r + ω × (ω × r): both agree with differences
/// of positions over a short time.
#[test]
fn points_of_a_body_move_with_it() {
    let mut world = World::new();
    let id = world.add(brick().velocity([1.0, -2.0, 0.5]).angular_velocity([0.4, 1.0, -0.3])).unwrap();
    world.add_field(Field::linear_drag(3.0, 1.0)).unwrap();
    world.add_field(Field::spring(Anchor::world([0.0, 0.0, 5.0]), Anchor::on(id, [0.5, 0.0, 1.5]), 40.0, 1.0)).unwrap();
    let local = Vec3::new(0.3, -0.7, 1.2);
    let point = world.body(id).point(local);
    let (v, a) = (world.body(id).velocity_at(point), world.body(id).acceleration_at(point));
    let h = 1e-4;
    let at = |dt: f64| {
        let mut world = world.clone();
        world.step(dt);
        world.body(id).point(local)
    };
    let (ahead, behind) = (at(h), at(-h));
    // Central differences: h² times the third derivative, some 1e-7; rounding 1e-16/h² = 1e-8 for the second.
    assert!(((ahead - behind) / (2.0 * h) - v).length() < 1e-7);
    assert!(((ahead - point * 2.0 + behind) / (h * h) - a).length() < 1e-5);
}

#[test]
fn an_impulse_off_the_centre_moves_the_centre_all_the_same() {
    let mut world = World::new();
    let id = world.add(brick().position([5.0, 0.0, 0.0])).unwrap();
    world.body_mut(id).apply_impulse_at([0.0, 24.0, 0.0], [5.5, 0.0, 0.0]).unwrap();
    let b = world.body(id);
    assert_eq!(b.velocity(), Vec3::new(0.0, 2.0, 0.0), "v = J/m wherever it acts");
    assert!((b.angular_momentum() - Vec3::new(0.0, 0.0, 12.0)).length() < 1e-14, "L = r × J");
    assert!((b.angular_momentum_about([0.0; 3]) - Vec3::new(0.0, 0.0, 5.5 * 24.0)).length() < 1e-12);
    world.body_mut(id).apply_angular_impulse([1.0, 0.0, 0.0]).unwrap();
    world.body_mut(id).apply_impulse([12.0, 0.0, 0.0]).unwrap();
    assert_eq!(world.body(id).velocity(), Vec3::new(1.0, 2.0, 0.0));
}

#[test]
fn forces_sum_and_are_cleared_or_kept() {
    let mut world = World::new();
    world.set_gravity([0.0; 3]).unwrap();
    let id = world.add(brick()).unwrap();
    for _ in 0..3 {
        world.body_mut(id).apply_force([4.0, 0.0, 0.0]).unwrap();
        world.body_mut(id).apply_torque([0.0, 0.0, 1.0]).unwrap();
        world.body_mut(id).apply_local_force_at([0.0, 4.0, 0.0], [0.5, 0.0, 0.0]).unwrap();
    }
    let wrench = world.body(id).wrench();
    assert_eq!((wrench.force, wrench.torque), (Vec3::new(12.0, 12.0, 0.0), Vec3::new(0.0, 0.0, 9.0)));
    world.step(1.0);
    assert!((world.body(id).momentum() - Vec3::new(12.0, 12.0, 0.0)).length() < 1e-14);
    world.step(1.0);
    assert!((world.body(id).momentum() - Vec3::new(12.0, 12.0, 0.0)).length() < 1e-14, "cleared by the first step");
    world.keep_forces(true);
    world.body_mut(id).apply_force([1.0, 0.0, 0.0]).unwrap();
    (0..5).for_each(|_| drop(world.step(1.0)));
    assert!((world.body(id).momentum().x - 17.0).abs() < 1e-13, "kept for five steps");
    world.clear_forces();
    world.step(1.0);
    assert!((world.body(id).momentum().x - 17.0).abs() < 1e-13);
}

#[test]
fn ids_outlive_removals_and_are_never_reused() {
    let mut world = World::new();
    let ids: Vec<BodyId> = (0..10).map(|i| world.add(brick().position([f64::from(i), 0.0, 0.0])).unwrap()).collect();
    let fixed = world.add(Body::fixed().position([0.0, 7.0, 0.0])).unwrap();
    let spring = Field::spring(Anchor::on(ids[2], [0.0; 3]), Anchor::on(ids[3], [0.0; 3]), 1.0, 0.0);
    world.add_field(spring).unwrap();
    let pin = world.pin(ids[2], [0.0; 3]).unwrap();
    assert!(world.remove(ids[2]) && !world.remove(ids[2]));
    assert!(world.get(ids[2]).is_none() && world.get_mut(ids[2]).is_none());
    assert!(world.model().fields.is_empty() && world.pin_gap(pin).is_none(), "what hung on it went with it");
    let new = world.add(brick().position([0.0, 0.0, 9.0])).unwrap();
    assert!(new != ids[2] && world.get(ids[2]).is_none());
    for (i, &id) in ids.iter().enumerate().filter(|(i, _)| *i != 2) {
        assert_eq!(world.body(id).position().x, i as f64);
    }
    assert_eq!(world.body(fixed).position().y, 7.0);
    assert_eq!(world.len(), 11);
}

#[test]
fn kinematic_bodies_do_as_they_are_told() {
    let mut world = World::new();
    let id = world.add(Body::kinematic().velocity([1.0, 0.0, 0.0]).angular_velocity([0.0, 0.0, 0.5])).unwrap();
    for _ in 0..60 {
        world.step(1.0 / 60.0);
    }
    let b = world.body(id);
    // Sixty sums of 1/60.
    assert!((b.position() - Vec3::X).length() < 1e-14);
    assert!(b.rotation().angle_to(Quat::from_axis_angle(Vec3::Z, 0.5)) < 1e-14);
    assert_eq!((b.velocity(), b.momentum(), b.mass()), (Vec3::X, Vec3::ZERO, f64::INFINITY));
    let target = Quat::from_axis_angle(Vec3::Y, 1.0);
    world.body_mut(id).move_to([0.0, 2.0, 0.0], target, 0.25).unwrap();
    world.step(0.25);
    assert!((world.body(id).position() - Vec3::new(0.0, 2.0, 0.0)).length() < 1e-15 * 4.0);
    assert!(world.body(id).rotation().angle_to(target) < 1e-14);
    assert!(world.body_mut(id).apply_force([1.0, 0.0, 0.0]).is_err());
}

#[test]
fn bad_input_is_an_error_that_names_the_culprit() {
    let mut world = World::new();
    let mut refused = |body: Body, text: &str| {
        let before = world.len();
        let error = world.add(body).expect_err(text);
        assert!(error.to_string().starts_with(text), "got: {error}");
        assert_eq!(world.len(), before);
    };
    refused(Body::dynamic(), "shapes: a dynamic body needs a shape or mass properties");
    refused(brick().position([f64::NAN, 0.0, 0.0]), "position: is [NaN, 0.0, 0.0]; every component must be finite");
    refused(brick().velocity([0.0, f64::INFINITY, 0.0]), "velocity: ");
    refused(brick().rotation([0.0, 0.0, 0.0, 0.0]), "rotation: the quaternion [0.0, 0.0, 0.0, 0.0] has no direction");
    refused(brick().shape(Shape::sphere(-1.0)), "shapes[1].radius: must be positive and finite, is -1 m");
    refused(brick().gravity_scale(f64::NAN), "gravity_scale: ");
    refused(Body::fixed().velocity([1.0, 0.0, 0.0]), "velocity: a fixed body does not move");
    refused(Body::kinematic().angular_momentum([1.0, 0.0, 0.0]), "angular_momentum: only a dynamic body has one");
    refused(brick().velocity([1e308, 1e308, 0.0]), "velocity: the momentum overflows");
    let id = world.add(brick()).unwrap();
    let mut body = world.body_mut(id);
    assert!(body.apply_force([f64::NAN, 0.0, 0.0]).unwrap_err().to_string().starts_with("force: "));
    assert!(body.apply_force_at([1.0, 0.0, 0.0], [f64::NAN, 0.0, 0.0]).unwrap_err().to_string().starts_with("point: "));
    assert!(body.set_pose([0.0; 3], [f64::NAN, 0.0, 0.0, 0.0]).is_err());
    assert!(world.set_gravity([f64::NAN, 0.0, 0.0]).is_err());
    assert!(world.set_integrator("slides".parse().unwrap()).is_ok());
    assert!(world.pin(id, [0.0; 3]).unwrap_err().to_string().contains("slides does not close pinned points"));
}

/// Setting the pose keeps the velocities in world axes.
#[test]
fn a_body_can_be_put_elsewhere() {
    let mut world = World::new();
    let id = world.add(brick().velocity([1.0, 0.0, 0.0]).angular_velocity([0.1, 0.2, 0.3])).unwrap();
    let rot = Quat::from_rotation_vector(Vec3::new(1.0, 2.0, 0.5));
    world.body_mut(id).set_pose([3.0, 2.0, 1.0], rot).unwrap();
    let b = world.body(id);
    assert!(b.rotation().angle_to(rot) < 1e-15);
    assert!((b.angular_velocity() - Vec3::new(0.1, 0.2, 0.3)).length() < 1e-15);
    assert_eq!((b.position(), b.velocity()), (Vec3::new(3.0, 2.0, 1.0), Vec3::X));
    world.body_mut(id).set_velocity([0.0, 1.0, 0.0]).unwrap();
    world.body_mut(id).set_angular_velocity([0.0, 0.0, 2.0]).unwrap();
    // Four rotations of numbers up to 2: 16 roundings of ε.
    assert!((world.body(id).angular_velocity() - Vec3::new(0.0, 0.0, 2.0)).length() < 4e-15);
    world.body_mut(id).set_angular_momentum([0.0, 5.0, 0.0]).unwrap();
    assert_eq!(world.body(id).angular_momentum(), Vec3::new(0.0, 5.0, 0.0));
}
