//! Stage 1: gravity, what the user applies, and the fields, summed into one wrench a body.

use super::scratch::Scratch;
use crate::field::{BodyView, Field, Law, MutualGravity, Wrench};
use crate::integrate::Phase;
use crate::math::Vec3;
use crate::model::Model;
use crate::par::{Executor, Split};
use crate::state::{Inputs, view};
use crate::store::BodyId;

/// Bodies a block: some 10 µs of work for a few laws.
const BLOCK: usize = 256;

/// The slices that a block of bodies writes.
struct Block<'a> {
    force: &'a mut [Vec3],
    torque: &'a mut [Vec3],
    refused: &'a mut [bool],
}

impl Split for Block<'_> {
    fn len(&self) -> usize {
        self.force.len()
    }
    fn split_at(self, at: usize) -> (Self, Self) {
        let (fa, fb) = self.force.split_at_mut(at);
        let (ta, tb) = self.torque.split_at_mut(at);
        let (ra, rb) = self.refused.split_at_mut(at);
        (Self { force: fa, torque: ta, refused: ra }, Self { force: fb, torque: tb, refused: rb })
    }
}

/// Writes force and torque of every dynamic body at the given motion.
///
/// Without fields and user forces it only notes that uniform gravity is all there is, and nobody reads the arrays.
pub(super) fn forces(
    model: &Model,
    inputs: &Inputs,
    bodies: &Phase,
    time: f64,
    executor: &Executor,
    scratch: &mut Scratch,
) {
    let n = model.n_dynamic();
    scratch.only_gravity = model.fields.is_empty() && !inputs.any;
    if scratch.only_gravity {
        return;
    }
    place_point_masses(model, bodies, &mut scratch.points);
    let points = &scratch.points;
    let block =
        Block { force: &mut scratch.force[..n], torque: &mut scratch.torque[..n], refused: &mut scratch.refused[..n] };
    executor.for_each(block, BLOCK, &|first, block: Block| {
        for i in 0..block.force.len() {
            let (sum, all) = on_body(model, inputs, &view(model, bodies, time, first + i), first + i, points);
            (block.force[i], block.torque[i]) = (sum.force, sum.torque);
            block.refused[i] |= !all;
        }
    });
    for field in &model.fields {
        let Some(ends) = between(model, bodies, time, field) else { continue };
        let finite = ends.iter().all(|(_, wrench)| wrench.is_finite());
        for (slot, wrench) in ends {
            // What acts on the world, or on a body that forces do not move, is dropped.
            let Some(slot) = slot.filter(|&slot| slot < n) else { continue };
            if finite {
                scratch.force[slot] += wrench.force;
                scratch.torque[slot] += wrench.torque;
            }
            scratch.refused[slot] |= !finite;
        }
    }
    if model.planar {
        for slot in 0..n {
            let flat = in_plane(Wrench { force: scratch.force[slot], torque: scratch.torque[slot] });
            (scratch.force[slot], scratch.torque[slot]) = (flat.force, flat.torque);
        }
    }
}

/// What acts on one dynamic body now.
pub(super) fn wrench(model: &Model, inputs: &Inputs, bodies: &Phase, time: f64, slot: usize) -> Wrench {
    let mut points = PointMasses::default();
    place_point_masses(model, bodies, &mut points);
    let (mut sum, _) = on_body(model, inputs, &view(model, bodies, time, slot), slot, &points);
    for ends in model.fields.iter().filter_map(|field| between(model, bodies, time, field)) {
        if ends.iter().all(|(_, wrench)| wrench.is_finite()) {
            ends.into_iter().filter(|(end, _)| *end == Some(slot)).for_each(|(_, wrench)| sum += wrench);
        }
    }
    if model.planar { in_plane(sum) } else { sum }
}

/// In the plane z = 0 nothing pushes out of it or turns but about its normal.
fn in_plane(wrench: Wrench) -> Wrench {
    let (f, t) = (wrench.force, wrench.torque);
    Wrench { force: Vec3::new(f.x, f.y, 0.0), torque: Vec3::new(0.0, 0.0, t.z) }
}

