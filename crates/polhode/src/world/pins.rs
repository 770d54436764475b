//! Pinned points of a world.

use super::World;
use crate::Error;
use crate::constraint::pin::{response, world_inverse_inertia};
use crate::math::{Pose, Vec3};
use crate::model::{Pin, PinId};
use crate::solve::pins::System;
use crate::step;
use crate::store::BodyId;

/// A pin that closes over more than this share of the body's arm would have to jump.
const GAP_ALLOWED: f64 = 1e-9;

impl World {
    /// Pins a point of a body, given in its own frame \[m\], to where it is now: a spherical bearing.
    ///
    /// The body's velocity loses what the bearing does not allow, at once. Pins need a symmetric integrator, such as the
    /// default.
    ///
    /// # Errors
    /// If the point is not finite, forces do not move the body, or the integrator does not close pins.
    pub fn pin(&mut self, body: BodyId, point: impl Into<Vec3>) -> Result<PinId, Error> {
        let point = point.into();
        let Some(slot) = self.model.slots.slot(body) else {
            return Err(Error::new("body", "is not in the world"));
        };
        if slot >= self.model.n_dynamic() {
            return Err(Error::new("body", "is not dynamic: there is nothing to hold"));
        }
        if !point.is_finite() {
            return Err(Error::new("point", format!("is {:?}; it must be finite", point.to_array())));
        }
        if !self.model.integrator.closes_pins() {
            let name = self.model.integrator;
            return Err(Error::new("integrator", format!("{name} does not close pinned points: use a symmetric one")));
        }
        if self.model.planar && point.z != 0.0 {
            return Err(Error::new("point", "leaves the plane z = 0 of a planar world"));
        }
        let at = self.body(body).point(point);
        let local = self.model.frame[slot].inverse_point(point);
        let (id, place) =
            self.model.add_pin(Pin::new(body, local, at, self.model.mass[slot], self.model.inertia[slot]));
        self.state.pin_opening.insert(place, Vec3::ZERO);
        self.state.pin_closing.insert(place, Vec3::ZERO);
        step::settle_pins(&self.model, &mut self.state, &mut self.scratch, body);
        Ok(id)
    }
    /// Takes a pin out. Returns whether it was there.
    pub fn unpin(&mut self, id: PinId) -> bool {
        let Some(place) = self.place_of(id) else { return false };
        self.model.pins.remove(place);
        self.model.pin_ids.remove(place);
        self.state.pin_opening.remove(place);
        self.state.pin_closing.remove(place);
        true
    }
    /// The force that a pin put on its body during the last step \[N\], or `None` if it was taken out.
    pub fn pin_reaction(&self, id: PinId) -> Option<Vec3> {
        let place = self.place_of(id)?;
        if self.state.pin_step == 0.0 {
            return Some(Vec3::ZERO);
        }
        Some((self.state.pin_opening[place] + self.state.pin_closing[place]) / self.state.pin_step)
    }
    /// How far a pinned point is from where it is held \[m\], or `None` if the pin was taken out.
    pub fn pin_gap(&self, id: PinId) -> Option<f64> {
        let pin = self.model.pins[self.place_of(id)?];
        let slot = self.model.slots.slot(pin.body)?;
        let bodies = &self.state.bodies;
        Some((bodies.x[slot] - pin.at + bodies.rot[slot].rotate(pin.point)).length())
    }

    fn place_of(&self, id: PinId) -> Option<usize> {
        self.model.pin_ids.iter().position(|&p| p == id)
    }
}

/// Refuses a pose at which the body's pins would not be where they are held.
pub(super) fn require_held(world: &World, slot: usize, pose: Pose) -> Result<(), Error> {
    let pins = world.model.pins_of(world.model.slots.ids()[slot]);
    for pin in &world.model.pins[pins] {
        let gap = (pose.point(pin.point) - pin.at).length();
        if gap > GAP_ALLOWED * (1.0 + pin.point.length() + pin.at.length()) {
            return Err(Error::new("position", format!("a pin holds the body: its point would be {gap} m off")));
        }
    }
    Ok(())
}

/// v̇ and ω̇ of a body, with the reactions that keep its pinned points where they are.
pub(super) fn acceleration(world: &World, slot: usize) -> (Vec3, Vec3) {
    let model = &world.model;
    let body = super::BodyRef::new(world, slot);
    if slot >= model.n_dynamic() {
        return (Vec3::ZERO, Vec3::ZERO);
    }
    let (w, l) = (body.angular_velocity(), body.angular_momentum());
    let rot = world.state.bodies.rot[slot];
    let inv_inertia_w = world_inverse_inertia(rot, model.inv_inertia[slot]);
    let wrench = body.wrench();
    let mut a = wrench.force * model.inv_mass[slot];
    let mut alpha = inv_inertia_w * (wrench.torque - w.cross(l));
    let pins = &model.pins[model.pins_of(body.id())];
    let arms: Vec<Vec3> = pins.iter().map(|p| rot.rotate(p.point)).collect();
    let mut system = System::default();
    system.reserve(pins.len());
    let free = |i: usize| a + alpha.cross(arms[i]) + w.cross(w.cross(arms[i]));
    let block = |i: usize, j: usize| response(model.inv_mass[slot], inv_inertia_w, arms[i], arms[j]);
    let reactions: Vec<Vec3> = system.solve(pins.len(), |i| -free(i), block).collect();
    for (&force, arm) in reactions.iter().zip(&arms) {
        a += force * model.inv_mass[slot];
        alpha += inv_inertia_w * arm.cross(force);
    }
    (a, alpha)
}
