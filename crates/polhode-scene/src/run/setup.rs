//! A scene becomes a world.

use super::body::{self, Meshes};
use super::push::{Formula, Push, lasting, literal_spring};
use crate::recording::{BodyInfo, LinkInfo, LinkKind};
use crate::scene::{Body, Field, Force, Kind, SceneFile, Slide, Spring, TorsionSpring, Variant};
use polhode::field::{self, Anchor};
use polhode::integrate::Integrator;
use polhode::math::Vec3;
use polhode::shape::Shape;
use polhode::step::Report;
use polhode::store::BodyId;
use polhode::{Error, World};
use std::collections::BTreeMap;

/// A world with what the scene says about it besides.
#[derive(Debug)]
pub(super) struct Setup {
    pub(super) world: World,
    /// The bodies in the order of the scene, the copies of one after another.
    pub(super) bodies: Vec<BodyId>,
    pub(super) infos: Vec<BodyInfo>,
    pub(super) links: Vec<LinkInfo>,
    /// Laws that act all the time, and forces that come and go.
    steady: Vec<field::Field>,
    timed: Vec<Timed>,
    /// Impulses, in the order of their times \[s\].
    pub(super) strikes: Vec<(f64, BodyId, Push)>,
    ranges: BTreeMap<String, std::ops::Range<usize>>,
}

/// A force with a beginning and an end \[s\].
#[derive(Debug)]
struct Timed {
    from: f64,
    until: f64,
    law: field::Field,
    acts: bool,
}

impl Setup {
    /// # Errors
    /// What is wrong, by its path in the scene.
    pub(super) fn new(file: &SceneFile, variant: &Variant) -> Result<Self, Error> {
        let settings = &variant.settings;
        let mut world = if file.scene.planar { World::planar() } else { World::new() };
        world.set_gravity(settings.gravity)?;
        let integrator: Integrator = settings.integrator.parse()?;
        world.set_integrator(integrator)?;
        if settings.slides.contains(&Slide::ExplicitR) {
            world.set_integrator("slides".parse()?)?;
        }
        let (bodies, infos, links) = (Vec::new(), Vec::new(), Vec::new());
        let (steady, timed, strikes, ranges) = (Vec::new(), Vec::new(), Vec::new(), BTreeMap::new());
        let mut setup = Self { world, bodies, infos, links, steady, timed, strikes, ranges };
        setup.add_bodies(file, variant)?;
        setup.add_fields(variant)?;
        setup.add_forces(variant)?;
        setup.add_pins(variant)?;
        setup.steady.clone_from(&setup.world.model().fields);
        setup.turn(0.0)?;
        setup.strike(0.0)?;
        Ok(setup)
    }

    fn add_bodies(&mut self, file: &SceneFile, variant: &Variant) -> Result<(), Error> {
        let literal_33 = variant.settings.slides.contains(&Slide::Inertia33);
        let mut meshes = Meshes::default();
        let starts = pinned_starts(variant);
        for (i, body) in variant.parts.body.iter().enumerate() {
            let inside = |e: Error| in_scene(&e).inside(place(&variant.places[0], "body", i));
            let shapes = body::shapes(file, body, &mut meshes).map_err(inside)?;
            let made = body::describe(body, &shapes, file.scene.planar, literal_33).map_err(inside)?;
            let first = self.bodies.len();
            for copy in 0..body.copies() {
                let name = if body.copies() == 1 { body.name.clone() } else { format!("{}.{copy}", body.name) };
                let position = starts.get(&name).copied().unwrap_or_else(|| grid_position(body, copy));
                let id = self.world.add(made.clone().name(name.clone()).position(position)).map_err(inside)?;
                self.bodies.push(id);
                self.infos.push(self.info(id, name, body, &shapes));
            }
            self.ranges.insert(body.name.clone(), first..self.bodies.len());
        }
        Ok(())
    }

    fn info(&self, id: BodyId, name: String, body: &Body, shapes: &[Shape]) -> BodyInfo {
        let made = self.world.body(id);
        let dynamic = body.kind == Kind::Dynamic;
        BodyInfo {
            name,
            kind: body.kind,
            color: body.color.as_ref().map(|color| color.0.clone()),
            mass: dynamic.then(|| made.mass()),
            inertia: dynamic.then(|| made.principal_inertia().to_array()),
            principal_rotation: made.principal_frame().rot.into(),
            shapes: body::pictures(body, shapes),
        }
    }

    /// The bodies that a name stands for, by their place in the scene: one, or all copies.
    pub(super) fn named(&self, name: &str) -> std::ops::Range<usize> {
        let (base, copy) = name.split_once('.').map_or((name, None), |(base, copy)| (base, copy.parse::<usize>().ok()));
        let all = self.ranges.get(base).cloned().unwrap_or(0..0);
        match copy {
            Some(copy) if copy < all.len() => all.start + copy..all.start + copy + 1,
            Some(_) => 0..0,
            None => all,
        }
    }

