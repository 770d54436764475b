//! The public face: a world of bodies.

mod body;
mod pins;

pub use body::{BodyMut, BodyRef};

use crate::Error;
use crate::field::Field;
use crate::integrate::Integrator;
use crate::integrate::lanes::Lanes;
use crate::math::{Mat3, Vec3};
use crate::model::{Added, Body, Model};
use crate::par::Executor;
use crate::state::{Inputs, State};
use crate::step::{self, Energy, Report, Scratch};
use crate::store::{BodyId, insert_into, remove_from};

/// A world of bodies: what was described, what moves, and what pushes it.
///
/// ```
/// use polhode::prelude::*;
///
/// # fn main() -> Result<(), polhode::Error> {
/// let mut world = World::new(); // SI units, gravity (0, 0, −9.81)
/// let top = world.add(
///     Body::dynamic()
///         .shape(Shape::cuboid([0.1, 0.4, 0.9]).density(1000.0)) // full edge lengths
///         .position([0.0, 0.0, 2.0])
///         .angular_velocity([0.1, 5.0, 0.1]),
/// )?;
/// world.body_mut(top).apply_force_at([0.0, 20.0, 0.0], [0.0, 0.0, 2.4])?;
/// let report = world.step(1.0 / 60.0);
/// println!("{:?} at {} s", world.body(top).angular_momentum(), report.time);
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct World {
    pub(crate) model: Model,
    pub(crate) state: State,
    inputs: Inputs,
    scratch: Scratch,
    executor: Executor,
    audit: bool,
}

impl Default for World {
    fn default() -> Self {
        Self::new()
    }
}

impl World {
    /// An empty world with gravity (0, 0, −9.81) m/s².
    pub fn new() -> Self {
        Self::with_model(Model::new(Vec3::new(0.0, 0.0, -9.81), false))
    }
    /// An empty world in the plane z = 0, with gravity (0, −9.81, 0) m/s². Bodies move in x and y and turn about z; the one
    /// inertia of a body is its moment about z.
    pub fn planar() -> Self {
        Self::with_model(Model::new(Vec3::new(0.0, -9.81, 0.0), true))
    }
    fn with_model(model: Model) -> Self {
        Self {
            model,
            state: State::default(),
            inputs: Inputs::default(),
            scratch: Scratch::default(),
            executor: Executor::Serial,
            audit: false,
        }
    }

    // ---- bodies ----

