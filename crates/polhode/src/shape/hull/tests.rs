use super::*;
use crate::mass::solid;
use crate::math::Quat;
use proptest::prelude::*;

/// Everything that makes a hull valid, checked without the code that made it.
fn check_valid(hull: &ConvexHull, points: &[Vec3]) -> Result<(), String> {
    let n_vertices = hull.vertices().len();
    let euler = (n_vertices + hull.n_faces()).wrapping_sub(hull.n_edges());
    let demand = |ok: bool, what: &str| if ok { Ok(()) } else { Err(format!("{what}, of {n_vertices} vertices")) };
    demand(euler == 2, &format!("V − E + F = {euler}"))?;
    check_topology(hull).map_err(|e| format!("{e}, of {n_vertices} vertices"))?;
    let mut sorted: Vec<[u64; 3]> = hull.vertices().iter().map(|v| v.to_array().map(|x| (x + 0.0).to_bits())).collect();
    sorted.sort_unstable();
    sorted.dedup();
    demand(sorted.len() == n_vertices, "two vertices are one")?;
    demand(n_vertices > 500 || hull.vertices().iter().all(|v| points.contains(v)), "a vertex is no point")?;
    // The planes are asked with two more roundings of a sum of three products of the extent.
    let bound = hull.rounding() * 1.25;
    for f in 0..hull.n_faces() {
        let (normal, offset) = (hull.normals()[f], hull.offsets()[f]);
        demand((normal.length() - 1.0).abs() < 4.0 * f64::EPSILON, "a normal is no unit vector")?;
        let height = |p: Vec3| normal.dot(p) - offset;
        let corners: Vec<Vec3> = hull.face(f).iter().map(|&v| hull.vertices()[v as usize]).collect();
        let n = corners.len();
        for i in 0..n {
            let [a, b, c] = [corners[i], corners[(i + 1) % n], corners[(i + 2) % n]];
            let off = height(a).abs() / bound;
            demand(off <= 1.0, &format!("face {f} of {n} corners: a corner is {off} bounds off its plane"))?;
            // Divided by its length first, so that no product overflows.
            let side = (c - a) / (c - a).robust_length();
            demand(normal.dot(side.cross(b - a)) <= bound, "a face is not convex")?;
        }
        if n_vertices * points.len() < 2_000_000 {
            let out = points.iter().map(|&p| height(p)).fold(f64::NEG_INFINITY, f64::max) / bound;
            demand(out <= 1.0, &format!("face {f} of {n} corners: a point is {out} bounds outside"))?;
        }
    }
    Ok(())
}

fn check_topology(hull: &ConvexHull) -> Result<(), String> {
    let n = hull.twins().len();
    let end = |h: usize| {
        let range = hull.half_edges(hull.faces_of()[h] as usize);
        hull.origins()[if h + 1 == range.end { range.start } else { h + 1 }]
    };
    let mut degree = vec![0; hull.vertices().len()];
    for h in 0..n {
        let twin = hull.twins()[h] as usize;
        if twin >= n || hull.twins()[twin] as usize != h || hull.faces_of()[twin] == hull.faces_of()[h] {
            return Err(format!("half-edge {h} has no twin in another face"));
        }
        if hull.origins()[twin] != end(h) || end(twin) != hull.origins()[h] {
            return Err(format!("half-edge {h} and its twin run the same way"));
        }
        let v = hull.origins()[h] as usize;
        degree[v] += 1;
        if !hull.neighbours(v).contains(&end(h)) {
            return Err(format!("vertex {v} does not know a neighbour"));
        }
    }
    let known = (0..degree.len()).all(|v| hull.neighbours(v).len() == degree[v] && degree[v] >= 3);
    let edges = hull.edges().count() * 2 == n && (0..hull.n_faces()).all(|f| hull.face(f).len() >= 3);
    if known && edges { Ok(()) } else { Err("a vertex or a face with fewer than three edges".to_string()) }
}

/// Numbers in 0..1 that are the same everywhere (splitmix64).
struct Random(u64);

impl Random {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }
    fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }
    fn in_cube(&mut self) -> Vec3 {
        Vec3::new(self.unit(), self.unit(), self.unit()) * 2.0 - Vec3::splat(1.0)
    }
    fn in_ball(&mut self) -> Vec3 {
        loop {
            let p = self.in_cube();
            if p.length_squared() <= 1.0 && p.length_squared() > 1e-3 {
                return p;
            }
        }
    }
    fn on_sphere(&mut self) -> Vec3 {
        let p = self.in_ball();
        p / p.length()
    }
    fn turn(&mut self) -> Quat {
        Quat::new(self.unit() - 0.5, self.unit(), self.unit() - 0.5, self.unit() - 0.5).normalized()
    }
    fn below(&mut self, n: u64) -> u64 {
        self.bits() % n
    }
}

