//! The maps written for lanes give every lane the bits of one body alone.

use fearless_simd::{Level, Simd, dispatch};
use polhode::integrate::implicit_midpoint::rotate;
use polhode::math::{Quat, Vec3, Wide};

/// Bodies of different shapes and motions.
fn body(i: usize) -> (Quat, Vec3, Vec3) {
    let s = i as f64;
    (
        Quat::from_rotation_vector(Vec3::new(0.2 * s, 1.0 - 0.3 * s, 0.5)),
        Vec3::new(1.0 + s, -0.5 * s, 0.3),
        Vec3::new(1.0 + 0.1 * s, 2.0 - 0.1 * s, 2.5),
    )
}

#[inline(always)]
fn wide<S: Simd>(simd: S) -> Vec<Quat> {
    let lane = |part: &dyn Fn(usize) -> f64| Wide::from_fn(simd, part);
    let rot = Quat::new(lane(&|i| body(i).0.w), lane(&|i| body(i).0.x), lane(&|i| body(i).0.y), lane(&|i| body(i).0.z));
    let l = Vec3::new(lane(&|i| body(i).1.x), lane(&|i| body(i).1.y), lane(&|i| body(i).1.z));
    let inertia = Vec3::new(lane(&|i| body(i).2.x), lane(&|i| body(i).2.y), lane(&|i| body(i).2.z));
    let q = rotate(rot, l, inertia, Wide::splat(simd, 0.05));
    (0..Wide::<S>::LEN).map(|i| Quat::new(q.w.lane(i), q.x.lane(i), q.y.lane(i), q.z.lane(i))).collect()
}

#[test]
fn lanes_have_the_bits_of_single_bodies() {
    let level = Level::new();
    let turned = dispatch!(level, simd => wide(simd));
    for (i, turned) in turned.into_iter().enumerate() {
        let (rot, l, inertia) = body(i);
        assert_eq!(turned, rotate(rot, l, inertia, 0.05), "{i}");
    }
}
