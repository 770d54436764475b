//! The symmetric-top splitting: an exactly solved top with two equal moments, and a rotation that mends the difference.
//!
//! With k = 1/I and axes a, b, c such that |k_a − k_b| is the least of the three,
//! H = ½(k_a − k_b) y_a² + \[½ k_b |y|² + ½ (k_c − k_b) y_c²\]: half of the first, all of the second, half of the first.
//! Order 2, symmetric, symplectic, with an error in proportion to k_a − k_b: none for a symmetric body.
//! (F. Fassò, *Comparison of splitting algorithms for the rigid body*, J. Comput. Phys. 189, 2003.)

use crate::math::{Quat, Vec3};

/// The attitude after h \[s\] of free rotation; `l` in world axes \[kg·m²/s\], principal moments `inertia` > 0 \[kg·m²\].
pub fn rotate(rot: Quat, l: Vec3, inertia: Vec3, h: f64) -> Quat {
    let k = Vec3::new(1.0 / inertia.x, 1.0 / inertia.y, 1.0 / inertia.z);
    let (a, b, c) = axes(k);
    let mend = |rot: Quat| {
        let ya = rot.inverse_rotate(l).dot(a);
        rot * Quat::from_axis_angle(a, 0.5 * h * (k.dot(a) - k.dot(b)) * ya)
    };
    let rot = mend(rot);
    let yc = rot.inverse_rotate(l).dot(c);
    // A rotation about y leaves y as it is, so both factors see the same y_c; rot·exp(h k y) = exp(h k L)·rot.
    let rot = Quat::from_rotation_vector(l * (h * k.dot(b))) * rot;
    mend(rot * Quat::from_axis_angle(c, h * (k.dot(c) - k.dot(b)) * yc)).renormalized()
}

/// The body axes a, b, c: a and b with the nearest 1/I, of which b is nearer to c.
fn axes(k: Vec3) -> (Vec3, Vec3, Vec3) {
    let all = [(Vec3::X, k.x), (Vec3::Y, k.y), (Vec3::Z, k.z)];
    let gap = |i: usize, j: usize| (all[i].1 - all[j].1).abs();
    let mut c = 2;
    for candidate in [1, 0] {
        let [i, j] = pair(candidate);
        let [m, n] = pair(c);
        if gap(i, j) < gap(m, n) {
            c = candidate;
        }
    }
    let [i, j] = pair(c);
    let (a, b) = if gap(i, c) >= gap(j, c) { (i, j) } else { (j, i) };
    (all[a].0, all[b].0, all[c].0)
}

/// The two axes other than `c`.
fn pair(c: usize) -> [usize; 2] {
    [(c + 1) % 3, (c + 2) % 3]
}
