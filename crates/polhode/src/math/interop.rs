//! Conversions from and to other crates' vectors. No foreign type is in the engine's own API.

#[cfg(any(feature = "mint", feature = "glam"))]
use super::{Quat, Vec3};

#[cfg(feature = "mint")]
mod mint_types {
    use super::{Quat, Vec3};

    impl From<mint::Vector3<f64>> for Vec3 {
        fn from(v: mint::Vector3<f64>) -> Self {
            Self::new(v.x, v.y, v.z)
        }
    }
    impl From<Vec3> for mint::Vector3<f64> {
        fn from(v: Vec3) -> Self {
            Self { x: v.x, y: v.y, z: v.z }
        }
    }
    impl From<mint::Point3<f64>> for Vec3 {
        fn from(v: mint::Point3<f64>) -> Self {
            Self::new(v.x, v.y, v.z)
        }
    }
    impl From<mint::Quaternion<f64>> for Quat {
        fn from(q: mint::Quaternion<f64>) -> Self {
            Self::new(q.s, q.v.x, q.v.y, q.v.z)
        }
    }
    impl From<Quat> for mint::Quaternion<f64> {
        fn from(q: Quat) -> Self {
            Self { s: q.w, v: mint::Vector3 { x: q.x, y: q.y, z: q.z } }
        }
    }
}

#[cfg(feature = "glam")]
mod glam_types {
    use super::{Quat, Vec3};

    impl From<glam::DVec3> for Vec3 {
        fn from(v: glam::DVec3) -> Self {
            Self::new(v.x, v.y, v.z)
        }
    }
    impl From<Vec3> for glam::DVec3 {
        fn from(v: Vec3) -> Self {
            Self::new(v.x, v.y, v.z)
        }
    }
    impl From<glam::DQuat> for Quat {
        fn from(q: glam::DQuat) -> Self {
            Self::new(q.w, q.x, q.y, q.z)
        }
    }
    impl From<Quat> for glam::DQuat {
        fn from(q: Quat) -> Self {
            Self::from_xyzw(q.x, q.y, q.z, q.w)
        }
    }
}
