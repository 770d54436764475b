//! What the user described: it never changes inside a step.
//!
//! Every array has one element a body, in slot order: dynamic, then kinematic, then fixed (see [`crate::store`]).

mod body;
mod pin;

pub use body::{Body, Spin};
pub use pin::{Pin, PinId};

use crate::Error;
use crate::field::{Buoyancy, Field, Law};
use crate::integrate::Integrator;
use crate::integrate::lanes::Lanes;
use crate::mass::MassProperties;
use crate::math::{Pose, Quat, Vec3};
use crate::shape::Shape;
use crate::store::{BodyId, Group, Move, Slots, insert_into, remove_from};

/// The description of a world.
#[derive(Clone, Debug)]
pub struct Model {
    /// From ids to slots and back.
    pub slots: Slots,
    /// Mass \[kg\]; 1 for bodies that forces do not move, whose momentum is then their velocity (n_bodies).
    pub mass: Vec<f64>,
    /// 1/mass \[1/kg\] (n_bodies).
    pub inv_mass: Vec<f64>,
    /// Principal moments of inertia [kg·m²]; 1 for bodies that forces do not move (n_bodies).
    pub inertia: Vec<Vec3>,
    /// Reciprocal principal moments [1/(kg·m²)] (n_bodies).
    pub inv_inertia: Vec<Vec3>,
    /// Centre of mass and principal axes, in the body's own frame (n_bodies).
    pub frame: Vec<Pose>,
    /// Factor on the uniform gravity (n_bodies).
    pub gravity_scale: Vec<f64>,
    /// Point masses that stand for the body in mutual gravitation: mass \[kg\], and place from the centre of mass along the
    /// principal axes \[m\]; none where the whole mass at its centre will do (n_bodies).
    pub point_masses: Vec<Vec<(f64, Vec3)>>,
    /// Shapes, in the body's own frame (n_bodies).
    pub shapes: Vec<Vec<Shape>>,
    /// Names given by the user (n_bodies).
    pub names: Vec<Option<String>>,
    /// Laws of force, in the order they were added.
    pub fields: Vec<Field>,
    /// Pinned points, ordered by body and then by age (n_pins).
    pub pins: Vec<Pin>,
    /// Their names (n_pins).
    pub pin_ids: Vec<PinId>,
    /// Uniform gravity, world \[m/s²\].
    pub gravity: Vec3,
    /// Whether everything stays in the plane z = 0.
    pub planar: bool,
    /// The scheme in time.
    pub integrator: Integrator,
    /// The width of the arithmetic.
    pub lanes: Lanes,
    next_pin: u64,
}

/// A new body, and what the other arrays have to do to follow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Added {
    /// Its name.
    pub id: BodyId,
    /// Its slot.
    pub slot: usize,
    /// The moves that make room for it.
    pub moves: [Option<Move>; 2],
    /// Where it starts.
    pub start: Start,
}

/// Where a new body starts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start {
    /// Centre of mass \[m\].
    pub x: Vec3,
    /// Principal axes → world axes.
    pub rot: Quat,
    /// Linear momentum [kg·m/s].
    pub p: Vec3,
    /// Angular momentum about the centre of mass [kg·m²/s].
    pub l: Vec3,
}

impl Model {
    /// No bodies; gravity \[m/s²\].
    pub fn new(gravity: Vec3, planar: bool) -> Self {
        Self {
            slots: Slots::default(),
            mass: Vec::new(),
            inv_mass: Vec::new(),
            inertia: Vec::new(),
            inv_inertia: Vec::new(),
            frame: Vec::new(),
            gravity_scale: Vec::new(),
            point_masses: Vec::new(),
            shapes: Vec::new(),
            names: Vec::new(),
            fields: Vec::new(),
            pins: Vec::new(),
            pin_ids: Vec::new(),
            gravity,
            planar,
            integrator: Integrator::default(),
            lanes: Lanes::default(),
            next_pin: 0,
        }
    }

    /// Number of bodies that forces move: the first slots.
    pub fn n_dynamic(&self) -> usize {
        self.slots.group(Group::Dynamic).end
    }
    /// Number of bodies that move at all: the first slots.
    pub fn n_moving(&self) -> usize {
        self.slots.group(Group::Kinematic).end
    }

