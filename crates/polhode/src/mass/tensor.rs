//! The symmetric tensors of mass: second moment C = Σ m r rᵀ and inertia J = tr(C) 1 − C.

use crate::math::{Mat3, Quat, Vec3};

/// J = tr(C) 1 − C, with each diagonal element as a sum of two: the difference would lose the axial moment of a needle.
pub(super) fn inertia_of(c: &Mat3) -> Mat3 {
    let d = c.diag();
    let (xy, xz, yz) = (-c.at(0, 1), -c.at(0, 2), -c.at(1, 2));
    symmetric(Vec3::new(d.y + d.z, d.x + d.z, d.x + d.y), xy, xz, yz)
}

/// The inertia of a unit point mass at `d` from the origin, |d|² 1 − d dᵀ: its (z, z) element is x² + y².
pub(super) fn of_point(d: Vec3) -> Mat3 {
    let (xx, yy, zz) = (d.x * d.x, d.y * d.y, d.z * d.z);
    symmetric(Vec3::new(yy + zz, xx + zz, xx + yy), -d.x * d.y, -d.x * d.z, -d.y * d.z)
}

/// R T Rᵀ, symmetric to the bit; unchanged to the bit where R is the identity.
pub(super) fn rotated(t: &Mat3, rot: Quat) -> Mat3 {
    if rot == Quat::IDENTITY {
        return *t;
    }
    let r = rot.to_mat3();
    let a = r * *t * r.transposed();
    symmetric(a.diag(), a.at(0, 1), a.at(0, 2), a.at(1, 2))
}

/// From the diagonal and the upper triangle.
pub(super) fn symmetric(diagonal: Vec3, xy: f64, xz: f64, yz: f64) -> Mat3 {
    Mat3::from_cols(
        Vec3::new(diagonal.x, xy, xz), //
        Vec3::new(xy, diagonal.y, yz),
        Vec3::new(xz, yz, diagonal.z),
    )
}
