//! The box with edges along the world's axes that holds a shape.
//!
//! A convex body's extent along the unit vector e is its support h(e) = max r·e. With R the shape's axes in the world, row i of
//! R is world axis i in the shape's own frame, so h is asked for six rows ±R_i and no vertex is visited where a formula exists.

use crate::error::Error;
use crate::math::{Lane, Pose, Vec3};
use crate::shape::{Geometry, TriangleMesh};

/// A closed box with edges along the axes \[m\].
///
/// Faces may be infinitely far away. A box with `min` above `max` in one component, or with a NaN, holds no point and overlaps
/// nothing; [`check`] reports it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C)]
pub struct Aabb {
    /// The corner with the least components \[m\].
    pub min: Vec3,
    /// The corner with the greatest components \[m\].
    pub max: Vec3,
}

impl Aabb {
    /// The box that holds no point: merged with another it gives the other.
    pub const EMPTY: Self = Self { min: Vec3::splat(f64::INFINITY), max: Vec3::splat(f64::NEG_INFINITY) };
    /// The box that holds every point.
    pub const EVERYTHING: Self = Self { min: Vec3::splat(f64::NEG_INFINITY), max: Vec3::splat(f64::INFINITY) };

    /// From its two corners.
    pub const fn new(min: Vec3, max: Vec3) -> Self {
        Self { min, max }
    }
    /// From the centre and half the edge lengths.
    pub fn centered(center: Vec3, half: Vec3) -> Self {
        Self { min: center - half, max: center + half }
    }
    /// Whether it holds a point: `min` ≤ `max` in each component. False for NaN.
    #[inline]
    pub fn is_valid(&self) -> bool {
        self.min.x <= self.max.x && self.min.y <= self.max.y && self.min.z <= self.max.z
    }
    /// Whether all six numbers are finite.
    pub fn is_finite(&self) -> bool {
        self.min.is_finite() && self.max.is_finite()
    }
    /// Whether the two have a point in common; touching counts.
    pub fn overlaps(&self, other: &Self) -> bool {
        self.is_valid() && other.is_valid() && self.meets(other)
    }
    /// [`Aabb::overlaps`] of two boxes that are known to be valid.
    #[inline(always)]
    #[expect(
        clippy::needless_bitwise_bool,
        reason = "six comparisons are cheaper than a branch that cannot be foretold"
    )]
    pub(crate) fn meets(&self, other: &Self) -> bool {
        (self.min.x <= other.max.x)
            & (other.min.x <= self.max.x)
            & (self.min.y <= other.max.y)
            & (other.min.y <= self.max.y)
            & (self.min.z <= other.max.z)
            & (other.min.z <= self.max.z)
    }
    /// Whether every point of `other` is a point of this one.
    pub fn contains(&self, other: &Self) -> bool {
        other.is_valid() && self.contains_point(other.min) && self.contains_point(other.max)
    }
    /// Whether `p` lies inside or on the surface.
    pub fn contains_point(&self, p: Vec3) -> bool {
        (0..3).all(|i| self.min[i] <= p[i] && p[i] <= self.max[i])
    }
    /// The least box that holds both.
    pub fn merged(&self, other: &Self) -> Self {
        Self {
            min: Vec3::new(self.min.x.least(other.min.x), self.min.y.least(other.min.y), self.min.z.least(other.min.z)),
            max: Vec3::new(
                self.max.x.greatest(other.max.x),
                self.max.y.greatest(other.max.y),
                self.max.z.greatest(other.max.z),
            ),
        }
    }
    /// Every face moved outwards by `margin` \[m\].
    pub fn expanded(&self, margin: f64) -> Self {
        Self { min: self.min - Vec3::splat(margin), max: self.max + Vec3::splat(margin) }
    }
    /// What the box passes over while it moves by `displacement` \[m\].
    pub fn swept(&self, displacement: Vec3) -> Self {
        self.merged(&Self { min: self.min + displacement, max: self.max + displacement })
    }
    /// The centre \[m\]; finite also where the faces are not, for it is taken of the box cut off at ±1e150 m.
    pub fn center(&self) -> Vec3 {
        let cut = |x: f64| x.clamp(-1e150, 1e150);
        let mid = |i: usize| 0.5 * (cut(self.min[i]) + cut(self.max[i]));
        Vec3::new(mid(0), mid(1), mid(2))
    }
    /// The edge lengths \[m\].
    pub fn size(&self) -> Vec3 {
        self.max - self.min
    }
    /// The area of its surface \[m²\]; 0 if it holds no point.
    pub fn surface_area(&self) -> f64 {
        if !self.is_valid() {
            return 0.0;
        }
        let e = self.size();
        // An infinite plate of thickness 0 has ∞·0 here, and is infinite.
        let area = 2.0 * (e.x * e.y + e.y * e.z + e.z * e.x);
        if area.is_nan() { f64::INFINITY } else { area }
    }
    /// Where a ray is inside: the first and the last t in \[0, length\] with origin + t direction in the box, or `None`.
    ///
    /// The interval of each pair of faces ("slab") is cut with those before (Kay and Kajiya 1986). A larger box never gives a
    /// smaller interval, rounding included, because subtraction and division are monotone.
    pub fn ray(&self, ray: &Ray) -> Option<(f64, f64)> {
        if !self.is_valid() || !ray.is_valid() {
            return None;
        }
        let (mut first, mut last) = (0.0, ray.length);
        for i in 0..3 {
            let (o, d) = (ray.origin[i], ray.direction[i]);
            if d == 0.0 {
                if o < self.min[i] || o > self.max[i] {
                    return None;
                }
                continue;
            }
            let (near, far) = if d > 0.0 { (self.min[i], self.max[i]) } else { (self.max[i], self.min[i]) };
            first = first.greatest((near - o) / d);
            last = last.least((far - o) / d);
        }
        (first <= last).then_some((first, last))
    }
}

