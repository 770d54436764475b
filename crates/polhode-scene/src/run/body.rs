//! A body of a scene becomes one of the engine's.

use crate::mesh;
use crate::recording::{FormInfo, ShapeInfo};
use crate::scene::{self, Form, Inertia, Kind, SceneFile};
use polhode::Error;
use polhode::mass::{MassProperties, MassProperties2, Moments, Particle};
use polhode::math::{Mat3, Quat, Vec3};
use polhode::model::Body;
use polhode::shape::{ConvexHull, Geometry, Shape, TriangleMesh};
use std::collections::BTreeMap;
use std::sync::Arc;

/// The meshes that were read, by file and scale, so that a thousand copies share one.
#[derive(Default)]
pub(super) struct Meshes {
    read: BTreeMap<(String, u64), Arc<TriangleMesh>>,
}

impl Meshes {
    fn get(&mut self, file: &SceneFile, mesh: &scene::Mesh) -> Result<Arc<TriangleMesh>, Error> {
        let key = (mesh.file.clone(), mesh.scale.to_bits());
        if let Some(found) = self.read.get(&key) {
            return Ok(found.clone());
        }
        let loaded = mesh::load(file.folder().join(&mesh.file), mesh.scale);
        let loaded = Arc::new(loaded.map_err(|e| Error::new("file", e.to_string()))?);
        self.read.insert(key, loaded.clone());
        Ok(loaded)
    }
}

/// The shapes of a body, as the engine has them.
pub(super) fn shapes(file: &SceneFile, body: &scene::Body, meshes: &mut Meshes) -> Result<Vec<Shape>, Error> {
    let one = |(i, shape): (usize, &scene::Shape)| {
        self::shape(file, shape, meshes).map_err(|e| e.inside(format!("shape[{i}]")))
    };
    body.shape.iter().enumerate().map(one).collect()
}

fn shape(file: &SceneFile, shape: &scene::Shape, meshes: &mut Meshes) -> Result<Shape, Error> {
    let mut made = match &shape.form {
        Form::Sphere(s) => Shape::sphere(s.radius),
        Form::Cuboid(s) => Shape::cuboid(s.size),
        Form::Capsule(s) => Shape::capsule(s.radius, s.length),
        Form::Cylinder(s) => Shape::cylinder(s.radius, s.length),
        Form::Cone(s) => Shape::cone(s.radius, s.length),
        Form::Ellipsoid(s) => Shape::ellipsoid(s.semi_axes),
        Form::Torus(s) => Shape::torus(s.major, s.minor),
        Form::HalfSpace(s) => Shape::half_space(s.normal),
        Form::Mesh(s) => Shape::mesh(meshes.get(file, s)?),
        Form::Hull(s) => {
            let points: Vec<Vec3> = s.points.iter().map(|&p| p.into()).collect();
            Shape::hull(ConvexHull::new(&points)?)
        }
        Form::Disc(s) => Shape::disc(s.radius),
        Form::Rectangle(s) => Shape::rectangle(s.size),
        Form::Polygon(s) => Shape::polygon(s.points.clone()),
        Form::Ring(s) => Shape::ring(s.inner, s.outer),
    };
    made = made.at(shape.position).rotated(shape.rotation.0);
    if let Some(density) = shape.density {
        made = made.density(density);
    }
    if let Some(mass) = shape.mass {
        made = made.mass(mass);
    }
    if let Some(thickness) = shape.shell {
        made = made.shell(thickness);
    }
    made.validate()?;
    Ok(made)
}

/// The engine's description of a body, but for where the copies of it are. `literal_33` prints the tensor of inertia as the
/// slides do.
pub(super) fn describe(body: &scene::Body, shapes: &[Shape], planar: bool, literal_33: bool) -> Result<Body, Error> {
    let mut made = match body.kind {
        Kind::Dynamic => Body::dynamic(),
        Kind::Kinematic => Body::kinematic(),
        Kind::Fixed => Body::fixed(),
    };
    for shape in shapes {
        made = made.shape(shape.clone());
    }
    if body.kind == Kind::Dynamic
        && let Some(mass) = given_mass(body, shapes, planar, literal_33)?
    {
        made = made.mass_properties(mass);
    }
    let rotation = body.rotation.0;
    let spin = match (body.angular_velocity, body.angular_velocity_degrees, body.angular_velocity_body) {
        (Some(w), ..) => Vec3::from(w),
        (_, Some(w), _) => Vec3::from(w.map(f64::to_radians)),
        (.., Some(w)) => rotation.rotate(w.into()),
        _ => Vec3::ZERO,
    };
    made = made.rotation(rotation).velocity(body.velocity).angular_velocity(spin).gravity_scale(body.gravity_scale);
    if let Some(l) = body.angular_momentum {
        made = made.angular_momentum(l);
    }
    Ok(made)
}

