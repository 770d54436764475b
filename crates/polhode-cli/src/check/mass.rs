//! Mass, centre and inertia: particles, closed forms and meshes against each other.

use super::scene::Greatest;
use super::slope;
use super::suite::{Check, Findings, Group, Subject, Worst};
use crate::random::Random;
use core::f64::consts::{PI, TAU};
use polhode::Error;
use polhode::mass::{
    MassProperties, MassProperties2, Moments, Particle, Particle2, inertia_about_center, inertia_by_parallel_axis,
    mesh, solid,
};
use polhode::math::{Mat3, Quat, Vec3};

pub(super) const CHECKS: &[Check] = &[
    Check {
        group: Group::Mass,
        name: "mass-polyhedra",
        law: "The mesh of a unit cube has I = 1/6, and the tetrahedron (0, e₁, e₂, e₃) V = 1/6, x̄ = 1/4, ∫x² = 1/60, ∫xy = 1/120.",
        measure: polyhedra,
    },
    Check {
        group: Group::Mass,
        name: "mass-meshes",
        law: "Meshes of a ball, a cylinder, a cone, an ellipsoid and a torus approach the closed forms as the square of their edges.",
        measure: meshes,
    },
    Check {
        group: Group::Mass,
        name: "mass-particles",
        law: "Particles in a grid approach the closed form of the cuboid as the square of their distance.",
        measure: particles,
    },
    Check {
        group: Group::Mass,
        name: "mass-47-planar",
        law: "In the plane I = Σ m |r − c|² = Σ m |r|² − M |c|²: one number is subtracted, not a pair (slide 47).",
        measure: planar,
    },
    Check {
        group: Group::Mass,
        name: "mass-50-matrix",
        law: "J = Σ m (|r|² 1 − r rᵀ): its (3, 3) element is Σ m (x² + y²), its trace 2 Σ m |r|², its moments a triangle (slide 50).",
        measure: matrix,
    },
    Check {
        group: Group::Mass,
        name: "mass-frames",
        law: "Moved and turned particles have the moved and turned mass: J → R J Rᵀ, and M (|d|² 1 − d dᵀ) more about a point d away.",
        measure: frames,
    },
];

/// The largest difference of the elements.
fn difference(a: Mat3, b: Mat3) -> f64 {
    (a - b).max_abs()
}

fn polyhedra(_: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let rounding = 32.0 * f64::EPSILON;
    let because = "a sum over 4 or 12 triangles of numbers up to 1, each of some ten roundings of half an ε";
    let (positions, triangles) = cube();
    let cube = mesh::solid(&positions, &triangles, 1.0)?;
    findings.at_most("mass of the cube − 1 [kg]", (cube.mass - 1.0).abs(), rounding, because);
    findings.at_most("centre of the cube − 1/2 [m]", (cube.center - Vec3::splat(0.5)).max_abs(), rounding, because);
    let expected = Mat3::diagonal(Vec3::splat(1.0 / 6.0));
    findings.at_most("inertia of the cube − 1/6 [kg·m²]", difference(cube.inertia(), expected), rounding, because);

    let corners = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z];
    let tetrahedron = mesh::solid(&corners, &[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]], 1.0)?;
    findings.at_most("mass of the tetrahedron − 1/6 [kg]", (tetrahedron.mass - 1.0 / 6.0).abs(), rounding, because);
    let off = (tetrahedron.center - Vec3::splat(0.25)).max_abs();
    findings.at_most("centre of the tetrahedron − 1/4 [m]", off, rounding, because);
    // J = tr C 1 − C with C_ii = 1/60 and C_ij = 1/120.
    let (on, across) = (1.0 / 30.0, -1.0 / 120.0);
    let expected =
        Mat3::from_rows([on, across, across].into(), [across, on, across].into(), [across, across, on].into());
    let error = difference(tetrahedron.inertia_about([0.0; 3]), expected);
    findings.at_most("inertia of the tetrahedron about its corner [kg·m²]", error, rounding, because);
    Ok(findings)
}

/// The unit cube with a corner in the origin, each face of two triangles.
fn cube() -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let corner = |i: u32| Vec3::new(f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2 & 1));
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    ((0..8).map(corner).collect(), triangles)
}