/// Names the first box that holds no point, so that nobody waits for its pairs.
///
/// # Errors
/// Names the box, `[3]`, and says whether it is NaN or inside out.
pub fn check(boxes: &[Aabb]) -> Result<(), Error> {
    let Some(i) = boxes.iter().position(|b| !b.is_valid()) else { return Ok(()) };
    let b = &boxes[i];
    let nan = b.min.to_array().iter().chain(&b.max.to_array()).any(|x| x.is_nan());
    Err(Error::new(format!("[{i}]"), if nan { "is not a number" } else { "has its minimum above its maximum" }))
}

/// A half-line, or a segment of it: all origin + t direction with 0 ≤ t ≤ length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where it starts \[m\].
    pub origin: Vec3,
    /// Where it goes; of any length but zero.
    pub direction: Vec3,
    /// The greatest t, in lengths of `direction`; may be infinite.
    pub length: f64,
}

impl Ray {
    /// Whether it is one: origin and direction are finite, the direction is not zero and the length not negative.
    pub fn is_valid(&self) -> bool {
        self.origin.is_finite() && self.direction.direction().is_some() && self.length >= 0.0
    }
}

/// The least box around `geometry` at `pose`, widened by the rounding of a point's way through `pose`: it holds every point
/// that [`Pose::point`] makes of the shape's points.
///
/// The dimensions are taken to be valid and the rotation of unit length; a pose that is not finite gives a box of NaN. A half-space is bounded only on the side its normal
/// shows, and only where that is along an axis.
pub fn bounds(geometry: &Geometry, pose: &Pose) -> Aabb {
    if !pose.x.is_finite() || !pose.rot.is_finite() {
        return Aabb::new(Vec3::splat(f64::NAN), Vec3::splat(f64::NAN));
    }
    let m = pose.rot.to_mat3();
    let rows = [0, 1, 2].map(|i| Vec3::new(m.at(i, 0), m.at(i, 1), m.at(i, 2)));
    let (low, high, reach) = match geometry {
        Geometry::HalfSpace(s) => return half_space(pose.rot.rotate(s.normal), pose.x),
        Geometry::Mesh(mesh) => return mesh_bounds(mesh, pose),
        Geometry::Hull(hull) => return around(hull.vertices().iter().map(|&v| pose.point(v)), pose.x),
        Geometry::Polygon(s) => {
            let at = |p: &[f64; 2]| pose.point(Vec3::new(p[0], p[1], 0.0));
            return around(s.points.iter().map(at), pose.x);
        }
        Geometry::Cone(s) => {
            // The hull of the apex and the disc of the base: the further of the two along each axis.
            let (apex, base) = (0.75 * s.length, -0.25 * s.length);
            let high = rows.map(|r| (r.z * apex).greatest(r.z * base + s.radius * across(r)));
            let low = rows.map(|r| (r.z * apex).least(r.z * base - s.radius * across(r)));
            (low, high, s.radius + s.length)
        }
        _ => {
            let (half, reach) = half_extents(geometry, rows);
            (half.map(|h| -h), half, reach)
        }
    };
    let tight = Aabb::new(pose.x + Vec3::from(low), pose.x + Vec3::from(high));
    tight.expanded(rounding(pose.x, reach))
}

