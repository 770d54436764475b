//! The schemes that ask for forces at their stages.

use super::reference::hv;
use super::slope::Claim;
use polhode::integrate::buss::Buss;
use polhode::integrate::dormand_prince::Settings;
use polhode::integrate::explicit_matrix::{ExplicitMatrix, matrix_angular_velocity};
use polhode::integrate::phase::{Law, Phase, Rates, Work, angular_velocity};
use polhode::integrate::phase_solver::PhaseSolver;
use polhode::integrate::{commutator_free, crouch_grossman, exact, explicit_euler, lie_midpoint, rk4, rkmk4};
use polhode::math::{Mat3, Quat, Vec3};

type Step<'a> = dyn Fn(&mut Law<'_>, f64, f64, &mut Phase, &mut Work) + 'a;

/// Bodies and their constants.
struct Bodies {
    mass: f64,
    inertia: Vec<Vec3>,
    start: Phase,
}

impl Bodies {
    /// v and ω of a phase.
    fn motion(&self, y: &Phase, rates: &mut Rates) {
        for body in 0..y.n_bodies() {
            rates.v[body] = y.p[body] / self.mass;
            rates.w[body] = angular_velocity(y.rot[body], y.l[body], self.inertia[body]);
        }
    }
    /// Two bodies: a spring holds a corner of the first to the origin, another joins their other corners; a force that
    /// depends on time pushes the second, which falls.
    fn chained() -> Self {
        let start = Phase {
            x: vec![Vec3::new(0.4, 0.1, -0.2), Vec3::new(1.5, -0.3, 0.2)],
            rot: vec![Quat::from_rotation_vector(Vec3::new(0.3, 1.0, -0.4)), Quat::IDENTITY],
            p: vec![Vec3::new(0.1, 0.2, -0.3), Vec3::new(-0.4, 0.0, 0.5)],
            l: vec![Vec3::new(0.2, -0.3, 0.4), Vec3::new(0.1, 0.5, 0.2)],
        };
        Self { mass: 0.7, inertia: vec![Vec3::new(0.2, 0.3, 0.4), Vec3::new(0.5, 0.25, 0.35)], start }
    }
    fn chained_law(&self) -> impl FnMut(f64, &Phase, &mut Rates) + '_ {
        |t, y, rates| {
            self.motion(y, rates);
            let arm = |body: usize, corner: Vec3| y.rot[body].rotate(corner);
            let (a, b, c) =
                (arm(0, Vec3::new(-0.3, 0.1, 0.2)), arm(0, Vec3::new(0.4, 0.0, -0.1)), arm(1, Vec3::Y * -0.3));
            let to_anchor = -(y.x[0] + a) * 5.0;
            let between = (y.x[1] + c - y.x[0] - b) * 3.0;
            let push = Vec3::new(libm::sin(3.0 * t), 0.0, -9.81 * self.mass);
            rates.force[0] = to_anchor + between;
            rates.torque[0] = a.cross(to_anchor) + b.cross(between);
            rates.force[1] = push - between;
            rates.torque[1] = -c.cross(between);
        }
    }
    /// A free top at rest at the origin.
    fn free(inertia: Vec3, l: Vec3) -> Self {
        let mut start = Phase::at_rest(1);
        start.l[0] = l;
        Self { mass: 1.0, inertia: vec![inertia], start }
    }
    fn free_law(&self) -> impl FnMut(f64, &Phase, &mut Rates) + '_ {
        |_, y, rates| {
            self.motion(y, rates);
            rates.force.fill(Vec3::ZERO);
            rates.torque.fill(Vec3::ZERO);
        }
    }
}

fn run(step: &Step<'_>, law: &mut Law<'_>, start: &Phase, time: f64, n: usize) -> Phase {
    let (mut y, mut work, h) = (start.clone(), Work::new(), time / n as f64);
    for i in 0..n {
        step(law, i as f64 * h, h, &mut y, &mut work);
    }
    y
}

/// The largest difference in any x [m], rot [rad], p and l.
fn distance(a: &Phase, b: &Phase) -> f64 {
    let vectors = |a: &[Vec3], b: &[Vec3]| a.iter().zip(b).map(|(a, b)| (*a - *b).length()).fold(0.0, f64::max);
    vectors(&a.x, &b.x).max(vectors(&a.p, &b.p)).max(vectors(&a.l, &b.l)).max(angle_between(a, b))
}

