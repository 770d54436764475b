//! One body of a world, to read and to push.

use super::World;
use crate::Error;
use crate::field::Wrench;
use crate::math::{Mat3, Pose, Quat, Vec3};
use crate::shape::Shape;
use crate::state::view;
use crate::step;
use crate::store::{BodyId, Group};

/// A body, to read. All vectors are in world axes unless the name says otherwise.
#[derive(Clone, Copy)]
pub struct BodyRef<'a> {
    world: &'a World,
    slot: usize,
}

impl core::fmt::Debug for BodyRef<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Body")
            .field("id", &self.id())
            .field("name", &self.name())
            .field("position", &self.position())
            .field("rotation", &self.rotation())
            .field("velocity", &self.velocity())
            .field("angular_velocity", &self.angular_velocity())
            .finish_non_exhaustive()
    }
}

impl<'a> BodyRef<'a> {
    pub(super) fn new(world: &'a World, slot: usize) -> Self {
        Self { world, slot }
    }
    /// Its name in the world.
    pub fn id(&self) -> BodyId {
        self.world.model.slots.ids()[self.slot]
    }
    /// The name that the user gave.
    pub fn name(&self) -> Option<&'a str> {
        self.world.model.names[self.slot].as_deref()
    }
    /// Whether forces, a prescription or nothing moves it.
    pub fn group(&self) -> Group {
        self.world.model.slots.group_of(self.slot)
    }
    /// Its shapes, in its own frame.
    pub fn shapes(&self) -> &'a [Shape] {
        &self.world.model.shapes[self.slot]
    }
    /// Its own frame in the world.
    pub fn pose(&self) -> Pose {
        let bodies = &self.world.state.bodies;
        Pose::new(bodies.x[self.slot], bodies.rot[self.slot]) * self.world.model.frame[self.slot].inverse()
    }
    /// The origin of its own frame \[m\].
    pub fn position(&self) -> Vec3 {
        self.pose().x
    }
    /// Its own axes → world axes.
    pub fn rotation(&self) -> Quat {
        self.pose().rot
    }
    /// Its own axes in the world: the columns of the rotation matrix R.
    pub fn axes(&self) -> Mat3 {
        self.rotation().to_mat3()
    }
    /// Centre of mass \[m\].
    pub fn center_of_mass(&self) -> Vec3 {
        self.world.state.bodies.x[self.slot]
    }
    /// Mass \[kg\]; infinite where forces move nothing.
    pub fn mass(&self) -> f64 {
        if self.group() == Group::Dynamic { self.world.model.mass[self.slot] } else { f64::INFINITY }
    }
    /// Principal moments of inertia [kg·m²]; infinite where forces move nothing.
    pub fn principal_inertia(&self) -> Vec3 {
        if self.group() == Group::Dynamic { self.world.model.inertia[self.slot] } else { Vec3::splat(f64::INFINITY) }
    }
    /// Centre of mass and principal axes, in its own frame.
    pub fn principal_frame(&self) -> Pose {
        self.world.model.frame[self.slot]
    }
    /// J = R J0 Rᵀ about the centre of mass, world axes [kg·m²]; infinite on the diagonal where forces move nothing.
    pub fn inertia(&self) -> Mat3 {
        if self.group() != Group::Dynamic {
            return Mat3::diagonal(Vec3::splat(f64::INFINITY));
        }
        let r = self.world.state.bodies.rot[self.slot].to_mat3();
        r * Mat3::diagonal(self.world.model.inertia[self.slot]) * r.transposed()
    }
    /// Velocity of the centre of mass \[m/s\].
    pub fn velocity(&self) -> Vec3 {
        step::velocities(&self.world.model, &self.world.state, self.slot).0
    }
    /// ω = R J0⁻¹ Rᵀ L \[rad/s\].
    pub fn angular_velocity(&self) -> Vec3 {
        step::velocities(&self.world.model, &self.world.state, self.slot).1
    }
    /// Linear momentum p [kg·m/s]; zero where forces move nothing.
    pub fn momentum(&self) -> Vec3 {
        if self.group() == Group::Dynamic { self.world.state.bodies.p[self.slot] } else { Vec3::ZERO }
    }
    /// Angular momentum L about the centre of mass [kg·m²/s]; zero where forces move nothing.
    pub fn angular_momentum(&self) -> Vec3 {
        if self.group() == Group::Dynamic { self.world.state.bodies.l[self.slot] } else { Vec3::ZERO }
    }
    /// Angular momentum about a point o: (x − o) × p + L [kg·m²/s].
    pub fn angular_momentum_about(&self, o: impl Into<Vec3>) -> Vec3 {
        (self.center_of_mass() - o.into()).cross(self.momentum()) + self.angular_momentum()
    }
    /// ½ m v² and ½ ω·L \[J\].
    pub fn kinetic_energy(&self) -> (f64, f64) {
        let (v, w) = step::velocities(&self.world.model, &self.world.state, self.slot);
        (0.5 * v.dot(self.momentum()), 0.5 * w.dot(self.angular_momentum()))
    }
    /// The velocity v + ω × r of the material point that is at `point` \[m\] now \[m/s\].
    pub fn velocity_at(&self, point: impl Into<Vec3>) -> Vec3 {
        let (v, w) = step::velocities(&self.world.model, &self.world.state, self.slot);
        v + w.cross(point.into() - self.center_of_mass())
    }
    /// The wrench that gravity, fields and applied forces make on it now: force \[N\], torque about the centre of mass [N·m].
    /// The reactions of pins are not in it.
    pub fn wrench(&self) -> Wrench {
        let world = self.world;
        step::wrench(&world.model, &world.inputs, &world.state, self.slot)
    }
    /// v̇ \[m/s²\] and ω̇ = J⁻¹(τ − ω × L) \[rad/s²\], with the reactions of its pins.
    pub fn acceleration(&self) -> (Vec3, Vec3) {
        super::pins::acceleration(self.world, self.slot)
    }
    /// The acceleration v̇ + ω̇ × r + ω × (ω × r) of the material point that is at `point` \[m\] now \[m/s²\].
    pub fn acceleration_at(&self, point: impl Into<Vec3>) -> Vec3 {
        let arm = point.into() - self.center_of_mass();
        let w = self.angular_velocity();
        let (a, alpha) = self.acceleration();
        a + alpha.cross(arm) + w.cross(w.cross(arm))
    }
    /// A point of its own frame, in the world \[m\].
    pub fn point(&self, point: impl Into<Vec3>) -> Vec3 {
        self.pose().point(point.into())
    }
}