    fn one(&self, key: &str, name: &str) -> Result<usize, Error> {
        let found = self.named(name);
        if found.len() == 1 { Ok(found.start) } else { Err(Error::new(key, format!("there is no one body {name:?}"))) }
    }

    fn ids(&self, names: &[String]) -> Vec<BodyId> {
        names.iter().flat_map(|name| self.bodies[self.named(name)].to_vec()).collect()
    }

    fn add_fields(&mut self, variant: &Variant) -> Result<(), Error> {
        let formula = Formula::of(&variant.settings.slides);
        for (i, field) in variant.parts.field.iter().enumerate() {
            let inside = |e: Error| in_scene(&e).inside(place(&variant.places[2], "field", i));
            let made = match field {
                Field::Central(f) => self.only(field::Field::central(f.center, f.mu), f.only.as_deref()),
                Field::LinearDrag(f) => {
                    let drag = field::Field::linear_drag(f.linear, f.angular).wind(f.wind);
                    self.only(drag, f.only.as_deref())
                }
                Field::QuadraticDrag(f) => {
                    let drag = field::Field::quadratic_drag(f.linear, f.angular).wind(f.wind);
                    self.only(drag, f.only.as_deref())
                }
                Field::Buoyancy(f) => self.only(field::Field::buoyancy(f.density, f.level), f.only.as_deref()),
                Field::Spring(f) => self.spring(f, formula).map_err(inside)?,
                Field::TorsionSpring(f) => self.torsion_spring(f).map_err(inside)?,
                Field::MutualGravity(f) => field::Field::mutual_gravity(f.constant, f.softening),
            };
            self.world.add_field(made).map_err(inside)?;
        }
        Ok(())
    }

    fn only(&self, field: field::Field, names: Option<&[String]>) -> field::Field {
        match names {
            Some(names) => field.only(self.ids(names)),
            None => field,
        }
    }

    fn spring(&mut self, spring: &Spring, formula: Formula) -> Result<field::Field, Error> {
        let a = self.one("a", &spring.a)?;
        let b = spring.b.as_ref().map(|b| self.one("b", b)).transpose()?;
        let anchor = |body: Option<usize>, point: [f64; 3]| match body {
            Some(body) => Anchor::on(self.bodies[body], point),
            None => Anchor::world(point),
        };
        let (on_a, on_b) = (anchor(Some(a), spring.point_a), anchor(b, spring.point_b));
        let at = |anchor: &Anchor| anchor.body.map_or(anchor.point, |id| self.world.body(id).point(anchor.point));
        let rest_length = spring.rest_length.unwrap_or_else(|| (at(&on_b) - at(&on_a)).length());
        let law = field::Spring { a: on_a, b: on_b, stiffness: spring.stiffness, damping: spring.damping, rest_length };
        self.links.push(LinkInfo {
            kind: LinkKind::Spring,
            a: Some(a),
            point_a: spring.point_a,
            b,
            point_b: spring.point_b,
        });
        if !formula.is_literal() {
            return Ok(field::Field { law: field::Law::Spring(law), only: None });
        }
        match b {
            Some(_) => Err(Error::new("b", "the slides' formulas are there for springs to the world only")),
            None => Ok(literal_spring(law, self.bodies[a], formula)),
        }
    }

    fn torsion_spring(&mut self, spring: &TorsionSpring) -> Result<field::Field, Error> {
        let a = self.one("a", &spring.a)?;
        let b = spring.b.as_ref().map(|b| self.one("b", b)).transpose()?;
        let rot = |body: usize| self.world.body(self.bodies[body]).rotation();
        // The engine's second body is the one that there must be.
        let rest = b.map_or(rot(a), |b| rot(b).conjugate() * rot(a));
        let law = field::Field::torsion_spring(b.map(|b| self.bodies[b]), self.bodies[a], spring.stiffness);
        self.links.push(LinkInfo { kind: LinkKind::Torsion, a: Some(a), point_a: [0.0; 3], b, point_b: [0.0; 3] });
        if b.is_none() {
            let at = self.world.body(self.bodies[a]).position().to_array();
            self.links.last_mut().into_iter().for_each(|link| link.point_b = at);
        }
        Ok(law.rest_rotation(rest).damping(spring.damping))
    }

    fn add_forces(&mut self, variant: &Variant) -> Result<(), Error> {
        let formula = Formula::of(&variant.settings.slides);
        for (i, force) in variant.parts.force.iter().enumerate() {
            let inside = |e: Error| in_scene(&e).inside(place(&variant.places[1], "force", i));
            let bodies = self.bodies[self.named(&force.body)].to_vec();
            let dynamic = |id: &BodyId| self.world.body(*id).mass().is_finite();
            if !bodies.iter().all(dynamic) {
                return Err(inside(Error::new("body", "forces move dynamic bodies only")));
            }
            if is_impulse(force) {
                let push = Push::impulse(force, formula);
                self.strikes.extend(bodies.iter().map(|&id| (force.time.unwrap_or(0.0), id, push)));
            } else {
                let (from, until) = (force.from.unwrap_or(0.0), force.until.unwrap_or(f64::INFINITY));
                let law = lasting(force, formula, bodies);
                self.timed.push(Timed { from, until, law, acts: false });
            }
        }
        self.strikes.sort_by(|a, b| a.0.total_cmp(&b.0));
        Ok(())
    }