/// Mass properties where the shapes alone do not say them.
fn given_mass(
    body: &scene::Body,
    shapes: &[Shape],
    planar: bool,
    literal_33: bool,
) -> Result<Option<MassProperties>, Error> {
    if let (Some(inertia), Some(mass)) = (body.inertia, body.mass) {
        let center = Vec3::from(body.center.unwrap_or_default());
        let tensor = match inertia {
            Inertia::Planar(_) if !planar => {
                return Err(Error::new("inertia", "one number is enough in a planar scene only; here it takes three"));
            }
            Inertia::Planar(moment) => {
                return MassProperties2::new(mass, [center.x, center.y], moment)?.lamina().map(Some);
            }
            Inertia::Moments(moments) => Mat3::diagonal(moments),
            Inertia::Tensor(tensor) => tensor,
        };
        let made = MassProperties::new(mass, center, literal(tensor, literal_33));
        return made.map(Some).map_err(|e| with_reason(e, literal_33));
    }
    if body.particles.is_empty() && body.mass.is_none() && !literal_33 {
        return Ok(None);
    }
    let mut sum = Moments::ZERO;
    for (i, shape) in shapes.iter().enumerate() {
        sum = sum + shape.moments().map_err(|e| e.inside(format!("shape[{i}]")))?;
    }
    if !body.particles.is_empty() {
        let particles: Vec<Particle> = body.particles.iter().map(|&[x, y, z, m]| Particle::new([x, y, z], m)).collect();
        sum = sum + Moments::from_particles(&particles)?;
    }
    if let Some(mass) = body.mass {
        sum = sum.with_mass_times(mass / sum.mass);
    }
    if planar {
        return sum.planar()?.lamina().map(Some);
    }
    let inertia = literal(sum.inertia(), literal_33);
    let made = MassProperties::new(sum.mass, sum.center, inertia);
    let made = made.map(Some).map_err(|e| with_reason(e, literal_33));
    made.map_err(|e| if body.particles.is_empty() { e } else { Error::new("particles", e.to_string()) })
}

fn with_reason(error: Error, literal_33: bool) -> Error {
    if literal_33 {
        return Error::new(error.path(), format!("{}; the slides' J₃₃ = y² + z² is in it", error.message()));
    }
    error
}

/// The slides' tensor has y² + z² also in its last place, where x² + y² is right.
fn literal(mut inertia: Mat3, literal_33: bool) -> Mat3 {
    if literal_33 {
        inertia.cols[2].z = inertia.cols[0].x;
    }
    inertia
}

/// What a body looks like: its shapes, and a small ball for each particle.
pub(super) fn pictures(body: &scene::Body, shapes: &[Shape]) -> Vec<ShapeInfo> {
    let mut pictures: Vec<ShapeInfo> = shapes.iter().map(picture).collect();
    let reach = body.particles.iter().map(|&[x, y, z, _]| Vec3::new(x, y, z).length()).fold(0.0, f64::max);
    let heaviest = body.particles.iter().map(|particle| particle[3]).fold(0.0, f64::max);
    for &[x, y, z, mass] in &body.particles {
        // Volumes in the ratio of the masses; the heaviest a tenth of the whole wide.
        let size = if reach > 0.0 { 0.1 * reach } else { 0.1 };
        let form = FormInfo::Sphere { radius: size * libm::cbrt(mass / heaviest) };
        pictures.push(ShapeInfo { form, position: [x, y, z], rotation: Quat::IDENTITY.into() });
    }
    pictures
}

fn picture(shape: &Shape) -> ShapeInfo {
    let form = match &shape.geometry {
        Geometry::Sphere(s) => FormInfo::Sphere { radius: s.radius },
        Geometry::Cuboid(s) => FormInfo::Cuboid { size: s.size.to_array() },
        Geometry::Capsule(s) => FormInfo::Capsule { radius: s.radius, length: s.length },
        Geometry::Cylinder(s) => FormInfo::Cylinder { radius: s.radius, length: s.length },
        Geometry::Cone(s) => FormInfo::Cone { radius: s.radius, length: s.length },
        Geometry::Ellipsoid(s) => FormInfo::Ellipsoid { semi_axes: s.semi_axes.to_array() },
        Geometry::Torus(s) => FormInfo::Torus { major: s.major, minor: s.minor },
        Geometry::HalfSpace(s) => FormInfo::HalfSpace { normal: s.normal.to_array() },
        Geometry::Mesh(s) => FormInfo::Mesh {
            positions: s.positions().iter().flat_map(|p| p.to_array()).collect(),
            indices: s.triangles().iter().flatten().copied().collect(),
        },
        Geometry::Hull(s) => FormInfo::Mesh {
            positions: s.vertices().iter().flat_map(|p| p.to_array()).collect(),
            indices: s.triangles().into_flattened(),
        },
        Geometry::Disc(s) => FormInfo::Disc { radius: s.radius },
        Geometry::Rectangle(s) => FormInfo::Rectangle { size: s.size },
        Geometry::Polygon(s) => FormInfo::Polygon { points: s.points.clone() },
        Geometry::Ring(s) => FormInfo::Ring { inner: s.inner, outer: s.outer },
    };
    ShapeInfo { form, position: shape.pose.x.to_array(), rotation: shape.pose.rot.into() }
}