/// How far rounding may carry a point at most `reach` from the origin of its frame away from where the formula has it.
///
/// [`Pose::point`] and the formulas each take at most 16 operations on numbers of this size.
fn rounding(x: Vec3, reach: f64) -> f64 {
    16.0 * f64::EPSILON * (x.max_abs() + reach)
}

/// |the part of the unit vector `row` across z|: the extent of the unit disc.
fn across(row: Vec3) -> f64 {
    (row.x * row.x + row.y * row.y).sqrt()
}

/// The extents of a shape that is its own mirror image, along the three rows, and the distance no point of it exceeds.
fn half_extents(geometry: &Geometry, rows: [Vec3; 3]) -> ([f64; 3], f64) {
    let of_box = |size: Vec3| {
        let half = 0.5 * size;
        (rows.map(|r| r.x.abs() * half.x + r.y.abs() * half.y + r.z.abs() * half.z), half.length())
    };
    let of_disc = |radius: f64| (rows.map(|r| radius * across(r)), radius);
    match geometry {
        Geometry::Sphere(s) => ([s.radius; 3], s.radius),
        Geometry::Cuboid(s) => of_box(s.size),
        Geometry::Capsule(s) => (rows.map(|r| 0.5 * s.length * r.z.abs() + s.radius), s.radius + s.length),
        Geometry::Cylinder(s) => (rows.map(|r| 0.5 * s.length * r.z.abs() + s.radius * across(r)), s.radius + s.length),
        Geometry::Ellipsoid(s) => (rows.map(|r| r.scale(s.semi_axes).length()), s.semi_axes.length()),
        Geometry::Torus(s) => (rows.map(|r| s.major * across(r) + s.minor), s.major + s.minor),
        Geometry::Disc(s) => of_disc(s.radius),
        Geometry::Ring(s) => of_disc(s.outer),
        Geometry::Rectangle(s) => of_box(Vec3::new(s.size[0], s.size[1], 0.0)),
        // These have no mirror symmetry and are dealt with before.
        Geometry::Cone(_) | Geometry::HalfSpace(_) | Geometry::Hull(_) | Geometry::Mesh(_) | Geometry::Polygon(_) => {
            ([f64::INFINITY; 3], f64::INFINITY)
        }
    }
}

/// All r with normal·(r − x) ≤ 0.
fn half_space(normal: Vec3, x: Vec3) -> Aabb {
    let mut all = Aabb::EVERYTHING;
    for i in 0..3 {
        let others = normal[(i + 1) % 3] == 0.0 && normal[(i + 2) % 3] == 0.0;
        if others && normal[i] > 0.0 {
            all.max[i] = x[i];
        } else if others && normal[i] < 0.0 {
            all.min[i] = x[i];
        }
    }
    all
}

fn mesh_bounds(mesh: &TriangleMesh, pose: &Pose) -> Aabb {
    // Corners of triangles and not positions: a position that no triangle uses is no part of the surface.
    let corners = mesh.triangles().iter().flatten().map(|&i| pose.point(mesh.positions()[i as usize]));
    around(corners, pose.x)
}