/// The largest angle between two attitudes of a body [rad].
fn angle_between(a: &Phase, b: &Phase) -> f64 {
    a.rot.iter().zip(&b.rot).map(|(a, b)| a.angle_to(*b)).fold(0.0, f64::max)
}

/// Every scheme, with its order and the attitude error on free_top_HV at h = 0.025 s after 10 s that an independent
/// implementation has (two digits).
fn schemes(inertia: &[Vec3]) -> Vec<(&'static str, usize, f64, Box<Step<'_>>)> {
    vec![
        ("explicit Euler", 1, 0.42, Box::new(explicit_euler::step)),
        ("Buss", 2, 2.8e-3, Box::new(|f, t, h, y, work| Buss { inertia }.step(f, t, h, y, work))),
        ("Lie midpoint", 2, 2.1e-3, Box::new(lie_midpoint::step)),
        ("Crouch-Grossman", 3, 1.8e-4, Box::new(crouch_grossman::step)),
        ("RK4", 4, 1.0e-6, Box::new(rk4::step)),
        ("RKMK4", 4, 1.5e-7, Box::new(rkmk4::step)),
        ("commutator-free", 4, 4.1e-7, Box::new(commutator_free::step)),
    ]
}

#[test]
fn schemes_have_their_order_with_forces() {
    let bodies = Bodies::chained();
    let mut solver = PhaseSolver::new(Settings::tolerance(1e-13), 0.0, &bodies.start).unwrap();
    solver.advance(&mut bodies.chained_law(), 1.0).unwrap();
    // The stiffest mode has √(k (1/m + r²/I)) = √(8 (1/0.7 + 0.17/0.2)) = 4.3 rad/s.
    let angle = 4.3 / 32.0;
    for (name, order, _, step) in schemes(&bodies.inertia) {
        let end = |n: usize| run(&*step, &mut bodies.chained_law(), &bodies.start, 1.0, 32 * n);
        let claim = Claim { order, symmetric: false, angle, halvings: 3 };
        claim.assert(name, |n| distance(&end(n), solver.phase()));
        // The largest error of all may be one of momentum: see that of the attitudes by itself, too.
        claim.assert(name, |n| angle_between(&end(n), solver.phase()));
    }
}

#[test]
fn schemes_have_their_order_on_the_free_top() {
    let top = hv();
    let bodies = Bodies::free(top.inertia, top.l);
    let time = 64.0 * 0.08 / top.fastest();
    let exact = exact::rotate(Quat::IDENTITY, top.l, top.inertia, time);
    for (name, order, figure, step) in schemes(&bodies.inertia) {
        let end = |time, n| run(&*step, &mut bodies.free_law(), &bodies.start, time, n);
        Claim { order, symmetric: false, angle: 0.08, halvings: 3 }
            .assert(name, |n| end(time, 64 * n).rot[0].angle_to(exact));
        let after = end(10.0, 400);
        let ratio = after.rot[0].angle_to(top.attitude_at(10.0)) / figure;
        // Two digits: 15 may be 15.5.
        assert!((14.5 / 15.0..15.5 / 15.0).contains(&ratio), "{name}: {ratio}");
        assert_eq!(after.l, bodies.start.l, "{name} conserves L bit by bit");
    }
}

#[test]
fn quaternions_stay_units() {
    let bodies = Bodies::chained();
    for (name, _, _, step) in schemes(&bodies.inertia) {
        let end = run(&*step, &mut bodies.chained_law(), &bodies.start, 20.0, 4_000);
        for rot in end.rot {
            // Each step ends with a normalisation: what is left is its own rounding.
            assert!((rot.norm_squared() - 1.0).abs() < 4.0 * f64::EPSILON, "{name}");
        }
    }
}

#[test]
fn parabola_is_exact_from_order_two() {
    let mut start = Phase::at_rest(1);
    start.p[0] = Vec3::new(3.0, 0.0, 4.0);
    let bodies = Bodies { mass: 2.0, inertia: vec![Vec3::splat(1.0)], start };
    let mut law = |_: f64, y: &Phase, rates: &mut Rates| {
        bodies.motion(y, rates);
        rates.force[0] = Vec3::new(0.0, 0.0, -9.81 * 2.0);
        rates.torque[0] = Vec3::ZERO;
    };
    for (name, order, _, step) in schemes(&bodies.inertia) {
        let end = run(&*step, &mut law, &bodies.start, 1.7, 10).x[0];
        let error = (end - Vec3::new(1.5 * 1.7, 0.0, 2.0 * 1.7 - 0.5 * 9.81 * 1.7 * 1.7)).length();
        // Ten steps of four roundings of numbers up to 14.
        assert_eq!(error < 40.0 * 14.0 * f64::EPSILON, order >= 2, "{name}: {error:e}");
    }
}

