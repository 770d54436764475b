//! The maps of free rotation: their order, and what they conserve.

use super::reference::{FreeTop, hv, over, water};
use super::slope::Claim;
use polhode::integrate::composition::Composition;
use polhode::integrate::pdmv::Order;
use polhode::integrate::{exact, exponential, implicit_midpoint, lanes, splitting, symmetric_top};
use polhode::math::{Quat, Vec3};

type Map = fn(Quat, Vec3, Vec3, f64) -> Quat;

fn pdmv(order: Order, rot: Quat, l: Vec3, inertia: Vec3, h: f64) -> Quat {
    lanes::rotate_one(order, rot, l, over(Vec3::splat(1.0), inertia), h)
}

const IMPLICIT: [(&str, Map); 2] =
    [("implicit midpoint", implicit_midpoint::rotate::<f64>), ("DMV", |r, l, i, h| pdmv(Order::Two, r, l, i, h))];
const PREPROCESSED: [(&str, Map, usize); 4] = [
    ("pDMV4", |r, l, i, h| pdmv(Order::Four, r, l, i, h), 4),
    ("pDMV6", |r, l, i, h| pdmv(Order::Six, r, l, i, h), 6),
    ("pDMV8", |r, l, i, h| pdmv(Order::Eight, r, l, i, h), 8),
    ("pDMV10", |r, l, i, h| pdmv(Order::Ten, r, l, i, h), 10),
];
const SPLITTINGS: [(&str, Map); 2] =
    [("1-2-3-2-1 splitting", splitting::rotate), ("symmetric-top splitting", symmetric_top::rotate)];

fn preprocessed() -> impl Iterator<Item = (&'static str, Map)> {
    PREPROCESSED.into_iter().map(|(name, map, _)| (name, map))
}

/// The attitude after n steps of h, each in the fractions of a composition.
fn run(map: Map, composition: Composition, top: &FreeTop, h: f64, n: usize) -> Quat {
    let mut rot = Quat::IDENTITY;
    for _ in 0..n {
        for fraction in composition.fractions() {
            rot = map(rot, top.l, top.inertia, fraction * h);
        }
    }
    rot
}

/// (E − E(0))/E(0).
fn energy_error(top: &FreeTop, rot: Quat) -> f64 {
    let twice = |y: Vec3| y.dot(over(y, top.inertia));
    twice(rot.inverse_rotate(top.l)) / twice(top.l) - 1.0
}

/// The attitude error after 64 steps of h, or the same time in n times as many.
fn error_of(map: Map, composition: Composition, top: &FreeTop, h: f64) -> impl Fn(usize) -> f64 {
    let end = exact::rotate(Quat::IDENTITY, top.l, top.inertia, 64.0 * h);
    move |n| run(map, composition, top, h / n as f64, 64 * n).angle_to(end)
}

#[test]
fn maps_have_their_order() {
    let (top, angle) = (hv(), 0.08);
    let h = angle / top.fastest();
    let first = Claim { order: 1, symmetric: false, angle, halvings: 3 };
    first.assert("exponential", error_of(exponential::rotate, Composition::Single, &top, h));
    let second = Claim { order: 2, symmetric: true, ..first };
    for (name, map) in IMPLICIT.into_iter().chain(SPLITTINGS) {
        second.assert(name, error_of(map, Composition::Single, &top, h));
    }
    // 8 and 10 are at rounding for every step they take undivided.
    for (name, map, order) in &PREPROCESSED[..2] {
        let claim = Claim { order: *order, symmetric: true, angle: 0.4, halvings: 3 };
        claim.assert(name, error_of(*map, Composition::Single, &top, 0.4 / top.fastest()));
    }
}

#[test]
fn compositions_raise_the_order() {
    let assert = |top: &FreeTop, maps: [(&str, Map); 2], composition: Composition, angle: f64, halvings| {
        let longest = composition.fractions().iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        let order = Claim { order: composition.order(), symmetric: true, angle: longest * angle, halvings };
        for (name, map) in maps {
            let error = error_of(map, composition, top, angle / top.fastest());
            order.assert(&format!("{composition:?} of {name}"), error);
        }
    };
    for maps in [IMPLICIT, SPLITTINGS] {
        assert(&hv(), maps, Composition::Yoshida4, 0.08, 3);
        assert(&hv(), maps, Composition::Suzuki4, 0.16, 3);
        assert(&water(), maps, Composition::KahanLi6, 0.5, 3);
    }
    assert(&water(), IMPLICIT, Composition::KahanLi8, 0.8, 3);
    // Three halvings of order 8 span seven decades, which these two have not got above rounding.
    assert(&water(), SPLITTINGS, Composition::KahanLi8, 1.0, 2);
}