    /// Adds a body.
    ///
    /// # Errors
    /// What is wrong with the description, with the path to it; the world is unchanged.
    pub fn add(&mut self, body: Body) -> Result<BodyId, Error> {
        let Added { id, slot, moves, start } = self.model.add(body)?;
        let bodies = &mut self.state.bodies;
        insert_into(&mut bodies.x, slot, moves, start.x);
        insert_into(&mut bodies.rot, slot, moves, start.rot);
        insert_into(&mut bodies.p, slot, moves, start.p);
        insert_into(&mut bodies.l, slot, moves, start.l);
        insert_into(&mut self.inputs.force, slot, moves, Vec3::ZERO);
        insert_into(&mut self.inputs.torque, slot, moves, Vec3::ZERO);
        if self.model.integrator.keeps_matrix() {
            insert_into(&mut self.state.matrix, slot, moves, start.rot.to_mat3());
        }
        Ok(id)
    }
    /// Removes a body, and the springs and pins that name it. Returns whether it was there.
    pub fn remove(&mut self, id: BodyId) -> bool {
        let Some((moves, pins)) = self.model.remove(id) else { return false };
        let bodies = &mut self.state.bodies;
        remove_from(&mut bodies.x, moves);
        remove_from(&mut bodies.rot, moves);
        remove_from(&mut bodies.p, moves);
        remove_from(&mut bodies.l, moves);
        remove_from(&mut self.inputs.force, moves);
        remove_from(&mut self.inputs.torque, moves);
        if !self.state.matrix.is_empty() {
            remove_from(&mut self.state.matrix, moves);
        }
        self.state.pin_opening.drain(pins.clone());
        self.state.pin_closing.drain(pins);
        true
    }
    /// A body, to read.
    ///
    /// # Panics
    /// If it was removed; see [`World::get`].
    pub fn body(&self, id: BodyId) -> BodyRef<'_> {
        self.get(id).expect("the body was removed from the world")
    }
    /// A body, to read, or `None` if it was removed.
    pub fn get(&self, id: BodyId) -> Option<BodyRef<'_>> {
        self.model.slots.slot(id).map(|slot| BodyRef::new(self, slot))
    }
    /// A body, to push and move.
    ///
    /// # Panics
    /// If it was removed; see [`World::get_mut`].
    pub fn body_mut(&mut self, id: BodyId) -> BodyMut<'_> {
        self.get_mut(id).expect("the body was removed from the world")
    }
    /// A body, to push and move, or `None` if it was removed.
    pub fn get_mut(&mut self, id: BodyId) -> Option<BodyMut<'_>> {
        self.model.slots.slot(id).map(|slot| BodyMut::new(self, slot))
    }
    /// All bodies, in slot order: dynamic, then kinematic, then fixed.
    pub fn bodies(&self) -> impl ExactSizeIterator<Item = BodyRef<'_>> {
        (0..self.len()).map(|slot| BodyRef::new(self, slot))
    }
    /// Number of bodies.
    pub fn len(&self) -> usize {
        self.model.slots.len()
    }
    /// Whether there are no bodies.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
    /// What was described: constants of the bodies, fields, settings.
    pub fn model(&self) -> &Model {
        &self.model
    }
    /// What moves, as bulk slices in slot order: `world.state().bodies.x` are the centres of mass.
    pub fn state(&self) -> &State {
        &self.state
    }
    /// Takes the world back, or forward, to a state that a world of the same bodies had.
    ///
    /// # Errors
    /// If the state is of another number of bodies or pins; the world is unchanged.
    pub fn restore(&mut self, state: &State) -> Result<(), Error> {
        let (bodies, pins) = (state.bodies.x.len(), state.pin_closing.len());
        if bodies != self.len() || pins != self.model.pins.len() {
            return Err(Error::new(
                "state",
                format!(
                    "is of {bodies} bodies and {pins} pins; this world has {} and {}",
                    self.len(),
                    self.model.pins.len()
                ),
            ));
        }
        self.state.clone_from(state);
        Ok(())
    }

    // ---- forces ----

    /// Adds a law of force; fields sum.
    ///
    /// # Errors
    /// The parameter that is out of range, a body that is not in the world, or a shape that the law does not know.
    pub fn add_field(&mut self, field: Field) -> Result<(), Error> {
        self.model.add_field(field)
    }
    /// Removes all fields.
    pub fn clear_fields(&mut self) {
        self.model.fields.clear();
    }
    /// Uniform gravity \[m/s²\].
    pub fn gravity(&self) -> Vec3 {
        self.model.gravity
    }
    /// Sets the uniform gravity \[m/s²\].
    ///
    /// # Errors
    /// If it is not finite, or leaves the plane of a planar world.
    pub fn set_gravity(&mut self, gravity: impl Into<Vec3>) -> Result<(), Error> {
        let gravity = gravity.into();
        if !gravity.is_finite() {
            return Err(Error::new("gravity", format!("is {:?}; it must be finite", gravity.to_array())));
        }
        if self.model.planar && gravity.z != 0.0 {
            return Err(Error::new("gravity", "leaves the plane z = 0 of a planar world"));
        }
        self.model.gravity = gravity;
        Ok(())
    }
    /// Whether applied forces and torques stay for the steps to come, or are cleared by each step (the default).
    pub fn keep_forces(&mut self, keep: bool) {
        self.inputs.keep = keep;
    }
    /// Forgets all applied forces and torques.
    pub fn clear_forces(&mut self) {
        self.inputs.clear();
    }

    // ---- time ----

    /// The scheme in time.
    pub fn integrator(&self) -> Integrator {
        self.model.integrator
    }
    /// Chooses the scheme in time. The default is velocity Verlet with the sixth-order pDMV rotation.
    ///
    /// # Errors
    /// If the world has pinned points and the scheme does not close them.
    pub fn set_integrator(&mut self, integrator: Integrator) -> Result<(), Error> {
        if !self.model.pins.is_empty() && !integrator.closes_pins() {
            return Err(Error::new(
                "integrator",
                format!("{integrator} does not close pinned points: use a symmetric one"),
            ));
        }
        self.model.integrator = integrator;
        self.state.matrix.clear();
        if integrator.keeps_matrix() {
            self.state.matrix.extend(self.state.bodies.rot.iter().map(|rot| rot.to_mat3()));
        }
        Ok(())
    }
    /// The width of the arithmetic; it changes no result.
    pub fn set_lanes(&mut self, lanes: Lanes) {
        self.model.lanes = lanes;
    }
    /// The number of threads of a step; it changes no result. The default is 1.
    ///
    /// # Errors
    /// If the operating system refuses the threads.
    pub fn set_threads(&mut self, threads: usize) -> Result<(), Error> {
        self.executor = Executor::with_threads(threads)?;
        Ok(())
    }
    /// Runs the steps in the caller's own pool of threads.
    pub fn set_thread_pool(&mut self, pool: std::sync::Arc<rayon::ThreadPool>) {
        self.executor = Executor::Pool(pool);
    }
    /// Whether each step's report has the energy; it costs a pass over the bodies. Off by default.
    pub fn audit(&mut self, audit: bool) {
        self.audit = audit;
    }
    /// Advances the world by `dt` \[s\].
    ///
    /// Stepping does not fail: what went wrong is in the report. A `dt` that is not finite moves nothing; a negative one goes
    /// back in time, which a symmetric scheme does exactly but for rounding.
    pub fn step(&mut self, dt: f64) -> Report {
        if !dt.is_finite() {
            return Report { time: self.time(), bodies: self.model.n_dynamic(), ..Report::default() };
        }
        let Self { model, state, inputs, scratch, executor, audit } = self;
        let mut report = executor.enter(|| step::step(model, inputs, state, scratch, executor, dt));
        if *audit {
            report.energy = Some(step::energy(model, state));
        }
        report
    }
    /// Simulated time \[s\].
    pub fn time(&self) -> f64 {
        self.state.time + self.state.time_error
    }
    /// Number of steps taken.
    pub fn steps(&self) -> u64 {
        self.state.steps
    }

    // ---- what the world has ----

    /// The energy of all dynamic bodies \[J\].
    pub fn energy(&self) -> Energy {
        step::energy(&self.model, &self.state)
    }
    /// Σ p of all dynamic bodies, world [kg·m/s].
    pub fn momentum(&self) -> Vec3 {
        step::momentum(&self.model, &self.state)
    }
    /// Σ (x − o) × p + L of all dynamic bodies about the point o, world [kg·m²/s].
    pub fn angular_momentum(&self, about: impl Into<Vec3>) -> Vec3 {
        step::angular_momentum(&self.model, &self.state, about.into())
    }
    /// The matrix R of a body where the integrator keeps one; its columns are the principal axes while it is a rotation.
    pub fn drifting_matrix(&self, id: BodyId) -> Option<Mat3> {
        self.state.matrix.get(self.model.slots.slot(id)?).copied()
    }

    /// Overwrites all scratch memory with NaN: a step that read any of it would show. For tests.
    #[doc(hidden)]
    pub fn poison(&mut self) {
        self.scratch.poison();
    }
}