#[test]
fn explicit_euler_feeds_an_oscillator() {
    // E grows by 1 + h²k/m a step, whatever the phase.
    let (k, h) = (3.0, 0.02);
    let mut start = Phase::at_rest(1);
    start.x[0] = Vec3::new(1.0, -0.5, 0.2);
    let bodies = Bodies { mass: 0.5, inertia: vec![Vec3::splat(1.0)], start };
    let mut law = |_: f64, y: &Phase, rates: &mut Rates| {
        bodies.motion(y, rates);
        rates.force[0] = y.x[0] * -k;
        rates.torque[0] = Vec3::ZERO;
    };
    let energy = |y: &Phase| y.p[0].length_squared() / bodies.mass + k * y.x[0].length_squared();
    let end = run(&explicit_euler::step, &mut law, &bodies.start, 600.0 * h, 600);
    let grown = libm::pow(1.0 + h * h * k / bodies.mass, 600.0);
    // 600 steps of some six roundings.
    assert!((energy(&end) / energy(&bodies.start) / grown - 1.0).abs() < 3600.0 * f64::EPSILON);
}

#[test]
fn storage_carries_nothing_over_and_is_kept() {
    let (bodies, top) = (Bodies::chained(), Bodies::free(Vec3::new(0.6, 0.8, 1.0), Vec3::new(1.0, 0.2, -0.3)));
    for (name, _, _, step) in schemes(&bodies.inertia) {
        let fresh = run(&*step, &mut bodies.chained_law(), &bodies.start, 0.1, 5);
        let (mut y, mut work) = (bodies.start.clone(), Work::new());
        // Other bodies and another scheme have used the storage before.
        step(&mut top.free_law(), 0.0, 0.1, &mut top.start.clone(), &mut work);
        rk4::step(&mut bodies.chained_law(), 0.0, 7.0, &mut bodies.start.clone(), &mut work);
        let mut addresses = Vec::new();
        let mut chained = bodies.chained_law();
        let mut law = |t: f64, y: &Phase, rates: &mut Rates| {
            addresses.push((y.rot.as_ptr(), rates.torque.as_ptr()));
            chained(t, y, rates);
        };
        for i in 0..5 {
            let h = 0.1 / 5.0;
            step(&mut law, f64::from(i) * h, h, &mut y, &mut work);
        }
        assert_eq!(y, fresh, "{name}");
        let stages = addresses.len() / 5;
        assert!(addresses.chunks(stages).all(|step| step == &addresses[..stages]), "{name} allocates");
    }
}

#[test]
fn adaptive_solver_meets_the_exact_top_and_says_when_it_cannot_go_on() {
    let top = hv();
    let bodies = Bodies::free(top.inertia, top.l);
    let mut solver = PhaseSolver::new(Settings::tolerance(1e-12), 0.0, &bodies.start).unwrap();
    solver.advance(&mut bodies.free_law(), 3.0).unwrap();
    while solver.t() < 10.0 {
        let before = solver.t();
        solver.step(&mut bodies.free_law(), 10.0).unwrap();
        let t = 0.5 * (before + solver.t());
        let error = solver.interpolate(t).rot[0].angle_to(exact::rotate(Quat::IDENTITY, top.l, top.inertia, t));
        // The steps' errors add up to at most their number in tolerances of unit numbers; the interpolant of order 4
        // errs by a power of h less than a step of order 5.
        assert!(error < solver.n_steps().0 as f64 * 1e-12 / (solver.t() - before), "{error:e}");
    }
    let error = solver.phase().rot[0].angle_to(top.attitude_at(10.0));
    assert!(error < 2.0 * solver.n_steps().0 as f64 * 1e-12, "{error:e}");

    let mut fall_apart = |t: f64, y: &Phase, rates: &mut Rates| {
        bodies.motion(y, rates);
        rates.force[0] = Vec3::X / (20.0 - t);
        rates.torque[0] = if t < 15.0 { Vec3::ZERO } else { Vec3::splat(f64::NAN) };
    };
    let error = solver.advance(&mut fall_apart, 30.0).unwrap_err();
    assert_eq!(error.path(), "step");
    assert!(solver.t() > 14.9 && solver.t() <= 15.0 && solver.phase().rot[0].is_finite());
}