/// The surface that a profile (radius, height) from the axis to the axis, upwards, sweeps about z, in `n` parts of a turn.
fn revolved(profile: &[(f64, f64)], n: u32) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let inner = &profile[1..profile.len() - 1];
    let rings = inner.len() as u32;
    let mut positions = vec![Vec3::new(0.0, 0.0, profile[0].1), Vec3::new(0.0, 0.0, profile[profile.len() - 1].1)];
    for &(radius, height) in inner {
        for i in 0..n {
            let (sin, cos) = libm::sincos(TAU * f64::from(i) / f64::from(n));
            positions.push(Vec3::new(radius * cos, radius * sin, height));
        }
    }
    let at = |ring: u32, i: u32| 2 + ring * n + i % n;
    let mut triangles = Vec::new();
    for i in 0..n {
        triangles.push([0, at(0, i + 1), at(0, i)]);
        triangles.push([1, at(rings - 1, i), at(rings - 1, i + 1)]);
        for ring in 1..rings {
            let (a, b, c, d) = (at(ring - 1, i), at(ring - 1, i + 1), at(ring, i + 1), at(ring, i));
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    (positions, triangles)
}

/// The surface of a torus about z, in `n` parts of either turn.
fn torus(major: f64, minor: f64, n: u32) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let mut positions = Vec::new();
    for i in 0..n {
        for j in 0..n {
            let (sin_i, cos_i) = libm::sincos(TAU * f64::from(i) / f64::from(n));
            let (sin_j, cos_j) = libm::sincos(TAU * f64::from(j) / f64::from(n));
            let radius = major + minor * cos_j;
            positions.push(Vec3::new(radius * cos_i, radius * sin_i, minor * sin_j));
        }
    }
    let at = |i: u32, j: u32| (i % n) * n + j % n;
    let corners = |k: u32| (k / n, k % n);
    let triangles = (0..n * n).map(corners).flat_map(|(i, j)| {
        let (a, b, c, d) = (at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
        [[a, b, c], [a, c, d]]
    });
    (positions, triangles.collect())
}

type Mesh = (Vec<Vec3>, Vec<[u32; 3]>);

fn meshes(_: Subject) -> Result<Findings, Error> {
    let half_circle = |n: u32| -> Vec<(f64, f64)> {
        (0..=n).map(|i| libm::sincos(PI * f64::from(i) / f64::from(n))).map(|(sin, cos)| (sin, -cos)).collect()
    };
    let stretched = |(positions, triangles): Mesh, by: Vec3| -> Mesh {
        (positions.iter().map(|p| p.scale(by)).collect(), triangles)
    };
    let axes = Vec3::new(0.5, 0.8, 1.3);
    type Case<'a> = (&'a str, Moments, Box<dyn Fn(u32) -> Mesh + 'a>);
    let cases: [Case; 5] = [
        ("ball", solid::sphere(1.0, 1.0)?, Box::new(|n| revolved(&half_circle(n / 2), n))),
        ("ellipsoid", solid::ellipsoid(axes, 1.0)?, Box::new(|n| stretched(revolved(&half_circle(n / 2), n), axes))),
        (
            "cylinder",
            solid::cylinder(0.7, 2.0, 1.0)?,
            Box::new(|n| revolved(&[(0.0, -1.0), (0.7, -1.0), (0.7, 1.0), (0.0, 1.0)], n)),
        ),
        ("cone", solid::cone(0.7, 2.0, 1.0)?, Box::new(|n| revolved(&[(0.0, 0.0), (0.7, 0.0), (0.0, 2.0)], n))),
        ("torus", solid::torus(1.0, 0.3, 1.0)?, Box::new(|n| torus(1.0, 0.3, n))),
    ];
    let mut findings = Findings::default();
    for (name, exact, mesh_of) in &cases {
        let of = |n: u32| -> Result<[f64; 2], Error> {
            let (positions, triangles) = mesh_of(n);
            let moments = mesh::solid(&positions, &triangles, 1.0)?;
            // The cone's closed form may have its origin elsewhere: its centre is compared by its inertia about the centre.
            Ok([
                (moments.mass / exact.mass - 1.0).abs(),
                difference(moments.inertia(), exact.inertia()) / exact.inertia().max_abs(),
            ])
        };
        let (coarse, fine) = (of(64)?, of(128)?);
        for (quantity, which) in [("mass", 0), ("inertia", 1)] {
            let slope = slope::slope(coarse[which], fine[which]);
            let what = format!("slope of the error of the {quantity} of the {name}'s mesh, {slope:.3} for 2");
            // The next term is smaller by the square of half an edge's angle, (π/64)² = 0.0024.
            let because = "the next term of the error is (π/64)² = 0.0024 of the first, times a number below 10";
            findings.at_most(what, (slope - 2.0).abs(), 0.024, because);
        }
    }
    Ok(findings)
}

/// J about the origin from the particles, or as slide 50 prints it.
fn inertia(subject: Subject, particles: &[Particle]) -> Mat3 {
    let mut sum = particles.iter().map(Particle::inertia_about_origin).fold(Mat3::ZERO, |a, b| a + b);
    if subject.as_on_the_slides() {
        sum.cols[2].z =
            particles.iter().map(|p| p.mass * (p.position.y * p.position.y + p.position.z * p.position.z)).sum();
    }
    sum
}

/// A cuboid's volume in n³ equal particles of one kilogram in all, in the middle of their cells.
pub(super) fn grid(size: Vec3, n: u32) -> Vec<Particle> {
    let place = |i: u32| (f64::from(i) + 0.5) / f64::from(n) - 0.5;
    let cells = (0..n * n * n).map(|i| Vec3::new(place(i % n), place(i / n % n), place(i / n / n)));
    cells.map(|c| Particle::new(c.scale(size), 1.0 / f64::from(n * n * n))).collect()
}

fn particles(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let size = Vec3::new(1.0, 2.0, 3.0);
    let exact = solid::cuboid(size, 1.0 / 6.0)?.inertia();
    let mut worst = Worst::default();
    for n in [2, 4, 8, 16] {
        let found = inertia(subject, &grid(size, n));
        // n midpoints of an edge a have the second moment (1 − 1/n²) a²/12 instead of a²/12, in each direction.
        let share = 1.0 - 1.0 / f64::from(n * n);
        let sum = f64::from(n * n * n) * f64::EPSILON;
        worst.see(
            format!("inertia of {n}³ particles of a cuboid − (1 − 1/n²) times its closed form [kg·m²]"),
            difference(found, exact.scaled(share)),
            sum * exact.max_abs(),
            "a sum of n³ terms rounds each by half an ε, and each term has a few roundings",
        );
    }
    findings.worst(worst);
    let mut previous = f64::NAN;
    for n in [8, 16] {
        let properties = MassProperties::from_particles(&grid(size, n))?;
        let error = difference(properties.inertia(), exact);
        if n == 16 {
            let slope = slope::slope(previous, error);
            let because = "the error is exactly 1/n² of the closed form; what is left is rounding, 1e-13 of it, and the slope's own";
            findings.at_most(
                format!("slope of the error for 8³ and 16³ particles, {slope:.12} for 2"),
                (slope - 2.0).abs(),
                1e-10,
                because,
            );
        }
        previous = error;
    }
    Ok(findings)
}

fn planar(_: Subject) -> Result<Findings, Error> {
    let mut random = Random::new(47);
    let mut worst = Worst::default();
    for _ in 0..1000 {
        let n = 2 + random.between(0.0, 20.0) as usize;
        let particles: Vec<Particle2> = (0..n)
            .map(|_| Particle2 {
                position: [random.between(-1.0, 1.0), random.between(-1.0, 1.0)],
                mass: random.between(0.1, 2.0),
            })
            .collect();
        let (a, b) = (inertia_about_center(&particles), inertia_by_parallel_axis(&particles));
        let kept = MassProperties2::from_particles(&particles)?.inertia();
        let about_origin: f64 =
            particles.iter().map(|p| p.mass * (p.position[0] * p.position[0] + p.position[1] * p.position[1])).sum();
        worst.see(
            format!("difference of the two forms, and of a body's own, over the larger of their terms, {n} particles"),
            (a - b).abs().greatest((a - kept).abs()) / about_origin,
            1e-14,
            "up to 22 terms are summed, each with a few roundings of half an ε: 45 ε",
        );
    }
    let mut findings = Findings::default();
    findings.worst(worst);
    Ok(findings)
}

fn matrix(subject: Subject) -> Result<Findings, Error> {
    let mut findings = Findings::default();
    let mut random = Random::new(50);
    let box_grid = grid(Vec3::new(1.0, 2.0, 3.0), 6);
    let cloud: Vec<Particle> = (0..200).map(|_| Particle::new(random.vector(1.0), random.between(0.1, 1.0))).collect();
    for (name, particles) in [("a box 1 × 2 × 3", box_grid), ("a cloud", cloud)] {
        let j = inertia(subject, &particles);
        let sum = |f: &dyn Fn(Vec3) -> f64| -> f64 { particles.iter().map(|p| p.mass * f(p.position)).sum() };
        let rounding = particles.len() as f64 * f64::EPSILON * j.max_abs();
        let because = "sums of as many terms as there are particles, each rounded by half an ε a few times";
        let across = sum(&|r| r.x * r.x + r.y * r.y);
        findings.at_most(
            format!("J₃₃ − Σ m (x² + y²), {name} [kg·m²]"),
            (j.at(2, 2) - across).abs(),
            rounding,
            because,
        );
        let trace = 2.0 * sum(&|r| r.length_squared());
        findings.at_most(
            format!("tr J − 2 Σ m r², {name} [kg·m²]"),
            (j.trace() - trace).abs(),
            3.0 * rounding,
            because,
        );
        let mut moments = j.symmetric_eigen().values.to_array();
        moments.sort_by(f64::total_cmp);
        let beyond = (moments[2] - moments[0] - moments[1]).greatest(0.0);
        findings.at_most(
            format!("largest moment beyond the sum of the others, {name} [kg·m²]"),
            beyond,
            rounding,
            because,
        );
    }
    let whole = solid::cuboid([1.0, 2.0, 3.0], 1.0)?.inertia();
    let expected = Vec3::new(13.0, 10.0, 5.0) * 0.5;
    let because = "the closed form m (b² + c²)/12 in a few roundings";
    findings.at_most(
        "moments of the box 1 × 2 × 3 of 6 kg − (6.5, 5, 2.5) [kg·m²]",
        difference(whole, Mat3::diagonal(expected)),
        8.0 * f64::EPSILON * 6.5,
        because,
    );
    Ok(findings)
}

fn frames(_: Subject) -> Result<Findings, Error> {
    let mut random = Random::new(53);
    let mut worst: [Worst; 2] = Default::default();
    for _ in 0..200 {
        let particles: Vec<Particle> =
            (0..20).map(|_| Particle::new(random.vector(1.0), random.between(0.1, 1.0))).collect();
        let (rot, by) = (Quat::from_rotation_vector(random.vector(3.0)), random.vector(3.0));
        let moved: Vec<Particle> =
            particles.iter().map(|p| Particle::new(rot.rotate(p.position) + by, p.mass)).collect();
        let (before, after) = (Moments::from_particles(&particles)?, Moments::from_particles(&moved)?);
        let r = rot.to_mat3();
        let because =
            "20 particles, up to 6 m from the origin, each moved and summed with some ten roundings of half an ε";
        let rounding = 100.0 * f64::EPSILON;
        let turned = difference(after.inertia(), r * before.inertia() * r.transposed());
        worst[0].see("J of turned particles − R J Rᵀ [kg·m²]", turned, rounding * 20.0 * 6.0, because);
        let d = after.center;
        let steiner = (Mat3::diagonal(Vec3::splat(d.length_squared())) - Mat3::outer(d, d)).scaled(after.mass);
        let about_origin = moved.iter().map(Particle::inertia_about_origin).fold(Mat3::ZERO, |a, b| a + b);
        let parallel = difference(about_origin, after.inertia() + steiner);
        worst[1].see("J about the origin − J − M (|d|² 1 − d dᵀ) [kg·m²]", parallel, rounding * 20.0 * 36.0, because);
    }
    let mut findings = Findings::default();
    for worst in worst {
        findings.worst(worst);
    }
    Ok(findings)
}
