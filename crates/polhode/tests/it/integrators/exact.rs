//! The exact free rotation against everything it can be checked with.

use super::reference::{FreeTop, free_tops, hv, numbers, over, quat, vec3};
use polhode::integrate::{exact::rotate, symmetric_top};
use polhode::math::{Quat, Vec3};
use proptest::prelude::*;
use serde_json::Value;

const EPS: f64 = f64::EPSILON;

/// How much the attitude after h changes \[rad\] per change of the inputs: of each moment in proportion, and of l by a
/// part of |l| in each direction. An algorithm that rounds its inputs once errs by ε times this, whatever follows.
fn condition(rot: Quat, l: Vec3, inertia: Vec3, h: f64) -> f64 {
    let delta = 1e-8;
    let start = rotate(rot, l, inertia, h);
    let mut sum = 0.0;
    for k in 0..3 {
        let (mut l1, mut i1) = (l, inertia);
        l1[k] += delta * l.length();
        i1[k] *= 1.0 + delta;
        sum += (rotate(rot, l1, inertia, h).angle_to(start) + rotate(rot, l, i1, h).angle_to(start)) / delta;
    }
    sum
}

#[test]
fn every_row_of_the_references_is_met() {
    for FreeTop { name, inertia, l, rows } in free_tops() {
        for (t, attitude, w) in rows {
            let rot = rotate(Quat::IDENTITY, l, inertia, t);
            // The files' moments and l = Iω are themselves rounded to f64: two roundings of each input.
            let tolerance = 2.0 * EPS * (1.0 + condition(Quat::IDENTITY, l, inertia, t));
            assert!(tolerance < 1e-11, "{name} {t} is well enough conditioned to tell: {tolerance:e}");
            let error = rot.angle_to(attitude);
            assert!(error < tolerance, "{name} at {t}: {error:e} > {tolerance:e}");
            let w_error = (over(rot.inverse_rotate(l), inertia) - w).length();
            assert!(w_error < tolerance * (1.0 + w.length()), "{name} at {t}: {w_error:e}");
        }
    }
}

#[test]
fn error_is_that_of_the_input_next_to_every_limit() {
    // Random bodies; next to the separatrix, to symmetry, to a principal axis; needles and plates; up to 1e6 rad.
    let json: Value =
        serde_json::from_str(include_str!("../../../../polhode-cli/reference/free_body_hard.json")).unwrap();
    for row in json["rows"].as_array().unwrap() {
        let [inertia, l, q] = [1, 2, 4].map(|k| numbers(&row[k]));
        let (h, condition) = (row[3].as_f64().unwrap(), row[5].as_f64().unwrap());
        let error = rotate(Quat::IDENTITY, vec3(&l), vec3(&inertia), h).angle_to(quat(&q));
        // As if each input were rounded twice, and the result once.
        let tolerance = 2.0 * EPS * (1.0 + condition);
        assert!(error < tolerance, "{}: {error:e} > {tolerance:e}", row[0]);
    }
}

#[test]
fn body_returns_to_its_momentum_after_the_period() {
    // 4K/Ω to 22 digits, from an independent evaluation.
    let periods = [6.862616178058116410900302, 55.06168110746637198605687, 2.214644655833043096257984];
    for (top, period) in free_tops().iter().zip(periods) {
        let y = rotate(Quat::IDENTITY, top.l, top.inertia, period).inverse_rotate(top.l);
        let tolerance = 2.0 * EPS * (1.0 + condition(Quat::IDENTITY, top.l, top.inertia, period));
        assert!((y - top.l).length() < tolerance * top.l.length(), "{}", top.name);
    }
}

#[test]
fn symmetric_and_spherical_bodies_have_their_closed_forms() {
    let (rot, l) = (Quat::from_rotation_vector(Vec3::new(0.3, -1.0, 0.2)), Vec3::new(0.4, 1.5, -0.7));
    for h in [-3.0_f64, 1e-6, 0.1, 20.0] {
        let angle = h.abs() * l.length() / 0.5;
        let sphere = rotate(rot, l, Vec3::splat(0.5), h);
        assert!(sphere.angle_to(Quat::from_rotation_vector(l * (h / 0.5)) * rot) < (4.0 + angle) * EPS);
        for inertia in [[0.5, 0.5, 0.9], [0.9, 0.5, 0.5], [0.5, 0.9, 0.5], [0.5, 0.5, 0.1], [0.1, 0.5, 0.5]] {
            // The symmetric-top splitting has nothing to mend here, so it is exact by another way.
            let other = symmetric_top::rotate(rot, l, inertia.into(), h);
            let spin = h.abs() * l.length() / 0.1;
            let error = rotate(rot, l, inertia.into(), h).angle_to(other);
            assert!(error < (8.0 + 4.0 * spin) * EPS, "{inertia:?} {h}: {error:e}");
        }
    }
}