    /// Takes in a body: its constants go into the arrays, where it starts is returned for the state.
    ///
    /// # Errors
    /// What is wrong with the description, by path.
    pub fn add(&mut self, body: Body) -> Result<Added, Error> {
        let mass = body.validate(self.planar)?;
        if self.planar {
            require_planar(&body)?;
        }
        self.require_known_to_fields(&body)?;
        let Constants { mass, inertia, frame } = Constants::of(mass, self.planar)?;
        let pose = Pose::new(body.pose.x, body.pose.rot.normalized()) * frame;
        let rot = if frame.rot == Quat::IDENTITY { pose.rot } else { pose.rot.normalized() };
        let l = match body.spin {
            Spin::Momentum(l) => l,
            Spin::Velocity(w) => rot.rotate(rot.inverse_rotate(w).scale(inertia)),
        };
        let start = Start { x: pose.x, rot, p: body.velocity * mass, l };
        if !(start.x.is_finite() && start.p.is_finite() && start.l.is_finite()) {
            return Err(Error::new("velocity", "the momentum overflows"));
        }
        let inv_inertia = Vec3::new(1.0 / inertia.x, 1.0 / inertia.y, 1.0 / inertia.z);
        let point_masses = point_masses(&body, frame)?;
        let (id, slot, moves) = self.slots.insert(body.group);
        insert_into(&mut self.mass, moves, mass);
        insert_into(&mut self.inv_mass, moves, 1.0 / mass);
        insert_into(&mut self.inertia, moves, inertia);
        insert_into(&mut self.inv_inertia, moves, inv_inertia);
        insert_into(&mut self.frame, moves, frame);
        insert_into(&mut self.gravity_scale, moves, body.gravity_scale);
        insert_into(&mut self.point_masses, moves, point_masses);
        insert_into(&mut self.shapes, moves, body.shapes);
        insert_into(&mut self.names, moves, body.name);
        Ok(Added { id, slot, moves, start })
    }

    /// Forgets a body; the fields and pins that name it go with it. Returns the moves and the removed pins' places.
    pub fn remove(&mut self, id: BodyId) -> Option<([Option<Move>; 3], core::ops::Range<usize>)> {
        let moves = self.slots.remove(id)?;
        remove_from(&mut self.mass, moves);
        remove_from(&mut self.inv_mass, moves);
        remove_from(&mut self.inertia, moves);
        remove_from(&mut self.inv_inertia, moves);
        remove_from(&mut self.frame, moves);
        remove_from(&mut self.gravity_scale, moves);
        remove_from(&mut self.point_masses, moves);
        remove_from(&mut self.shapes, moves);
        remove_from(&mut self.names, moves);
        self.fields.retain_mut(|f| match &f.law {
            Law::Spring(s) => s.a.body != Some(id) && s.b.body != Some(id),
            Law::TorsionSpring(s) => s.a != Some(id) && s.b != id,
            _ => {
                if let Some(only) = &mut f.only {
                    only.retain(|&b| b != id);
                }
                true
            }
        });
        let pins = self.pins_of(id);
        self.pins.drain(pins.clone());
        self.pin_ids.drain(pins.clone());
        Some((moves, pins))
    }

    /// The places of a body's pins.
    pub fn pins_of(&self, id: BodyId) -> core::ops::Range<usize> {
        let first = self.pins.partition_point(|p| p.body < id);
        let count = self.pins[first..].iter().take_while(|p| p.body == id).count();
        first..first + count
    }

    /// Takes in a pin and returns its name and place.
    pub fn add_pin(&mut self, pin: Pin) -> (PinId, usize) {
        let place = self.pins_of(pin.body).end;
        let id = PinId(self.next_pin);
        self.next_pin += 1;
        self.pins.insert(place, pin);
        self.pin_ids.insert(place, id);
        (id, place)
    }

    /// Takes in a field.
    ///
    /// # Errors
    /// The parameter that is out of range, a body that does not exist, or a shape that the law does not know.
    pub fn add_field(&mut self, mut field: Field) -> Result<(), Error> {
        field.validate()?;
        if let Some(only) = &mut field.only {
            only.sort_unstable();
        }
        if field.only.is_some() && matches!(field.law, Law::Spring(_) | Law::TorsionSpring(_)) {
            return Err(Error::new("only", "a spring names its two bodies itself and takes no list"));
        }
        let known = |name: &str, id: BodyId| match self.slots.slot(id) {
            Some(slot) => Ok(slot),
            None => Err(Error::new(name, "names a body that is not in the world")),
        };
        match &field.law {
            Law::Spring(s) => {
                for (name, anchor) in [("a", &s.a), ("b", &s.b)] {
                    if let Some(id) = anchor.body {
                        known(name, id)?;
                    }
                }
            }
            Law::TorsionSpring(s) => {
                known("b", s.b)?;
                if let Some(id) = s.a {
                    known("a", id)?;
                }
            }
            Law::MutualGravity(_) if field.only.is_some() => {
                return Err(Error::new("only", "mutual gravitation acts between all dynamic bodies and takes no list"));
            }
            _ => {}
        }
        let mut slots = Vec::new();
        if let Some(only) = &field.only {
            for (i, &id) in only.iter().enumerate() {
                slots.push(known(&format!("only[{i}]"), id)?);
            }
        } else {
            slots.extend(self.slots.group(Group::Dynamic));
        }
        if matches!(field.law, Law::Buoyancy(_)) {
            for slot in slots {
                require_buoyant(self.names[slot].as_deref(), &self.shapes[slot])?;
            }
        }
        self.fields.push(field);
        Ok(())
    }