/// Gravity, what the user applies and the laws on one body; and whether all of them were numbers. A wrench that is no number
/// would take its body, and then every body that it touches, out of the world: it is left out.
fn on_body(model: &Model, inputs: &Inputs, body: &BodyView, slot: usize, points: &PointMasses) -> (Wrench, bool) {
    let weight = model.gravity * (model.mass[slot] * model.gravity_scale[slot]);
    let mut sum = Wrench { force: weight + inputs.force[slot], torque: inputs.torque[slot] };
    let mut all = true;
    for field in &model.fields {
        if !field.applies_to(body.id) {
            continue;
        }
        let wrench = match &field.law {
            Law::Central(f) => f.wrench(body),
            Law::LinearDrag(f) => f.wrench(body),
            Law::QuadraticDrag(f) => f.wrench(body),
            Law::Buoyancy(f) => f.wrench(body),
            Law::Custom(f) => f.wrench(body),
            Law::MutualGravity(f) => gravitation(f, points, slot, body.x),
            Law::Spring(_) | Law::TorsionSpring(_) => continue,
        };
        if wrench.is_finite() {
            sum += wrench;
        } else {
            all = false;
        }
    }
    (sum, all)
}

/// The two ends of a law between bodies: their slots, where they are bodies, and their wrenches.
fn between(model: &Model, bodies: &Phase, time: f64, field: &Field) -> Option<[(Option<usize>, Wrench); 2]> {
    let slot_of = |id: Option<BodyId>| id.and_then(|id| model.slots.slot(id));
    let view_of = |slot: Option<usize>| slot.map(|slot| view(model, bodies, time, slot));
    match &field.law {
        Law::Spring(s) => {
            let (a, b) = (slot_of(s.a.body), slot_of(s.b.body));
            let on = s.wrenches(view_of(a).as_ref(), view_of(b).as_ref());
            Some([(a, on.0), (b, on.1)])
        }
        Law::TorsionSpring(s) => {
            let (a, b) = (slot_of(s.a), slot_of(Some(s.b)));
            let on = s.wrenches(view_of(a).as_ref(), &view_of(b)?);
            Some([(a, on.0), (b, on.1)])
        }
        _ => None,
    }
}

/// The point masses of all dynamic bodies, for mutual gravitation.
#[derive(Clone, Debug, Default)]
pub(super) struct PointMasses {
    /// Mass \[kg\] and place, world \[m\], body after body.
    pub(super) points: Vec<(f64, Vec3)>,
    /// First point mass of each dynamic body, and the end (n_dynamic + 1).
    pub(super) first: Vec<usize>,
}

/// Lists the point masses of all dynamic bodies: one a shape, or the whole body where it has none; nothing where no law asks.
fn place_point_masses(model: &Model, bodies: &Phase, into: &mut PointMasses) {
    into.points.clear();
    into.first.clear();
    if !model.fields.iter().any(|f| matches!(f.law, Law::MutualGravity(_))) {
        return;
    }
    for slot in 0..model.n_dynamic() {
        into.first.push(into.points.len());
        point_masses(model, bodies, slot, &mut |mass, x| into.points.push((mass, x)));
    }
    into.first.push(into.points.len());
}

/// The point masses of one body, world.
pub(super) fn point_masses(model: &Model, bodies: &Phase, slot: usize, visit: &mut impl FnMut(f64, Vec3)) {
    let parts = &model.point_masses[slot];
    if parts.is_empty() {
        return visit(model.mass[slot], bodies.x[slot]);
    }
    for &(mass, point) in parts {
        visit(mass, bodies.x[slot] + bodies.rot[slot].rotate(point));
    }
}

/// The pull of all other bodies' point masses on one body's.
fn gravitation(f: &MutualGravity, all: &PointMasses, slot: usize, x: Vec3) -> Wrench {
    let PointMasses { points, first } = all;
    let mut sum = Wrench::ZERO;
    let own = first[slot]..first[slot + 1];
    for &(m, a) in &points[own.clone()] {
        let mut force = Vec3::ZERO;
        for &(m_b, b) in points[..own.start].iter().chain(&points[own.end..]) {
            force += f.pull(m, a, m_b, b);
        }
        sum += Wrench::at(force, a - x);
    }
    sum
}