const KINDS: usize = 17;

/// Point clouds that are hard, one kind after the other.
fn cloud(kind: usize, n: usize, seed: u64) -> Vec<Vec3> {
    let mut r = Random(seed);
    let turn = r.turn();
    let side = |r: &mut Random| if r.below(2) == 0 { -1.0 } else { 1.0 };
    let on_cube = |r: &mut Random| {
        let mut p = r.in_cube();
        for _ in 0..=r.below(3) {
            p[r.below(3) as usize] = side(r);
        }
        p
    };
    let any_size = |r: &mut Random| libm::exp2(-(r.below(60) as f64));
    let noise = libm::exp2(-44.0 - r.below(8) as f64);
    let grid = |r: &mut Random, n: u64| Vec3::new(r.below(n) as f64, r.below(n) as f64, r.below(n) as f64);
    let make = |r: &mut Random| match kind {
        0 => r.in_ball(),
        1 => r.on_sphere(),
        // Clusters in a few planes.
        2 => turn.rotate(Vec3::new(r.in_cube().x, r.in_cube().y, r.below(3) as f64)),
        3 => grid(r, 4),
        // Slabs, 1e-12 thick and less.
        4 => turn.rotate(r.in_cube().scale(Vec3::new(1.0, 1.0, 1e-12))),
        5 => Vec3::new(r.in_cube().x, r.in_cube().y, 1e-13 * side(r)),
        // Needles.
        6 => turn.rotate(r.in_ball().scale(Vec3::new(1e-6, 1.0, 1e-6))),
        7 => grid(r, 3) * 0.1,
        8 => on_cube(r),
        9 => turn.rotate(on_cube(r)),
        10 => turn.rotate(on_cube(r)) + Vec3::new(1e7, -1e7, 3e6),
        11 => r.on_sphere() * 1e-3 + Vec3::new(1e7, 1e7, 0.0),
        // A cylinder: two planes of cospherical points.
        12 => {
            let angle = r.below(64) as f64 * core::f64::consts::PI / 32.0;
            let z = r.below(3) as f64 - 1.0;
            turn.rotate(Vec3::new(libm::cos(angle), libm::sin(angle), z))
        }
        // Flat to about the tolerance.
        13 => turn.rotate(on_cube(r) + r.in_cube() * noise),
        // Every size at once.
        14 => r.in_cube().scale(Vec3::new(any_size(r), any_size(r), any_size(r))),
        // A ball with a flat that is not quite flat.
        15 => {
            let p = r.on_sphere();
            turn.rotate(Vec3::new(p.x, p.y, p.z.min(0.9 + noise * r.unit())))
        }
        // A tight cluster far from the rest.
        _ => {
            if r.below(3) == 0 {
                r.in_ball()
            } else {
                Vec3::X * 2.0 + r.in_ball() * 1e-13
            }
        }
    };
    (0..n).map(|_| make(&mut r)).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]
    #[test]
    fn a_hull_is_valid_or_refused(kind in 0..KINDS, n in 4..200_usize, seed in any::<u64>()) {
        let points = cloud(kind, n, seed);
        match ConvexHull::new(&points) {
            Ok(hull) => {
                let valid = check_valid(&hull, &points);
                prop_assert!(valid.is_ok(), "kind {kind}: {}", valid.unwrap_err());
                prop_assert!(ConvexHull::new(hull.vertices()).unwrap() == hull, "kind {kind}: its vertices have another hull");
                prop_assert!(hull.moments(Fill::Solid, 1.0).unwrap().mass > 0.0);
            }
            Err(e) => prop_assert!(e.path() == "points" && (n < 20 || kind >= 13), "kind {kind}, {n}: {e}"),
        }
    }

    #[test]
    fn no_points_panic(points in prop::collection::vec(prop::array::uniform3(any::<f64>()), 0..40)) {
        let points: Vec<Vec3> = points.into_iter().map(Vec3::from).collect();
        if let Ok(hull) = ConvexHull::new(&points) {
            prop_assert_eq!(check_valid(&hull, &points), Ok(()));
        }
    }

    #[test]
    fn strange_numbers_do_not_panic(picks in prop::collection::vec(prop::array::uniform3(0..12_usize), 0..40), odd in 0..14_usize) {
        let numbers = [0.0, -0.0, 1.0, -1.0, 1e30, -1e30, 5e-324, 1e-300, 1.0 + f64::EPSILON, 1e-16, 0.5, 3.0];
        let rare = [1e300, f64::MAX, f64::NAN, f64::INFINITY];
        let mut points: Vec<Vec3> = picks.iter().map(|p| Vec3::from(p.map(|i| numbers[i]))).collect();
        if let (Some(p), Some(&number)) = (points.first_mut(), rare.get(odd)) {
            p.y = number;
        }
        if let Ok(hull) = ConvexHull::new(&points) {
            prop_assert_eq!(check_valid(&hull, &points), Ok(()));
        }
    }

    #[test]
    fn support_is_the_farthest_vertex(kind in 0..KINDS - 1, seed in any::<u64>(), direction in prop::array::uniform3(-1.0..1.0)) {
        // All but the last kind: in a cluster no larger than the rounding, faces are crooked at the size of their edges.
        let Ok(hull) = ConvexHull::new(&cloud(kind, 300, seed)) else { return Ok(()) };
        let direction = Vec3::from(direction);
        let best = hull.vertices().iter().map(|&v| direction.dot(v)).fold(f64::NEG_INFINITY, f64::max);
        let (v, p) = hull.support(direction);
        prop_assert_eq!(p, hull.vertices()[v]);
        // A walk may end where the next vertex is higher by no more than the faces are crooked.
        let short = (best - direction.dot(p)) / hull.rounding();
        prop_assert!(short <= 2.0, "kind {kind}: {short} of {}", hull.vertices().len());
        let (_, q) = hull.support_from(hull.vertices().len() - 1, direction);
        let short = (best - direction.dot(q)) / hull.rounding();
        prop_assert!(short <= 2.0, "kind {kind}: {short} of {}", hull.vertices().len());
    }
}