    fn require_known_to_fields(&self, body: &Body) -> Result<(), Error> {
        let floats = self.fields.iter().any(|f| f.only.is_none() && matches!(f.law, Law::Buoyancy(_)));
        if floats && body.group == Group::Dynamic {
            require_buoyant(body.name.as_deref(), &body.shapes)?;
        }
        Ok(())
    }
}

fn require_buoyant(name: Option<&str>, shapes: &[Shape]) -> Result<(), Error> {
    match shapes.iter().position(|s| !Buoyancy::knows(&s.geometry)) {
        None => Ok(()),
        Some(i) => Err(Error::new(
            format!("shapes[{i}]"),
            format!(
                "buoyancy acts on spheres and cuboids only; body {} has another shape: restrict the field to other bodies",
                name.unwrap_or("without a name")
            ),
        )),
    }
}

/// The constants of motion of a body about its centre of mass and principal axes.
struct Constants {
    mass: f64,
    inertia: Vec3,
    frame: Pose,
}

impl Constants {
    fn of(mass: Option<MassProperties>, planar: bool) -> Result<Self, Error> {
        let Some(mass) = mass else {
            // A prescribed body is stored with unit mass and unit inertia, so that p and l are its velocities and the one
            // drift serves all that moves. No force reaches it.
            return Ok(Self { mass: 1.0, inertia: Vec3::splat(1.0), frame: Pose::IDENTITY });
        };
        let mut center = mass.center();
        let (moments, axes) = if planar {
            // In the plane one number is the inertia: the moment about z. The others are never asked for.
            center.z = 0.0;
            let i = mass.inertia().at(2, 2);
            (Vec3::new(0.5 * i, 0.5 * i, i), Quat::IDENTITY)
        } else {
            let principal = mass.principal();
            (principal.moments, principal.axes)
        };
        let inverse = Vec3::new(1.0 / moments.x, 1.0 / moments.y, 1.0 / moments.z);
        if !(1.0 / mass.mass()).is_finite() || !inverse.length_squared().is_finite() {
            return Err(Error::new("inertia", "is too small: its reciprocal overflows"));
        }
        Ok(Self { mass: mass.mass(), inertia: moments, frame: Pose::new(center, axes) })
    }
}

/// The shapes of a composite body as point masses; a single shape or given mass properties act from the centre of mass.
fn point_masses(body: &Body, frame: Pose) -> Result<Vec<(f64, Vec3)>, Error> {
    if body.group != Group::Dynamic || body.mass.is_some() || body.shapes.len() < 2 {
        return Ok(Vec::new());
    }
    let place = |shape: &Shape| shape.moments().map(|m| (m.mass, frame.inverse_point(m.center)));
    body.shapes.iter().map(place).collect()
}

/// In a planar world everything starts in the plane and turns about its normal.
fn require_planar(body: &Body) -> Result<(), Error> {
    if body.group == Group::Fixed {
        return Ok(());
    }
    let off = |name: &str, v: Vec3| {
        Err(Error::new(name, format!("leaves the plane z = 0 of a planar world: {:?}", v.to_array())))
    };
    if body.pose.x.z != 0.0 {
        return off("position", body.pose.x);
    }
    if body.pose.rot.x != 0.0 || body.pose.rot.y != 0.0 {
        return off("rotation", body.pose.rot.vector());
    }
    if body.velocity.z != 0.0 {
        return off("velocity", body.velocity);
    }
    match body.spin {
        Spin::Velocity(w) if w.x != 0.0 || w.y != 0.0 => off("angular_velocity", w),
        Spin::Momentum(l) if l.x != 0.0 || l.y != 0.0 => off("angular_momentum", l),
        _ => Ok(()),
    }
}