#[test]
fn attitude_errors_are_those_of_an_independent_implementation() {
    // free_top_HV, h = 0.025 s, after 10 s, against figures of one or two digits: 8 may be 8.5.
    let top = hv();
    let end = top.attitude_at(10.0);
    let error = |map: Map, composition: Composition| run(map, composition, &top, 0.025, 400).angle_to(end);
    for (name, map, composition, figure) in [
        ("exponential", exponential::rotate as Map, Composition::Single, 0.42),
        ("implicit midpoint", IMPLICIT[0].1, Composition::Single, 1.7e-2),
        ("DMV", IMPLICIT[1].1, Composition::Single, 3.3e-2),
        ("pDMV4", PREPROCESSED[0].1, Composition::Single, 1.1e-5),
        ("pDMV6", PREPROCESSED[1].1, Composition::Single, 1.7e-9),
        ("splitting", splitting::rotate, Composition::Single, 9.0e-4),
        ("splitting", splitting::rotate, Composition::Yoshida4, 1.0e-5),
        ("splitting", splitting::rotate, Composition::Suzuki4, 1.5e-7),
        ("splitting", splitting::rotate, Composition::KahanLi6, 8e-11),
    ] {
        let error = error(map, composition);
        assert!((7.5 / 8.0..8.5 / 8.0).contains(&(error / figure)), "{name} {composition:?}: {error:e}");
    }
    // 400 steps of some 3 ε each, at random, and as much again for the phase along the polhode.
    assert!(error(PREPROCESSED[3].1, Composition::Single) < 2.0 * 3.0 * f64::EPSILON * 20.0);
    // That one had its axes a and b the other way round: 7.8e-5.
    assert!(error(symmetric_top::rotate, Composition::Single) < 7.8e-5);
}

#[test]
fn symmetric_maps_undo_themselves() {
    let top = hv();
    for (name, map) in
        IMPLICIT.into_iter().chain(SPLITTINGS).chain(preprocessed()).chain([("exact", exact::rotate as Map)])
    {
        let there = map(Quat::IDENTITY, top.l, top.inertia, 0.1);
        let back = map(there, top.l, top.inertia, -0.1);
        // Two maps of some 40 roundings of unit quaternions, of which a few survive their averaging.
        assert!(back.angle_to(Quat::IDENTITY) < 8.0 * f64::EPSILON, "{name}");
    }
    // The exponential is no symmetric map: it must fail the same test.
    let there = exponential::rotate(Quat::IDENTITY, top.l, top.inertia, 0.1);
    assert!(exponential::rotate(there, top.l, top.inertia, -0.1).angle_to(Quat::IDENTITY) > 1e-3);
}

#[test]
fn implicit_maps_conserve_energy_to_rounding() {
    let top = hv();
    for (name, map) in IMPLICIT.into_iter().chain(preprocessed()) {
        for angle in [0.05, 0.5] {
            let mut rot = Quat::IDENTITY;
            let mut worst: f64 = 0.0;
            for _ in 0..10_000 {
                rot = map(rot, top.l, top.inertia, angle / top.fastest());
                worst = worst.max(energy_error(&top, rot).abs());
            }
            // A step rounds the energy by some 10 ε; 1e4 of them, at random, by 10 ε √1e4; at three sigma.
            assert!(worst < 3.0 * 10.0 * f64::EPSILON * 100.0, "{name} {angle}: {worst:e}");
        }
    }
}

#[test]
fn splittings_keep_energy_within_a_bound() {
    let top = hv();
    let worst = |map: Map, n: usize| {
        let mut rot = Quat::IDENTITY;
        (0..n).fold(0.0_f64, |worst, _| {
            rot = map(rot, top.l, top.inertia, 0.02);
            worst.max(energy_error(&top, rot).abs())
        })
    };
    for (name, map) in SPLITTINGS {
        // A shadow energy is conserved, so that the error is a function of where on the polhode y is: 400 steps see the
        // whole polhode, 1e5 steps sample its maximum more densely, by 1 − cos of a step's phase.
        let (once, often) = (worst(map, 400), worst(map, 100_000));
        assert!(often < 1.01 * once, "{name}: {once:e} {often:e}");
    }
    let (once, often) = (worst(exponential::rotate, 400), worst(exponential::rotate, 4_000));
    assert!(often > 1.5 * once, "the exponential drifts: {once:e} {often:e}");
}

#[test]
fn maps_agree_in_every_permutation_of_axes() {
    // A cyclic permutation of the axes is a rotation of the body frame: only the splitting prefers an axis.
    let top = hv();
    let turn = |v: Vec3| Vec3::new(v.y, v.z, v.x);
    let others = [SPLITTINGS[1], ("exact", exact::rotate as Map)];
    for (name, map) in IMPLICIT.into_iter().chain(preprocessed()).chain(others) {
        let q = map(Quat::IDENTITY, top.l, top.inertia, 0.1);
        let permuted = map(Quat::IDENTITY, turn(top.l), turn(top.inertia), 0.1);
        let expected = Quat::from_parts(q.w, turn(q.vector()));
        assert!(permuted.angle_to(expected) < 4.0 * f64::EPSILON, "{name}");
    }
}