#[test]
fn a_cube_has_six_faces_whatever_lies_on_it() {
    let mut points: Vec<Vec3> = Vec::new();
    for i in 0..1331 {
        points.push(Vec3::new(f64::from(i % 11), f64::from(i / 11 % 11), f64::from(i / 121)));
    }
    points.extend_from_within(..);
    let turn = Random(1).turn();
    for turn in [Quat::IDENTITY, turn] {
        for (size, shift) in [(1.0, 0.0), (1e-200, 0.0), (1e250, 0.0), (0.1, 1e7)] {
            let placed: Vec<Vec3> = points.iter().map(|&p| turn.rotate(p) * size + Vec3::X * shift).collect();
            let hull = ConvexHull::new(&placed).unwrap();
            assert_eq!((hull.vertices().len(), hull.n_edges(), hull.n_faces()), (8, 12, 6), "{size} {shift}");
            assert_eq!(check_valid(&hull, &placed), Ok(()), "{size} {shift}");
            let middle = (hull.bounds()[0] + hull.bounds()[1]) * 0.5;
            assert!(hull.contains(middle) && !hull.contains(middle + Vec3::Z * (11.0 * size)), "{size} {shift}");
            assert!(placed.iter().all(|&p| hull.contains(p)));
        }
    }
}

#[test]
fn a_prism_has_its_sides() {
    for n in [3_u32, 5, 17, 100, 1000] {
        let turn = Random(u64::from(n)).turn();
        let corner = |i: u32| {
            let angle = core::f64::consts::TAU * f64::from(i / 2) / f64::from(n);
            turn.rotate(Vec3::new(libm::cos(angle), libm::sin(angle), f64::from(i % 2)))
        };
        let points: Vec<Vec3> = (0..2 * n).map(corner).collect();
        let hull = ConvexHull::new(&points).unwrap();
        assert_eq!((hull.vertices().len(), hull.n_faces()), (2 * n as usize, n as usize + 2));
        assert_eq!(hull.vertices(), points, "vertices keep the order of the points");
        assert_eq!(check_valid(&hull, &points), Ok(()));
    }
}

