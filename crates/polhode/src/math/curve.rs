//! Frames that move along a path.
//!
//! The *Frenet frame* (T, N, B) belongs to the path of a point, not to a body: T is the direction of the velocity, N points
//! to the centre of curvature, B = T × N. It does not exist where the point rests, and N and B do not exist where the path
//! is straight; here they are `None` there, never NaN. The *parallel frame* (Bishop 1975) has the same T, and two normals
//! that turn about T as little as possible: it exists along straight stretches and through inflections.
//!
//! ```text
//! T' = k N ṡ,    N' = (−k T + τ B) ṡ,    B' = −τ N ṡ
//! ```

use super::Vec3;

/// The Frenet frame of a path at one instant.
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Frenet {
    /// Speed ṡ = |v| \[m/s\].
    pub speed: f64,
    /// T = v/|v|; `None` at rest.
    pub tangent: Option<Vec3>,
    /// N, towards the centre of curvature; `None` at rest and where the path is straight.
    pub normal: Option<Vec3>,
    /// B = T × N; `None` where N is.
    pub binormal: Option<Vec3>,
    /// k = |v × a|/|v|³ ≥ 0 \[1/m\]; `None` at rest.
    pub curvature: Option<f64>,
    /// τ = (v × a)·j/|v × a|² \[1/m\], positive for a right-handed screw; `None` where N is.
    pub torsion: Option<f64>,
}

/// v × a below this share of |v| |a| is what rounding leaves of two parallel vectors.
const STRAIGHT: f64 = 1e-12;

impl Frenet {
    /// From velocity \[m/s\], acceleration \[m/s²\] and jerk \[m/s³\].
    ///
    /// `rest` is the speed \[m/s\] up to which the point counts as resting; 0 is allowed. Infinite or NaN input gives an
    /// empty frame.
    pub fn new(v: Vec3, a: Vec3, jerk: Vec3, rest: f64) -> Self {
        let speed = v.robust_length();
        let frame = Self { speed, ..Self::default() };
        let Some(tangent) = v.direction().filter(|_| speed > rest && a.is_finite()) else { return frame };
        let bend = tangent.cross(a);
        let curvature = Some(bend.length() / (speed * speed));
        let frame = Self { tangent: Some(tangent), curvature, ..frame };
        let Some(binormal) = bend.direction().filter(|_| bend.length() > STRAIGHT * a.length()) else { return frame };
        let torsion = binormal.dot(jerk) / (bend.length() * speed);
        Self {
            normal: Some(binormal.cross(tangent)),
            binormal: Some(binormal),
            torsion: Some(torsion).filter(|t| t.is_finite()),
            ..frame
        }
    }
}

/// A unit normal carried along a path with the least turn about the tangent.
///
/// Each step is a double reflection (Wang, Jüttler, Zheng, Liu, *Computation of rotation minimizing frames*, ACM Trans.
/// Graph. 27, 2008): order 4 in the length of the step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ParallelFrame {
    x: Vec3,
    tangent: Vec3,
    normal: Vec3,
}