#[test]
fn rest_and_principal_axes_stand_still() {
    let (rot, inertia) = (Quat::from_rotation_vector(Vec3::new(1.0, 2.0, -0.5)), Vec3::new(0.6, 0.8, 1.0));
    assert_eq!(rotate(rot, Vec3::ZERO, inertia, 3.0), rot);
    assert_eq!(rotate(rot, Vec3::new(1.0, 2.0, 3.0), inertia, 0.0), rot);
    for (axis, moment) in [(Vec3::X, 0.6), (Vec3::Y, 0.8), (Vec3::Z, 1.0)] {
        // From the identity the middle axis, too, is met exactly: unstable, but nothing pushes it off.
        let turned = rotate(Quat::IDENTITY, axis * -2.0, inertia, 500.0);
        let angle: f64 = -1000.0 / moment;
        assert!(turned.angle_to(Quat::from_axis_angle(axis, angle)) < 2.0 * angle.abs() * EPS);
    }
    // Momenta and moments of any size.
    let top = hv();
    let usual = rotate(rot, top.l, top.inertia, 2.0);
    for scale in [1e-150, 1e120] {
        let scaled = rotate(rot, top.l * scale, top.inertia * scale, 2.0);
        assert!(scaled.angle_to(usual) < 2.0 * EPS * condition(rot, top.l, top.inertia, 2.0), "{scale:e}");
    }
}

#[test]
fn input_that_is_no_body_gives_no_panic() {
    let values = [f64::NAN, f64::INFINITY, 0.0, -1.0, 1e-320, 1.0];
    for a in values {
        for b in values {
            for h in values {
                let _ = rotate(Quat::IDENTITY, Vec3::new(a, 1.0, b), Vec3::new(1.0, a, b), h);
            }
        }
    }
}

/// 1 ± 10^−a, or ± 10^−a.
fn tiny() -> impl Strategy<Value = f64> {
    (0.0..17.0_f64, any::<bool>()).prop_map(|(a, up)| if up { 1.0 } else { -1.0 } / libm::pow(10.0, a))
}

/// The composition law of the flow, to the accuracy that the inputs allow.
fn assert_two_steps_are_one(l: Vec3, inertia: Vec3, h1: f64, h2: f64) -> Result<(), TestCaseError> {
    let rot = Quat::from_rotation_vector(Vec3::new(0.1, 0.7, -2.0));
    let halfway = rotate(rot, l, inertia, h1);
    let (two, one) = (rotate(halfway, l, inertia, h2), rotate(rot, l, inertia, h1 + h2));
    let sum = condition(rot, l, inertia, h1 + h2)
        + condition(halfway, l, inertia, h2) * (1.0 + condition(rot, l, inertia, h1));
    // Each of the three maps rounds its inputs twice; what the first errs, the second multiplies.
    prop_assert!(two.angle_to(one) < 2.0 * EPS * (3.0 + sum), "{:e}", two.angle_to(one));
    Ok(())
}

proptest! {
    #[test]
    fn two_steps_are_one(
        moments in prop::array::uniform3(0.05..3.0_f64),
        l in prop::array::uniform3(-2.0..2.0_f64),
        (h1, h2) in (-20.0..20.0_f64, -20.0..20.0_f64),
    ) {
        assert_two_steps_are_one(l.into(), moments.into(), h1, h2)?;
    }

    #[test]
    fn two_steps_are_one_next_to_symmetry_and_to_axes(
        moments in prop::array::uniform3(tiny()),
        l in prop::array::uniform3(tiny()),
        (h1, h2) in (-20.0..20.0_f64, -20.0..20.0_f64),
    ) {
        assert_two_steps_are_one(l.into(), moments.map(|gap| 1.0 + 0.9 * gap).into(), h1, h2)?;
    }

    #[test]
    fn energy_is_kept(
        moments in prop::array::uniform3(0.05..3.0_f64),
        l in prop::array::uniform3(-2.0..2.0_f64),
        h in -1e4..1e4_f64,
    ) {
        let (l, inertia): (Vec3, Vec3) = (l.into(), moments.into());
        let twice = |rot: Quat| { let y = rot.inverse_rotate(l); y.dot(over(y, inertia)) };
        let (before, after) = (twice(Quat::IDENTITY), twice(rotate(Quat::IDENTITY, l, inertia, h)));
        // y turns by some ten roundings; E changes by |ω| for each unit of y.
        let slope = over(l, inertia).length().max((before / inertia.x.min(inertia.y).min(inertia.z)).sqrt());
        prop_assert!((after - before).abs() < 2.0 * 20.0 * EPS * slope * l.length());
    }
}