/// R after n steps of the slides' scheme, and the phase.
fn run_matrix(scheme: &ExplicitMatrix<'_>, bodies: &Bodies, time: f64, n: usize) -> (Mat3, Phase) {
    let (mut y, mut r, mut work) = (bodies.start.clone(), [Mat3::IDENTITY], Work::new());
    let h = time / n as f64;
    for i in 0..n {
        scheme.step(&mut bodies.free_law(), (i as f64 * h, h), &mut y, &mut r, &mut work);
    }
    (r[0], y)
}

#[test]
fn explicit_matrix_leaves_the_rotations_at_the_known_rate() {
    let inertia = Vec3::new(0.2, 0.3, 0.5);
    let bodies = Bodies::free(inertia, Vec3::Z * (0.5 * 10.0));
    let scheme = ExplicitMatrix { inertia: &bodies.inertia, gram_schmidt: false };
    // 10 rad/s about a principal axis for 10 s at 60 Hz: the columns across it grow by √(1 + h²ω²) a step.
    let (r, y) = run_matrix(&scheme, &bodies, 10.0, 600);
    let grown = libm::pow(1.0 + 1.0 / 36.0, 300.0);
    assert!((grown / 3.71e3 - 1.0).abs() < 1e-3);
    for k in 0..2 {
        // 600 steps of some five roundings.
        assert!((r.cols[k].length() / grown - 1.0).abs() < 3000.0 * f64::EPSILON);
    }
    assert_eq!(r.cols[2], Vec3::Z);
    assert!((r.determinant() / (grown * grown) - 1.0).abs() < 6000.0 * f64::EPSILON);
    assert_eq!((y.l[0], y.x[0]), (bodies.start.l[0], Vec3::ZERO));
    // Each step turns by atan(hω) rather than hω.
    let angle = 600.0 * libm::atan(1.0 / 6.0);
    assert!(y.rot[0].angle_to(Quat::from_axis_angle(Vec3::Z, angle)) < 3000.0 * f64::EPSILON);

    let kept = ExplicitMatrix { gram_schmidt: true, ..scheme };
    let (r, y) = run_matrix(&kept, &bodies, 10.0, 600);
    assert!((r.transposed() * r - Mat3::IDENTITY).max_abs() < 4.0 * f64::EPSILON);
    assert!(y.rot[0].angle_to(Quat::from_axis_angle(Vec3::Z, angle)) < 3000.0 * f64::EPSILON);
}

#[test]
fn explicit_matrix_is_of_first_order_and_its_drift_falsifies_the_angular_velocity() {
    let top = hv();
    let bodies = Bodies::free(top.inertia, top.l);
    let time = 64.0 * 0.02 / top.fastest();
    let exact = exact::rotate(Quat::IDENTITY, top.l, top.inertia, time).to_mat3();
    for gram_schmidt in [false, true] {
        let scheme = ExplicitMatrix { inertia: &bodies.inertia, gram_schmidt };
        Claim { order: 1, symmetric: false, angle: 0.02, halvings: 3 }
            .assert("explicit Euler on R", |n| (run_matrix(&scheme, &bodies, time, 64 * n).0 - exact).max_abs());
        // At h = 0.025 s the attitude means nothing after 10 s: 1.1 rad off with Gram–Schmidt, not finite without, since
        // ω grows with the square of R.
        let (r, y) = run_matrix(&scheme, &bodies, 10.0, 400);
        let error = y.rot[0].angle_to(top.attitude_at(10.0));
        assert!(if gram_schmidt { error > 1.0 } else { error.is_nan() }, "{error}");
        let w = matrix_angular_velocity(&r, top.l, top.inertia).length();
        // |ω| lies between |L|/I_max and |L|/I_min as long as R is a rotation.
        let possible = w < top.l.length() / 0.6 * (1.0 + 8.0 * f64::EPSILON);
        assert_eq!(possible, gram_schmidt, "{w}");
    }
}