impl ParallelFrame {
    /// Starts at a point of the path with unit `tangent`; the normal is any one that is perpendicular.
    pub fn new(x: Vec3, tangent: Vec3) -> Self {
        Self { x, tangent, normal: tangent.any_perpendicular() }
    }
    /// The tangent T.
    pub fn tangent(&self) -> Vec3 {
        self.tangent
    }
    /// The carried normal U.
    pub fn normal(&self) -> Vec3 {
        self.normal
    }
    /// The other normal V = T × U.
    pub fn binormal(&self) -> Vec3 {
        self.tangent.cross(self.normal)
    }
    /// Carries the frame on to the point `x` with unit `tangent`. A point that has not moved only turns with the tangent.
    pub fn advance(&mut self, x: Vec3, tangent: Vec3) {
        let chord = x - self.x;
        let (mut normal, mut old) = (self.normal, self.tangent);
        if let Some(c) = chord.direction() {
            normal -= c * (2.0 * c.dot(normal));
            old -= c * (2.0 * c.dot(old));
        }
        if let Some(c) = (tangent - old).direction() {
            normal -= c * (2.0 * c.dot(normal));
        }
        // What is left along T is rounding.
        normal -= tangent * tangent.dot(normal);
        let normal = normal.direction().unwrap_or_else(|| tangent.any_perpendicular());
        *self = Self { x, tangent, normal };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Position and three derivatives of the helix (a cos t, a sin t, b t).
    fn helix(a: f64, b: f64, t: f64) -> [Vec3; 4] {
        let (s, c) = libm::sincos(t);
        [
            Vec3::new(a * c, a * s, b * t),
            Vec3::new(-a * s, a * c, b),
            Vec3::new(-a * c, -a * s, 0.0),
            Vec3::new(a * s, -a * c, 0.0),
        ]
    }

    #[test]
    fn a_helix_has_its_curvature_and_torsion() {
        for (a, b) in [(2.0, 0.5), (1.0, -3.0), (0.1, 10.0), (4.0, 0.0)] {
            for i in 0..50 {
                let [_, v, acc, j] = helix(a, b, 0.3 * f64::from(i));
                let f = Frenet::new(v, acc, j, 0.0);
                let r2 = a * a + b * b;
                assert!((f.curvature.unwrap() - a / r2).abs() < 1e-14);
                assert!((f.torsion.unwrap() - b / r2).abs() < 1e-14);
                let (t, n, b) = (f.tangent.unwrap(), f.normal.unwrap(), f.binormal.unwrap());
                assert!((t.cross(n) - b).length() < 1e-15);
                assert!((n - acc / a).length() < 1e-14, "N points to the axis");
            }
        }
    }

    #[test]
    fn where_there_is_no_frame_there_is_no_number() {
        let rest = Frenet::new(Vec3::ZERO, Vec3::X, Vec3::Y, 0.0);
        assert_eq!((rest.tangent, rest.normal, rest.curvature), (None, None, None));
        let straight = Frenet::new(Vec3::new(1.0, 2.0, 3.0), Vec3::new(0.1, 0.2, 0.3), Vec3::ZERO, 0.0);
        assert!(straight.tangent.is_some() && straight.normal.is_none() && straight.torsion.is_none());
        let cruise = Frenet::new(Vec3::X, Vec3::ZERO, Vec3::ZERO, 0.0);
        assert_eq!((cruise.curvature, cruise.normal), (Some(0.0), None));
        for bad in [f64::NAN, f64::INFINITY] {
            assert_eq!(Frenet::new(Vec3::splat(bad), Vec3::X, Vec3::X, 0.0).tangent, None);
            assert_eq!(Frenet::new(Vec3::X, Vec3::splat(bad), Vec3::X, 0.0).tangent, None);
            assert_eq!(Frenet::new(Vec3::X, Vec3::Y, Vec3::splat(bad), 0.0).torsion, None);
        }
        assert_eq!(Frenet::new(Vec3::new(1e-7, 0.0, 0.0), Vec3::Y, Vec3::Z, 1e-6).tangent, None);
    }

    /// Along one turn of a helix the Frenet normal turns against the parallel one by ∮ τ ds.
    #[test]
    fn parallel_transport_undoes_the_torsion_to_fourth_order() {
        let (a, b) = (1.0, 0.5);
        let length = core::f64::consts::TAU * libm::sqrt(a * a + b * b);
        let exact = b / (a * a + b * b) * length;
        let error = |n: u32| {
            let at = |i: u32| helix(a, b, core::f64::consts::TAU * f64::from(i) / f64::from(n));
            let [x, v, ..] = at(0);
            let mut frame = ParallelFrame::new(x, v.direction().unwrap());
            frame.normal = Vec3::new(-1.0, 0.0, 0.0);
            for i in 1..=n {
                let [x, v, ..] = at(i);
                frame.advance(x, v.direction().unwrap());
            }
            // At the end the Frenet normal is (−1, 0, 0) again.
            let n = Vec3::new(-1.0, 0.0, 0.0);
            let angle = libm::atan2(n.dot(frame.binormal()), n.dot(frame.normal()));
            let turns = (exact - angle) / core::f64::consts::TAU;
            (turns - libm::round(turns)).abs()
        };
        let slope = libm::log2(error(32) / error(64));
        assert!((slope - 4.0).abs() < 0.1, "slope {slope}, errors {} {}", error(32), error(64));
    }
}
