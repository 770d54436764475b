//! The maps written for lanes give every lane the bits of one body alone.

use fearless_simd::{Level, Simd, SimdBase, dispatch, f64x8};
use polhode::integrate::{dmv, implicit_midpoint};
use polhode::math::{Quat, Vec3};

const N: usize = 8;

/// Bodies of eight shapes and motions.
fn body(i: usize) -> (Quat, Vec3, Vec3) {
    let s = i as f64;
    (
        Quat::from_rotation_vector(Vec3::new(0.2 * s, 1.0 - 0.3 * s, 0.5)),
        Vec3::new(1.0 + s, -0.5 * s, 0.3),
        Vec3::new(1.0 + 0.1 * s, 2.0 - 0.1 * s, 2.5),
    )
}

#[inline(always)]
fn wide<S: Simd>(simd: S) -> [[Quat; N]; 2] {
    let lane = |part: &dyn Fn(usize) -> f64| f64x8::from_slice(simd, &core::array::from_fn::<_, N, _>(part));
    let rot = Quat::new(lane(&|i| body(i).0.w), lane(&|i| body(i).0.x), lane(&|i| body(i).0.y), lane(&|i| body(i).0.z));
    let l = Vec3::new(lane(&|i| body(i).1.x), lane(&|i| body(i).1.y), lane(&|i| body(i).1.z));
    let inertia = Vec3::new(lane(&|i| body(i).2.x), lane(&|i| body(i).2.y), lane(&|i| body(i).2.z));
    let h = lane(&|_| 0.05);
    [implicit_midpoint::rotate(rot, l, inertia, h), dmv::rotate(rot, l, inertia, h)].map(|q| {
        let [w, x, y, z] = [q.w, q.x, q.y, q.z].map(|lane| lane.as_slice().to_vec());
        core::array::from_fn(|i| Quat::new(w[i], x[i], y[i], z[i]))
    })
}

#[test]
fn lanes_have_the_bits_of_single_bodies() {
    let level = Level::new();
    let [midpoint, moser_veselov] = dispatch!(level, simd => wide(simd));
    for i in 0..N {
        let (rot, l, inertia) = body(i);
        assert_eq!(midpoint[i], implicit_midpoint::rotate(rot, l, inertia, 0.05), "{i}");
        assert_eq!(moser_veselov[i], dmv::rotate(rot, l, inertia, 0.05), "{i}");
    }
}
