//! Polygons of any shape and sense, and every refusal.

use crate::mass::{Moments, lamina, outline};
use crate::math::{Quat, Vec3};
use proptest::prelude::*;

/// An L of three unit squares.
const L: [[f64; 2]; 6] = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];

fn refusal(points: &[[f64; 2]]) -> String {
    let said = lamina::polygon(points, 1.0).unwrap_err().to_string();
    assert_eq!(outline::polygon(points, 0.1, 1.0).unwrap_err().to_string(), said);
    said
}

fn assert_same(a: &Moments, b: &Moments, size: f64) {
    // Some hundred roundings of squares of coordinates up to `size`.
    let allowed = 100.0 * f64::EPSILON * size * size * a.mass;
    assert!((a.mass - b.mass).abs() <= allowed && (a.center - b.center).max_abs() * a.mass <= allowed, "{a:?} {b:?}");
    assert!((a.second - b.second).max_abs() <= allowed, "{a:?} {b:?}");
}

#[test]
fn an_l_is_three_squares() {
    let square = |x: f64, y: f64| lamina::rectangle([1.0, 1.0], 2.0).unwrap().translated([x, y, 0.0]);
    let sum = square(0.5, 0.5) + square(1.5, 0.5) + square(0.5, 1.5);
    assert_same(&lamina::polygon(&L, 2.0).unwrap(), &sum, 2.0);
    let frame = outline::polygon(&L, 0.01, 2.0).unwrap();
    assert!((frame.mass - 8.0 * 0.01 * 2.0).abs() < 8.0 * f64::EPSILON);
}

#[test]
fn the_sense_of_rotation_and_the_first_corner_do_not_matter() {
    let a = lamina::polygon(&L, 2.0).unwrap();
    for shift in 0..L.len() {
        let mut turned = L;
        turned.rotate_left(shift);
        assert_same(&a, &lamina::polygon(&turned, 2.0).unwrap(), 2.0);
        turned.reverse();
        assert_same(&a, &lamina::polygon(&turned, 2.0).unwrap(), 2.0);
    }
}

#[test]
fn straight_corners_are_fine() {
    let mut points = L.to_vec();
    points.insert(1, [1.0, 0.0]);
    assert_same(&lamina::polygon(&L, 1.0).unwrap(), &lamina::polygon(&points, 1.0).unwrap(), 2.0);
}

#[test]
fn what_is_not_simple_is_refused_by_name() {
    let bow = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
    assert_eq!(refusal(&bow), "points: is not simple: its edge 0–1 touches or crosses its edge 2–3");
    // A corner that touches another edge.
    let touch = [[0.0, 0.0], [4.0, 0.0], [4.0, 2.0], [2.0, 0.0], [0.0, 2.0]];
    assert_eq!(refusal(&touch), "points: is not simple: its edge 0–1 touches or crosses its edge 2–3");
    // Two edges on one line that overlap.
    let overlap = [[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [2.0, 1.0], [2.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    assert_eq!(refusal(&overlap), "points: is not simple: its edge 0–1 touches or crosses its edge 3–4");
    let spike = [[0.0, 0.0], [2.0, 0.0], [1.0, 0.0], [1.0, 1.0]];
    assert_eq!(refusal(&spike), "points[1]: the outline turns back on itself");
    let repeated = [[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    assert_eq!(refusal(&repeated), "points[2]: is the same as the corner before it");
    let closed = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [0.0, 0.0]];
    assert_eq!(refusal(&closed), "points[0]: is the same as the corner before it");
    assert_eq!(refusal(&bow[..2]), "points: a polygon needs at least 3 corners, has 2");
    assert_eq!(refusal(&[[0.0, 0.0], [1.0, f64::NAN], [0.0, 1.0]]), "points[1]: must be finite, is (1, NaN)");
    assert_eq!(refusal(&[[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]]), "points[2]: the outline turns back on itself");
}

#[test]
fn neighbouring_numbers_are_still_told_apart() {
    // The upper edge passes one unit in the last place above the inner corner: exact predicates accept, and refuse contact.
    let above = 1.0 + f64::EPSILON;
    let simple = [[0.0, 0.0], [1.0, 1.0], [2.0, 0.0], [2.0, above], [0.0, above]];
    assert!(lamina::polygon(&simple, 1.0).is_ok());
    let touching = [[0.0, 0.0], [1.0, 1.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]];
    assert!(lamina::polygon(&touching, 1.0).is_err());
}

proptest! {
    #[test]
    fn no_polygon_panics(points in prop::collection::vec(any::<[f64; 2]>(), 0..8)) {
        let _ = lamina::polygon(&points, 1.0).and_then(|m| m.properties());
    }

    #[test]
    fn a_star_shaped_polygon_is_a_fan_of_triangles(
        radii in prop::collection::vec(0.2..1.0_f64, 5..40),
        angle in -3.0..3.0_f64,
        by in prop::array::uniform2(-5.0..5.0_f64),
    ) {
        let n = radii.len();
        let points: Vec<[f64; 2]> = radii.iter().enumerate().map(|(i, r)| {
            let (sin, cos) = libm::sincos(core::f64::consts::TAU * i as f64 / n as f64);
            [r * cos, r * sin]
        }).collect();
        let whole = lamina::polygon(&points, 3.0).unwrap();
        let fan: Moments = (0..n)
            .map(|i| lamina::polygon(&[[0.0, 0.0], points[i], points[(i + 1) % n]], 3.0).unwrap())
            .sum();
        assert_same(&whole, &fan, 1.0);

        let rot = Quat::from_axis_angle(Vec3::Z, angle);
        let shift = Vec3::new(by[0], by[1], 0.0);
        let moved: Vec<[f64; 2]> = points.iter().map(|&[x, y]| {
            let p = rot.rotate(Vec3::new(x, y, 0.0)) + shift;
            [p.x, p.y]
        }).collect();
        assert_same(&lamina::polygon(&moved, 3.0).unwrap(), &whole.rotated(rot).translated(shift), 8.0);
        let edges = outline::polygon(&points, 0.1, 3.0).unwrap();
        assert_same(&outline::polygon(&moved, 0.1, 3.0).unwrap(), &edges.rotated(rot).translated(shift), 8.0);
    }
}