/// The box around points that have gone through a pose at `x`.
fn around(points: impl Iterator<Item = Vec3>, x: Vec3) -> Aabb {
    let tight = points.fold(Aabb::EMPTY, |b, p| b.merged(&Aabb::new(p, p)));
    let reach = (tight.max - x).max_abs().greatest((tight.min - x).max_abs());
    tight.expanded(rounding(x, 2.0 * reach))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Quat;
    use crate::shape::Shape;
    use core::f64::consts::{PI, TAU};
    use std::sync::Arc;

    /// Points of the surface in the shape's frame, dense enough that some point is within `N`⁻² of every extreme one.
    const N: usize = 160;

    fn turn(i: usize) -> [f64; 2] {
        let angle = TAU * i as f64 / N as f64;
        [libm::cos(angle), libm::sin(angle)]
    }

    fn circle(radius: f64, z: f64) -> Vec<Vec3> {
        (0..N).map(turn).map(|[c, s]| Vec3::new(radius * c, radius * s, z)).collect()
    }

    fn ball(semi_axes: Vec3) -> Vec<Vec3> {
        let ring = |i: usize| {
            let polar = PI * i as f64 / N as f64;
            circle(libm::sin(polar), libm::cos(polar))
        };
        (0..=N).flat_map(ring).map(|p| p.scale(semi_axes)).collect()
    }

    fn corners(x: f64, y: f64, z: f64) -> Vec<Vec3> {
        let side = |i: usize, bit: usize| if i & bit == 0 { -0.5 } else { 0.5 };
        (0..8).map(|i| Vec3::new(x * side(i, 1), y * side(i, 2), z * side(i, 4))).collect()
    }

    fn samples() -> Vec<(Geometry, Vec<Vec3>)> {
        let at = |points: Vec<Vec3>, z: f64| points.into_iter().map(move |p| p + z * Vec3::Z);
        let torus = (0..N).map(turn).flat_map(|[c, s]| circle(0.9 + 0.3 * c, 0.3 * s)).collect();
        let outline = vec![[0.0, 0.0], [2.0, 0.3], [1.0, 1.0], [0.2, 2.0]];
        let polygon = outline.iter().map(|&[x, y]| Vec3::new(x, y, 0.0)).collect();
        let positions = vec![Vec3::ZERO, Vec3::X, 2.0 * Vec3::Y, 3.0 * Vec3::Z, Vec3::splat(-50.0)];
        let mesh = TriangleMesh::new(positions.clone(), vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]).unwrap();
        let semi_axes = Vec3::new(0.2, 0.5, 0.9);
        vec![
            (Shape::sphere(0.7).geometry, ball(Vec3::splat(0.7))),
            (Shape::cuboid([0.3, 0.5, 0.9]).geometry, corners(0.3, 0.5, 0.9)),
            (
                Shape::capsule(0.4, 1.2).geometry,
                at(ball(Vec3::splat(0.4)), 0.6).chain(at(ball(Vec3::splat(0.4)), -0.6)).collect(),
            ),
            (Shape::cylinder(0.4, 1.2).geometry, [circle(0.4, 0.6), circle(0.4, -0.6)].concat()),
            (Shape::cone(0.4, 1.2).geometry, [circle(0.4, -0.3), vec![Vec3::new(0.0, 0.0, 0.9)]].concat()),
            (Geometry::Ellipsoid(crate::shape::Ellipsoid { semi_axes }), ball(semi_axes)),
            (Shape::torus(0.9, 0.3).geometry, torus),
            (Geometry::Mesh(Arc::new(mesh)), positions[..4].to_vec()),
            (Shape::disc(0.6).geometry, circle(0.6, 0.0)),
            (Shape::rectangle([0.3, 0.8]).geometry, corners(0.3, 0.8, 0.0)),
            (Shape::polygon(outline).geometry, polygon),
            (Shape::ring(0.2, 0.6).geometry, circle(0.6, 0.0)),
        ]
    }

    #[test]
    fn bounds_hold_every_point_and_nothing_more() {
        for (geometry, points) in samples() {
            for i in 0..40 {
                let t = f64::from(i);
                let rot = Quat::from_rotation_vector(Vec3::new(libm::sin(t), 0.3 * t, libm::cos(2.0 * t)));
                let far = if i % 4 == 3 { 1e7 } else { 1.0 };
                let rot = if i % 5 == 0 { Quat::IDENTITY } else { rot };
                let pose = Pose::new(far * Vec3::new(libm::cos(t), -0.5, 0.1 * t), rot);
                let b = bounds(&geometry, &pose);
                let sampled =
                    points.iter().map(|&p| pose.point(p)).fold(Aabb::EMPTY, |b, p| b.merged(&Aabb::new(p, p)));
                assert!(b.contains(&sampled), "{} {i}: {b:?} misses part of {sampled:?}", geometry.name());
                // A curve of radius r sampled every angle a stays r a²/8 inside; tori and balls are curved twice, and no radius
                // here exceeds 1.2. On top, the widening for rounding, twice.
                let a = TAU / N as f64;
                let sagitta = if points.len() < 9 { 0.0 } else { 2.0 * 1.2 * a * a / 8.0 };
                let slack = sagitta + 4.0 * rounding(pose.x, 4.0);
                let excess = (sampled.min - b.min).max_abs().greatest((b.max - sampled.max).max_abs());
                assert!(excess <= slack, "{} {i}: {excess} too large", geometry.name());
            }
        }
    }

    #[test]
    fn a_half_space_is_bounded_where_its_normal_is_an_axis() {
        let ground = Shape::half_space([0.0, 0.0, 2.0]).geometry;
        let b = bounds(&ground, &Pose::new(Vec3::new(1.0, 2.0, 3.0), Quat::IDENTITY));
        assert_eq!((b.max.z, b.min, b.max.x), (3.0, Vec3::splat(f64::NEG_INFINITY), f64::INFINITY));
        let tilted = Pose::new(Vec3::ZERO, Quat::from_rotation_vector(Vec3::new(0.1, 0.0, 0.0)));
        assert_eq!(bounds(&ground, &tilted), Aabb::EVERYTHING);
    }

    #[test]
    fn what_is_not_a_box_overlaps_nothing_and_is_reported() {
        let unit = Aabb::new(Vec3::ZERO, Vec3::splat(1.0));
        let nan = Aabb::new(Vec3::ZERO, Vec3::new(1.0, f64::NAN, 1.0));
        for odd in [nan, Aabb::EMPTY, Aabb::new(Vec3::splat(1.0), Vec3::ZERO)] {
            assert!(!odd.overlaps(&Aabb::EVERYTHING) && !Aabb::EVERYTHING.overlaps(&odd) && !odd.overlaps(&odd));
            assert!(!unit.contains(&odd) && odd.surface_area() == 0.0);
            assert_eq!(check(&[unit, odd]).unwrap_err().path(), "[1]");
        }
        assert!(check(&[unit, Aabb::EVERYTHING]).is_ok());
        assert!(check(&[nan]).unwrap_err().to_string().contains("not a number"));
        let pose = Pose::new(Vec3::new(f64::NAN, 0.0, 0.0), Quat::IDENTITY);
        for (geometry, _) in samples() {
            assert!(!bounds(&geometry, &pose).is_valid(), "{}", geometry.name());
        }
    }

    #[test]
    fn boxes_that_touch_overlap() {
        let unit = Aabb::new(Vec3::ZERO, Vec3::splat(1.0));
        let beside = Aabb::new(Vec3::X, Vec3::new(2.0, 1.0, 1.0));
        let apart = Aabb::new(Vec3::new(1.0f64.next_up(), 0.0, 0.0), Vec3::splat(2.0));
        assert!(unit.overlaps(&beside) && !unit.overlaps(&apart));
        assert_eq!(unit.merged(&beside), Aabb::new(Vec3::ZERO, Vec3::new(2.0, 1.0, 1.0)));
        assert_eq!(unit.swept(Vec3::X), unit.merged(&beside));
        assert_eq!((unit.surface_area(), unit.center()), (6.0, Vec3::splat(0.5)));
        assert_eq!(Aabb::EVERYTHING.center(), Vec3::ZERO);
    }

    #[test]
    fn a_ray_is_inside_from_face_to_face() {
        let unit = Aabb::new(Vec3::ZERO, Vec3::splat(1.0));
        let ray = |origin: [f64; 3], direction: Vec3, length| Ray { origin: origin.into(), direction, length };
        let hit = |r: Ray| unit.ray(&r);
        assert_eq!(hit(ray([-1.0, 0.5, 0.5], 2.0 * Vec3::X, 9.0)), Some((0.5, 1.0)));
        assert_eq!(hit(ray([-1.0, 0.5, 0.5], 2.0 * Vec3::X, 0.4)), None);
        assert_eq!(hit(ray([0.5, 0.5, 0.5], -Vec3::Z, f64::INFINITY)), Some((0.0, 0.5)));
        // Along a face, which belongs to the box.
        assert_eq!(hit(ray([-1.0, 1.0, 0.0], Vec3::X, 9.0)), Some((1.0, 2.0)));
        assert_eq!(hit(ray([-1.0, 1.1, 0.0], Vec3::X, 9.0)), None);
        assert_eq!(hit(ray([0.5, 0.5, 0.5], Vec3::ZERO, 9.0)), None);
        assert_eq!(hit(ray([f64::NAN, 0.5, 0.5], Vec3::X, 9.0)), None);
        assert_eq!(Aabb::EVERYTHING.ray(&ray([0.0; 3], Vec3::X, 9.0)), Some((0.0, 9.0)));
    }
}
