//! What a world has: energy and momentum, summed in slot order.

use super::forces::point_masses;
use crate::field::{Law, MutualGravity};
use crate::integrate::Phase;
use crate::math::Vec3;
use crate::model::Model;
use crate::state::{State, view};

/// The energy of all dynamic bodies \[J\].
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Energy {
    /// Σ ½ m v².
    pub translation: f64,
    /// Σ ½ ω·L.
    pub rotation: f64,
    /// Of gravity (zero at the origin) and of all fields that have a potential.
    pub potential: f64,
}

impl Energy {
    /// ½ m v² + ½ ω·L.
    pub fn kinetic(&self) -> f64 {
        self.translation + self.rotation
    }
    /// Kinetic and potential.
    pub fn total(&self) -> f64 {
        self.kinetic() + self.potential
    }
}

/// The energy of the world \[J\].
pub fn energy(model: &Model, state: &State) -> Energy {
    let mut e = Energy::default();
    for slot in 0..model.n_dynamic() {
        let (p, l, rot) = (state.bodies.p[slot], state.bodies.l[slot], state.bodies.rot[slot]);
        e.translation += 0.5 * model.inv_mass[slot] * p.length_squared();
        let y = rot.inverse_rotate(l);
        e.rotation += 0.5 * y.dot(y.scale(model.inv_inertia[slot]));
        e.potential -= model.mass[slot] * model.gravity_scale[slot] * model.gravity.dot(state.bodies.x[slot]);
    }
    if !model.fields.is_empty() {
        e.potential += fields_potential(model, state);
    }
    e
}

fn fields_potential(model: &Model, state: &State) -> f64 {
    let at = |slot: usize| view(model, &state.bodies, state.time, slot);
    let of = |id: Option<_>| id.and_then(|id| model.slots.slot(id)).map(at);
    let mut sum = 0.0;
    for field in &model.fields {
        let each = |potential: &dyn Fn(usize) -> f64| -> f64 {
            let felt = |slot: &usize| field.applies_to(model.slots.ids()[*slot]);
            (0..model.n_dynamic()).filter(felt).map(potential).sum()
        };
        sum += match &field.law {
            Law::Central(f) => each(&|slot| f.potential(&at(slot))),
            Law::Buoyancy(f) => each(&|slot| f.potential(&at(slot))),
            Law::Custom(f) => each(&|slot| f.potential(&at(slot))),
            Law::Spring(f) => f.potential(of(f.a.body).as_ref(), of(f.b.body).as_ref()),
            Law::TorsionSpring(f) => of(Some(f.b)).map_or(0.0, |b| f.potential(of(f.a).as_ref(), &b)),
            Law::MutualGravity(f) => mutual_potential(f, model, &state.bodies),
            Law::LinearDrag(_) | Law::QuadraticDrag(_) => 0.0,
        };
    }
    sum
}

fn mutual_potential(f: &MutualGravity, model: &Model, bodies: &Phase) -> f64 {
    let mut points: Vec<(usize, f64, Vec3)> = Vec::new();
    for slot in 0..model.n_dynamic() {
        point_masses(model, bodies, slot, &mut |m, x| points.push((slot, m, x)));
    }
    let mut sum = 0.0;
    for (i, &(slot, m, x)) in points.iter().enumerate() {
        for &(other, m_b, b) in &points[..i] {
            if other != slot {
                sum += f.potential(m, x, m_b, b);
            }
        }
    }
    sum
}

/// Σ p over the dynamic bodies [kg·m/s].
pub fn momentum(model: &Model, state: &State) -> Vec3 {
    state.bodies.p[..model.n_dynamic()].iter().copied().sum()
}

/// Σ (x − o) × p + L over the dynamic bodies [kg·m²/s].
pub fn angular_momentum(model: &Model, state: &State, about: Vec3) -> Vec3 {
    (0..model.n_dynamic()).map(|i| (state.bodies.x[i] - about).cross(state.bodies.p[i]) + state.bodies.l[i]).sum()
}