#[test]
fn a_hundred_thousand_points() {
    let mut r = Random(7);
    for sphere in [false, true] {
        let points: Vec<Vec3> = (0..100_000).map(|_| if sphere { r.on_sphere() } else { r.in_ball() }).collect();
        let hull = ConvexHull::new(&points).unwrap();
        assert_eq!(hull.vertices().len() == points.len(), sphere);
        assert_eq!(check_valid(&hull, &points), Ok(()));
        for _ in 0..100 {
            let direction = r.on_sphere();
            let best = hull.vertices().iter().map(|&v| direction.dot(v)).fold(f64::NEG_INFINITY, f64::max);
            assert!(best - direction.dot(hull.support(direction).1) <= hull.rounding());
        }
    }
}

#[test]
fn the_moments_are_those_of_the_body() {
    let size = [0.3, 0.5, 0.7];
    let corner = |i: u32| {
        let sign = |bit: u32| if i >> bit & 1 == 0 { -0.5 } else { 0.5 };
        Vec3::new(sign(0), sign(1), sign(2)).scale(size.into())
    };
    let points: Vec<Vec3> = (0..8).map(corner).collect();
    let (got, expected) =
        (ConvexHull::new(&points).unwrap().moments(Fill::Solid, 700.0).unwrap(), solid::cuboid(size, 700.0).unwrap());
    // Sums of 12 tetrahedra, each of some ten roundings.
    let rounding = 120.0 * f64::EPSILON;
    assert!((got.mass / expected.mass - 1.0).abs() < rounding && got.center.max_abs() < rounding);
    for i in 0..3 {
        assert!((got.second.at(i, i) / expected.second.at(i, i) - 1.0).abs() < rounding);
    }
}

/// Corners of an octahedron, divided `n` times: 4ⁿ⁺¹ + 2 points on the unit sphere.
fn sphere(n: u32) -> Vec<Vec3> {
    let m = i32::from(1_i16 << n);
    let mut points = Vec::new();
    for i in -m..=m {
        for j in -m..=m {
            let k = m - i.abs() - j.abs();
            for k in [k, -k] {
                if k.abs() + i.abs() + j.abs() == m && (k != 0 || points.last() != Some(&Vec3::ZERO)) {
                    let p = Vec3::new(f64::from(i), f64::from(j), f64::from(k));
                    points.push(p / p.length());
                }
            }
        }
    }
    points
}

#[test]
fn the_hull_of_a_finer_sphere_is_nearer_to_the_ball() {
    let ball = solid::sphere(1.0, 1.0).unwrap();
    let error = |n: u32| {
        let m = ConvexHull::new(&sphere(n)).unwrap().moments(Fill::Solid, 1.0).unwrap();
        [1.0 - m.mass / ball.mass, 1.0 - m.second.at(0, 0) / ball.second.at(0, 0)]
    };
    let (coarse, fine) = (error(4), error(5));
    for i in 0..2 {
        // A chord of length h stands off its arc by h²/8: half the length, a quarter of the error; the next term, in h⁴, is
        // h² ≈ 1 % of it.
        assert!((libm::log2(coarse[i] / fine[i]) - 2.0).abs() < 0.03, "{coarse:?} {fine:?}");
    }
}

#[test]
fn what_has_no_volume_is_refused_with_its_measure() {
    let said = |points: &[Vec3]| ConvexHull::new(points).unwrap_err().to_string();
    let line: Vec<Vec3> = (0..9).map(|i| Vec3::new(1.0, 2.0, -3.0) * f64::from(i)).collect();
    assert_eq!(said(&[]), "points: a convex hull needs at least 4, has 0");
    assert_eq!(said(&line[..3]), "points: a convex hull needs at least 4, has 3");
    let off = "to rounding: they are at most 0 m off it, so there is no volume";
    assert_eq!(said(&[Vec3::X; 5]), format!("points: are all at one place, {off}"));
    assert_eq!(said(&line), format!("points: all lie on one line, {off}"));
    let plane = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::X + Vec3::Y];
    assert_eq!(said(&plane), format!("points: all lie in one plane, {off}"));
    let mut thin = plane.to_vec();
    thin.push(Vec3::new(0.5, 0.5, 4.0 * f64::EPSILON));
    assert!(said(&thin).contains("at most 8.881784197001252e-16 m"), "{}", said(&thin));
    let with = |x: f64| [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z, Vec3::splat(x)];
    assert_eq!(said(&with(f64::NAN)), "points[4]: must be finite, is (NaN, NaN, NaN)");
    assert_eq!(said(&with(2e300)), "points[4]: must not exceed 1e300 m, has a coordinate of 2e300 m");
    let dust = with(0.1).map(|p| p * 1e-300);
    assert_eq!(said(&dust), "points: all lie within 1e-300 m of the origin: too small for a volume");
}
