//! The description of a body, as a user writes it.

use crate::Error;
use crate::mass::{MassProperties, Moments};
use crate::math::{Pose, Quat, Vec3};
use crate::shape::Shape;
use crate::store::Group;

/// How fast a body turns at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Spin {
    /// Angular velocity ω, world \[rad/s\].
    Velocity(Vec3),
    /// Angular momentum L about the centre of mass, world [kg·m²/s].
    Momentum(Vec3),
}

/// The description of a body, given to [`World::add`](crate::World::add).
///
/// ```
/// use polhode::prelude::*;
/// let racket = Body::dynamic()
///     .name("racket")
///     .shape(Shape::cuboid([0.03, 0.25, 0.68]).density(600.0))
///     .position([0.0, 0.0, 2.0])
///     .angular_velocity([0.01, 12.0, 0.0]);
/// ```
#[derive(Clone, Debug)]
pub struct Body {
    pub(crate) group: Group,
    pub(crate) name: Option<String>,
    pub(crate) shapes: Vec<Shape>,
    pub(crate) mass: Option<MassProperties>,
    pub(crate) pose: Pose,
    pub(crate) velocity: Vec3,
    pub(crate) spin: Spin,
    pub(crate) gravity_scale: f64,
}

impl Body {
    fn new(group: Group) -> Self {
        Self {
            group,
            name: None,
            shapes: Vec::new(),
            mass: None,
            pose: Pose::IDENTITY,
            velocity: Vec3::ZERO,
            spin: Spin::Velocity(Vec3::ZERO),
            gravity_scale: 1.0,
        }
    }
    /// A body that forces move. It needs a shape or mass properties.
    pub fn dynamic() -> Self {
        Self::new(Group::Dynamic)
    }
    /// A body that moves as prescribed, whatever pushes it.
    pub fn kinematic() -> Self {
        Self::new(Group::Kinematic)
    }
    /// A body that does not move.
    pub fn fixed() -> Self {
        Self::new(Group::Fixed)
    }
    /// A name for errors, tables and pictures.
    pub fn name(mut self, name: impl Into<String>) -> Self {
        self.name = Some(name.into());
        self
    }
    /// Adds a shape; several make one rigid body.
    pub fn shape(mut self, shape: Shape) -> Self {
        self.shapes.push(shape);
        self
    }
    /// Mass, centre and inertia in the body's own frame, instead of those of its shapes.
    pub fn mass_properties(mut self, mass: MassProperties) -> Self {
        self.mass = Some(mass);
        self
    }
    /// Origin of the body's own frame, world \[m\]. The default is the origin.
    pub fn position(mut self, position: impl Into<Vec3>) -> Self {
        self.pose.x = position.into();
        self
    }
    /// The body's own axes → world axes; normalised when the body is added.
    pub fn rotation(mut self, rotation: impl Into<Quat>) -> Self {
        self.pose.rot = rotation.into();
        self
    }
    /// Velocity of the centre of mass, world \[m/s\].
    pub fn velocity(mut self, velocity: impl Into<Vec3>) -> Self {
        self.velocity = velocity.into();
        self
    }
    /// Angular velocity, world \[rad/s\].
    pub fn angular_velocity(mut self, w: impl Into<Vec3>) -> Self {
        self.spin = Spin::Velocity(w.into());
        self
    }
    /// Angular momentum about the centre of mass, world [kg·m²/s]. For a dynamic body; others have none.
    pub fn angular_momentum(mut self, l: impl Into<Vec3>) -> Self {
        self.spin = Spin::Momentum(l.into());
        self
    }
    /// How strongly the world's uniform gravity pulls: 1 is natural, 0 is not at all.
    pub fn gravity_scale(mut self, scale: f64) -> Self {
        self.gravity_scale = scale;
        self
    }

    /// Checks what does not depend on the world, and returns the mass properties of a dynamic body.
    pub(super) fn validate(&self, planar: bool) -> Result<Option<MassProperties>, Error> {
        let finite = |name: &str, v: Vec3| {
            if v.is_finite() {
                return Ok(());
            }
            Err(Error::new(name, format!("is {:?}; every component must be finite", v.to_array())))
        };
        finite("position", self.pose.x)?;
        finite("velocity", self.velocity)?;
        match self.spin {
            Spin::Velocity(w) => finite("angular_velocity", w)?,
            Spin::Momentum(l) => {
                finite("angular_momentum", l)?;
                if self.group != Group::Dynamic {
                    return Err(Error::new("angular_momentum", "only a dynamic body has one: give angular_velocity"));
                }
            }
        }
        let norm = self.pose.rot.norm_squared();
        if !self.pose.rot.is_finite() || !(1e-12..=1e12).contains(&norm) {
            let q: [f64; 4] = self.pose.rot.into();
            return Err(Error::new("rotation", format!("the quaternion {q:?} has no direction")));
        }
        if !self.gravity_scale.is_finite() {
            return Err(Error::new("gravity_scale", format!("is {}; it must be finite", self.gravity_scale)));
        }
        for (i, shape) in self.shapes.iter().enumerate() {
            shape.validate().map_err(|e| e.inside(format!("shapes[{i}]")))?;
        }
        if self.group == Group::Fixed && (self.velocity != Vec3::ZERO || self.spin != Spin::Velocity(Vec3::ZERO)) {
            return Err(Error::new("velocity", "a fixed body does not move: make it kinematic, or leave this out"));
        }
        if self.group != Group::Dynamic {
            return Ok(None);
        }
        if let Some(mass) = &self.mass {
            return Ok(Some(*mass));
        }
        if self.shapes.is_empty() {
            return Err(Error::new("shapes", "a dynamic body needs a shape or mass properties"));
        }
        let mut sum = Moments::default();
        for (i, shape) in self.shapes.iter().enumerate() {
            sum = sum + shape.moments().map_err(|e| e.inside(format!("shapes[{i}]")))?;
        }
        if planar {
            return sum.planar()?.lamina().map(Some);
        }
        sum.properties().map(Some)
    }
}
