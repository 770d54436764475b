//! The 1-2-3-2-1 splitting: H = Σ y_k²/2I_k, each part a rotation about one body axis.
//!
//! Touma and Wisdom 1994; Reich 1994; Dullweber, Leimkuhler, McLachlan 1997. Order 2, symmetric, symplectic: L is exact
//! and the energy errs by a bounded amount of order h².

use crate::math::{Quat, Vec3};

/// The attitude after h \[s\] of free rotation; `l` in world axes \[kg·m²/s\], principal moments `inertia` > 0 \[kg·m²\].
pub fn rotate(rot: Quat, l: Vec3, inertia: Vec3, h: f64) -> Quat {
    let mut rot = rot;
    let mut y = rot.inverse_rotate(l);
    for (axis, fraction) in [(Vec3::X, 0.5), (Vec3::Y, 0.5), (Vec3::Z, 1.0), (Vec3::Y, 0.5), (Vec3::X, 0.5)] {
        let rate = y.dot(axis) / inertia.dot(axis);
        let part = Quat::from_axis_angle(axis, fraction * h * rate);
        rot = rot * part;
        y = part.inverse_rotate(y);
    }
    rot.renormalized()
}