/// A body, to push and move; [`BodyMut::read`] reads it.
pub struct BodyMut<'a> {
    world: &'a mut World,
    slot: usize,
}

impl<'a> BodyMut<'a> {
    pub(super) fn new(world: &'a mut World, slot: usize) -> Self {
        Self { world, slot }
    }
    /// The body, to read.
    pub fn read(&self) -> BodyRef<'_> {
        BodyRef::new(self.world, self.slot)
    }

    /// Adds a force \[N\] through the centre of mass, for the next step.
    ///
    /// # Errors
    /// If it is not finite, or forces do not move the body.
    pub fn apply_force(&mut self, force: impl Into<Vec3>) -> Result<(), Error> {
        let force = self.push("force", force.into())?;
        self.add_wrench(force, Vec3::ZERO);
        Ok(())
    }
    /// Adds a force \[N\] at a point of the world \[m\], for the next step: F, and τ = (r − x) × F.
    ///
    /// # Errors
    /// If a number is not finite, or forces do not move the body.
    pub fn apply_force_at(&mut self, force: impl Into<Vec3>, point: impl Into<Vec3>) -> Result<(), Error> {
        let force = self.push("force", force.into())?;
        let point = self.push("point", point.into())?;
        let arm = point - self.world.state.bodies.x[self.slot];
        self.add_wrench(force, arm.cross(force));
        Ok(())
    }
    /// Adds a force given in the body's own axes \[N\] at a point of its own frame \[m\], for the next step.
    ///
    /// # Errors
    /// If a number is not finite, or forces do not move the body.
    pub fn apply_local_force_at(&mut self, force: impl Into<Vec3>, point: impl Into<Vec3>) -> Result<(), Error> {
        let pose = self.read().pose();
        self.apply_force_at(pose.rot.rotate(force.into()), pose.point(point.into()))
    }
    /// Adds a torque [N·m], for the next step.
    ///
    /// # Errors
    /// If it is not finite, or forces do not move the body.
    pub fn apply_torque(&mut self, torque: impl Into<Vec3>) -> Result<(), Error> {
        let torque = self.push("torque", torque.into())?;
        self.add_wrench(Vec3::ZERO, torque);
        Ok(())
    }
    /// Changes the momentum by an impulse [N·s] through the centre of mass, now.
    ///
    /// # Errors
    /// If it is not finite, or forces do not move the body.
    pub fn apply_impulse(&mut self, impulse: impl Into<Vec3>) -> Result<(), Error> {
        let impulse = self.push("impulse", impulse.into())?;
        self.strike(impulse, Vec3::ZERO)
    }
    /// Changes the momenta by an impulse [N·s] at a point of the world \[m\], now: p += P, L += (r − x) × P.
    ///
    /// # Errors
    /// If a number is not finite, or forces do not move the body.
    pub fn apply_impulse_at(&mut self, impulse: impl Into<Vec3>, point: impl Into<Vec3>) -> Result<(), Error> {
        let impulse = self.push("impulse", impulse.into())?;
        let point = self.push("point", point.into())?;
        let arm = point - self.world.state.bodies.x[self.slot];
        self.strike(impulse, arm.cross(impulse))
    }
    /// Changes the angular momentum by an angular impulse [N·m·s], now.
    ///
    /// # Errors
    /// If it is not finite, or forces do not move the body.
    pub fn apply_angular_impulse(&mut self, impulse: impl Into<Vec3>) -> Result<(), Error> {
        let impulse = self.push("impulse", impulse.into())?;
        self.strike(Vec3::ZERO, impulse)
    }

    /// Sets the velocity of the centre of mass \[m/s\]; for a kinematic body, the one it keeps.
    ///
    /// # Errors
    /// If it is not finite, leaves the plane of a planar world, or the body is fixed.
    pub fn set_velocity(&mut self, v: impl Into<Vec3>) -> Result<(), Error> {
        let v = self.movable("velocity", v.into())?;
        self.in_plane("velocity", v.z == 0.0)?;
        self.world.state.bodies.p[self.slot] = bounded("velocity", v * self.world.model.mass[self.slot])?;
        self.settle();
        Ok(())
    }
    /// Sets the angular velocity \[rad/s\]; for a kinematic body, the one it keeps.
    ///
    /// # Errors
    /// If it is not finite, leaves the axis of a planar world, or the body is fixed.
    pub fn set_angular_velocity(&mut self, w: impl Into<Vec3>) -> Result<(), Error> {
        let w = self.movable("angular_velocity", w.into())?;
        self.in_plane("angular_velocity", w.x == 0.0 && w.y == 0.0)?;
        let rot = self.world.state.bodies.rot[self.slot];
        let inertia = self.world.model.inertia[self.slot];
        let l = rot.rotate(rot.inverse_rotate(w).scale(inertia));
        self.world.state.bodies.l[self.slot] = bounded("angular_velocity", l)?;
        self.settle();
        Ok(())
    }
    /// Sets the angular momentum about the centre of mass [kg·m²/s].
    ///
    /// # Errors
    /// If it is not finite, leaves the axis of a planar world, or forces do not move the body.
    pub fn set_angular_momentum(&mut self, l: impl Into<Vec3>) -> Result<(), Error> {
        let l = self.push("angular_momentum", l.into())?;
        self.in_plane("angular_momentum", l.x == 0.0 && l.y == 0.0)?;
        self.world.state.bodies.l[self.slot] = l;
        self.settle();
        Ok(())
    }
    /// Moves the body's own frame to a pose at once; the velocities in world axes stay.
    ///
    /// # Errors
    /// If a number is not finite, the rotation has no direction, the body leaves the plane of a planar world, or a pin
    /// holds it elsewhere.
    pub fn set_pose(&mut self, position: impl Into<Vec3>, rotation: impl Into<Quat>) -> Result<(), Error> {
        let (x, rot) = (position.into(), rotation.into());
        require_pose(x, rot)?;
        self.in_plane("position", x.z == 0.0)?;
        self.in_plane("rotation", rot.x == 0.0 && rot.y == 0.0)?;
        let w = self.read().angular_velocity();
        let pose = Pose::new(x, rot.normalized()) * self.world.model.frame[self.slot];
        super::pins::require_held(self.world, self.slot, pose)?;
        let bodies = &mut self.world.state.bodies;
        (bodies.x[self.slot], bodies.rot[self.slot]) = (pose.x, pose.rot.normalized());
        let inertia = self.world.model.inertia[self.slot];
        bodies.l[self.slot] = pose.rot.rotate(pose.rot.inverse_rotate(w).scale(inertia));
        if let Some(matrix) = self.world.state.matrix.get_mut(self.slot) {
            *matrix = pose.rot.to_mat3();
        }
        self.settle();
        Ok(())
    }
    /// Gives a kinematic body the velocities that take its own frame to a pose in `dt` \[s\].
    ///
    /// # Errors
    /// If a number is not finite, `dt` is not positive, or the body is not kinematic.
    pub fn move_to(&mut self, position: impl Into<Vec3>, rotation: impl Into<Quat>, dt: f64) -> Result<(), Error> {
        if self.read().group() != Group::Kinematic {
            return Err(Error::new("move_to", "only a kinematic body is moved as prescribed"));
        }
        if !(dt > 0.0 && dt.is_finite()) {
            return Err(Error::new("dt", format!("is {dt} s; it must be positive")));
        }
        let (x, rot) = (position.into(), rotation.into());
        require_pose(x, rot)?;
        let now = self.read().pose();
        let w = (rot.normalized() * now.rot.conjugate()).to_rotation_vector() / dt;
        let v = (x - now.x) / dt;
        self.in_plane("position", v.z == 0.0)?;
        self.in_plane("rotation", w.x == 0.0 && w.y == 0.0)?;
        self.set_velocity(v)?;
        self.set_angular_velocity(w)
    }

    fn push(&self, name: &str, v: Vec3) -> Result<Vec3, Error> {
        if self.slot >= self.world.model.n_dynamic() {
            return Err(Error::new(name, "the body is not dynamic: forces do not move it"));
        }
        self.movable(name, v)
    }
    fn movable(&self, name: &str, v: Vec3) -> Result<Vec3, Error> {
        if self.slot >= self.world.model.n_moving() {
            return Err(Error::new(name, "the body is fixed"));
        }
        if !v.is_finite() {
            return Err(Error::new(name, format!("is {:?}; it must be finite", v.to_array())));
        }
        Ok(v)
    }
    fn in_plane(&self, name: &str, inside: bool) -> Result<(), Error> {
        if self.world.model.planar && !inside {
            return Err(Error::new(name, "leaves the plane z = 0 of a planar world"));
        }
        Ok(())
    }
    fn add_wrench(&mut self, force: Vec3, torque: Vec3) {
        self.world.inputs.any = true;
        self.world.inputs.force[self.slot] += force;
        self.world.inputs.torque[self.slot] += torque;
    }
    fn strike(&mut self, mut p: Vec3, mut l: Vec3) -> Result<(), Error> {
        if self.world.model.planar {
            (p.z, l.x, l.y) = (0.0, 0.0, 0.0);
        }
        let bodies = &mut self.world.state.bodies;
        let p = bounded("impulse", bodies.p[self.slot] + p)?;
        let l = bounded("impulse", bodies.l[self.slot] + l)?;
        (bodies.p[self.slot], bodies.l[self.slot]) = (p, l);
        self.settle();
        Ok(())
    }
    fn settle(&mut self) {
        let id = self.read().id();
        let World { model, state, scratch, .. } = &mut *self.world;
        if !model.pins_of(id).is_empty() {
            step::settle_pins(model, state, scratch, id);
        }
    }
}

/// Refuses a place that is not finite and a quaternion without a direction.
fn require_pose(x: Vec3, rot: Quat) -> Result<(), Error> {
    if !x.is_finite() {
        return Err(Error::new("position", format!("is {:?}; it must be finite", x.to_array())));
    }
    if !(1e-12..=1e12).contains(&rot.norm_squared()) {
        let q: [f64; 4] = rot.into();
        return Err(Error::new("rotation", format!("the quaternion {q:?} has no direction")));
    }
    Ok(())
}

/// Refuses a momentum that overflows.
fn bounded(name: &str, momentum: Vec3) -> Result<Vec3, Error> {
    if momentum.length_squared().is_finite() {
        return Ok(momentum);
    }
    Err(Error::new(name, format!("the momentum {:?} overflows", momentum.to_array())))
}

/// What the laws of force see of a body.
impl BodyRef<'_> {
    /// The view that a custom field is given.
    pub fn view(&self) -> crate::field::BodyView<'_> {
        view(&self.world.model, &self.world.state.bodies, self.world.time(), self.slot)
    }
}

impl core::fmt::Debug for BodyMut<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        self.read().fmt(f)
    }
}