    fn add_pins(&mut self, variant: &Variant) -> Result<(), Error> {
        for (i, pin) in variant.parts.pin.iter().enumerate() {
            let inside = |e: Error| match e.path() {
                "integrator" => e,
                _ => in_scene(&e).inside(place(&variant.places[3], "pin", i)),
            };
            let body = self.one("body", &pin.body).map_err(inside)?;
            let at = self.world.body(self.bodies[body]).point(pin.point);
            let held = pin.at.map_or(at, Vec3::from);
            let gap = (held - at).length();
            // Several roundings of coordinates of that size, far below what a picture or a plot could show.
            if gap > 1e-9 * (1.0 + at.length() + held.length()) {
                return Err(inside(Error::new(
                    "at",
                    format!("another pin of {:?} leaves the point {gap} m off", pin.body),
                )));
            }
            self.world.pin(self.bodies[body], pin.point).map_err(inside)?;
            self.links.push(LinkInfo {
                kind: LinkKind::Pin,
                a: Some(body),
                point_a: pin.point,
                b: None,
                point_b: held.to_array(),
            });
        }
        Ok(())
    }

    /// A step with the forces and after the impulses of its time.
    ///
    /// A force acts in a step or not at all, by where the middle of the step is: then a constant force gives F·Δt to the bit.
    /// What could be refused here is an impulse that overflows; then the body has left the numbers already.
    pub(super) fn step(&mut self, dt: f64) -> Report {
        let middle = self.world.time() + 0.5 * dt;
        let _ = self.strike(middle).and_then(|()| self.turn(middle));
        self.world.step(dt)
    }

    /// Turns on the forces that act at `now` \[s\], and off those that do not.
    fn turn(&mut self, now: f64) -> Result<(), Error> {
        let acts = |force: &Timed| force.from <= now && now < force.until;
        if self.timed.iter().all(|force| force.acts == acts(force)) {
            return Ok(());
        }
        self.world.clear_fields();
        self.timed.iter_mut().for_each(|force| force.acts = acts(force));
        let now = self.timed.iter().filter(|force| force.acts).map(|force| &force.law);
        self.steady.iter().chain(now).try_for_each(|law| self.world.add_field(law.clone()))
    }

    /// Gives the impulses whose time has come.
    fn strike(&mut self, now: f64) -> Result<(), Error> {
        let due = self.strikes.partition_point(|(time, ..)| *time <= now);
        for (_, id, push) in self.strikes.drain(..due) {
            let impulse = push.wrench(&self.world.body(id).view());
            let mut body = self.world.body_mut(id);
            body.apply_impulse(impulse.force)?;
            body.apply_angular_impulse(impulse.torque)?;
        }
        Ok(())
    }
}

fn is_impulse(force: &Force) -> bool {
    force.impulse.is_some() || force.angular_impulse.is_some()
}

/// `compare[2].body[0]`, or `body[0]`.
fn place(outer: &str, list: &str, i: usize) -> String {
    if outer.is_empty() { format!("{list}[{i}]") } else { format!("{outer}.{list}[{i}]") }
}

/// The engine's words for a key in those of the scene.
fn in_scene(error: &Error) -> Error {
    let path = error.path().replace("shapes[", "shape[").replace("thickness", "shell");
    Error::new(path, error.message())
}

/// Where the copies of a body are: x runs fastest.
fn grid_position(body: &Body, copy: u64) -> Vec3 {
    let start = Vec3::from(body.position);
    let Some(repeat) = &body.repeat else { return start };
    let [nx, ny, _] = repeat.count.map(u64::from);
    let index = [copy % nx, copy / nx % ny, copy / nx / ny].map(|i| i as f64);
    start + Vec3::from(index).scale(repeat.spacing.into())
}

/// Where the bodies start whose pins say where their points are held; the first pin of a body counts.
fn pinned_starts(variant: &Variant) -> BTreeMap<String, Vec3> {
    let mut starts = BTreeMap::new();
    for pin in &variant.parts.pin {
        let base = pin.body.split('.').next().unwrap_or_default();
        let body = variant.parts.body.iter().find(|body| body.name == base);
        if let (Some(body), Some(at)) = (body, pin.at) {
            let start = Vec3::from(at) - body.rotation.0.rotate(pin.point.into());
            starts.entry(pin.body.clone()).or_insert(start);
        }
    }
    starts
}
