//! What is measured of a run, frame by frame.

use super::quantity::{BodyQuantity, Quantity, SceneQuantity};
use crate::recording::Header;
use polhode::World;
use polhode::math::curve::{Frenet, ParallelFrame};
use polhode::math::{Mat3, Vec3};
use polhode::store::BodyId;
use polhode::world::BodyRef;

/// What a world has that is conserved, at the start or now.
#[derive(Clone, Copy, Debug)]
pub(super) struct Amounts {
    energy: f64,
    momentum: Vec3,
    angular_momentum: Vec3,
    /// What a change is a share of: the zero of a potential is a convention and momenta of bodies may cancel, so that totals
    /// alone say nothing.
    energy_scale: f64,
    momentum_scale: f64,
    angular_momentum_scale: f64,
}

impl Amounts {
    pub(super) fn of(world: &World) -> Self {
        let energy = world.energy();
        Self {
            energy: energy.total(),
            momentum: world.momentum(),
            angular_momentum: world.angular_momentum(Vec3::ZERO),
            energy_scale: energy.total().abs().max(energy.kinetic()),
            momentum_scale: world.bodies().map(|body| body.momentum().length()).sum(),
            angular_momentum_scale: world.bodies().map(|body| body.angular_momentum_about(Vec3::ZERO).length()).sum(),
        }
    }

    pub(super) fn energy_drift(&self, start: &Self) -> f64 {
        share(self.energy - start.energy, self.energy_scale.max(start.energy_scale))
    }
    pub(super) fn momentum_drift(&self, start: &Self) -> f64 {
        share((self.momentum - start.momentum).length(), self.momentum_scale.max(start.momentum_scale))
    }
    pub(super) fn angular_momentum_drift(&self, start: &Self) -> f64 {
        let change = (self.angular_momentum - start.angular_momentum).length();
        share(change, self.angular_momentum_scale.max(start.angular_momentum_scale))
    }
}

/// A change as a share of what it is a change of; of nothing there is no change.
fn share(change: f64, whole: f64) -> f64 {
    if whole == 0.0 { 0.0 } else { change / whole }
}

/// The path of one body's centre of mass, followed from step to step.
#[derive(Clone, Debug, Default)]
pub(super) struct PathFrame {
    acceleration: Option<(f64, Vec3)>,
    frenet: Frenet,
    parallel: Option<ParallelFrame>,
}

/// Speeds below this count as rest \[m/s\]: nothing that a picture shows moves by a nanometre a second.
const REST: f64 = 1e-9;

impl PathFrame {
    pub(super) fn follow(&mut self, time: f64, body: &BodyRef) {
        let (v, a) = (body.velocity(), body.acceleration().0);
        // The jerk by a difference over the last step: it only enters the torsion.
        let jerk = match self.acceleration {
            Some((before, a_before)) if time > before => (a - a_before) / (time - before),
            _ => Vec3::ZERO,
        };
        self.acceleration = Some((time, a));
        self.frenet = Frenet::new(v, a, jerk, REST);
        if let Some(tangent) = self.frenet.tangent {
            let x = body.center_of_mass();
            match &mut self.parallel {
                Some(parallel) => parallel.advance(x, tangent),
                None => self.parallel = Some(ParallelFrame::new(x, tangent)),
            }
        }
    }
}

/// All that a frame is made from.
pub(super) struct Sight<'a> {
    pub(super) world: &'a World,
    pub(super) reference: Option<&'a World>,
    pub(super) bodies: &'a [BodyId],
    pub(super) start: &'a Amounts,
    pub(super) paths: &'a [PathFrame],
}

impl Sight<'_> {
    fn body(&self, i: usize) -> BodyRef<'_> {
        self.world.body(self.bodies[i])
    }

    /// The matrix R of a body, as an explicit scheme keeps it.
    fn matrix(&self, i: usize) -> Mat3 {
        let body = self.body(i);
        match self.world.drifting_matrix(self.bodies[i]) {
            // Kept between principal and world axes; the picture is in the body's own.
            Some(matrix) => matrix * body.principal_frame().rot.to_mat3().transposed(),
            None => body.axes(),
        }
    }

    /// The value of a series; `place` is where the body of its name stands.
    pub(super) fn number(&self, quantity: &Quantity, place: usize) -> f64 {
        match quantity {
            Quantity::Scene(quantity) => self.of_scene(*quantity),
            Quantity::Body(_, quantity) => self.of_body(*quantity, place),
        }
    }

    fn of_scene(&self, quantity: SceneQuantity) -> f64 {
        let world = self.world;
        let largest = |of: &dyn Fn(usize) -> f64| (0..self.bodies.len()).map(of).fold(0.0, f64::max);
        match quantity {
            SceneQuantity::Translation => world.energy().translation,
            SceneQuantity::Rotation => world.energy().rotation,
            SceneQuantity::Potential => world.energy().potential,
            SceneQuantity::Energy => world.energy().total(),
            SceneQuantity::EnergyDrift => Amounts::of(world).energy_drift(self.start),
            SceneQuantity::Momentum => world.momentum().length(),
            SceneQuantity::MomentumDrift => Amounts::of(world).momentum_drift(self.start),
            SceneQuantity::AngularMomentum => world.angular_momentum(Vec3::ZERO).length(),
            SceneQuantity::AngularMomentumDrift => Amounts::of(world).angular_momentum_drift(self.start),
            SceneQuantity::AttitudeError => self.reference.map_or(f64::NAN, |reference| {
                largest(&|i| self.body(i).rotation().angle_to(reference.body(self.bodies[i]).rotation()))
            }),
            SceneQuantity::Orthogonality => largest(&|i| {
                let r = self.matrix(i);
                (r.transposed() * r - Mat3::IDENTITY).max_abs()
            }),
            SceneQuantity::Determinant => {
                let first = (0..self.bodies.len()).find(|&i| self.body(i).mass().is_finite());
                first.map_or(f64::NAN, |i| self.matrix(i).determinant())
            }
            SceneQuantity::PinGap => {
                world.model().pin_ids.iter().filter_map(|&pin| world.pin_gap(pin)).fold(0.0, f64::max)
            }
        }
    }

    fn of_body(&self, quantity: BodyQuantity, place: usize) -> f64 {
        let body = self.body(place);
        let (x, v, w) = (body.center_of_mass(), body.velocity(), body.angular_velocity());
        let (p, l) = (body.momentum(), body.angular_momentum());
        let axes = body.axes();
        let path = || self.paths.get(place).map_or(Frenet::default(), |path| path.frenet);
        match quantity {
            BodyQuantity::X => x.x,
            BodyQuantity::Y => x.y,
            BodyQuantity::Z => x.z,
            BodyQuantity::Vx => v.x,
            BodyQuantity::Vy => v.y,
            BodyQuantity::Vz => v.z,
            BodyQuantity::Speed => v.length(),
            BodyQuantity::Wx => w.x,
            BodyQuantity::Wy => w.y,
            BodyQuantity::Wz => w.z,
            BodyQuantity::Spin => w.length(),
            BodyQuantity::W1 => w.dot(axes.cols[0]),
            BodyQuantity::W2 => w.dot(axes.cols[1]),
            BodyQuantity::W3 => w.dot(axes.cols[2]),
            BodyQuantity::Px => p.x,
            BodyQuantity::Py => p.y,
            BodyQuantity::Pz => p.z,
            BodyQuantity::Lx => l.x,
            BodyQuantity::Ly => l.y,
            BodyQuantity::Lz => l.z,
            BodyQuantity::L => l.length(),
            BodyQuantity::Kinetic => body.kinetic_energy().0 + body.kinetic_energy().1,
            BodyQuantity::Tilt => libm::atan2(axes.cols[2].cross(Vec3::Z).length(), axes.cols[2].z),
            BodyQuantity::Curvature => path().curvature.unwrap_or(f64::NAN),
            BodyQuantity::Torsion => path().torsion.unwrap_or(f64::NAN),
        }
    }

    /// The channels of all bodies, positions relative to the origin of the header.
    pub(super) fn channels(&self, header: &Header, out: &mut Vec<f32>) {
        out.clear();
        let origin = Vec3::from(header.origin);
        for i in 0..self.bodies.len() {
            let body = self.body(i);
            let path = self.paths.get(i);
            let frenet = path.map_or(Frenet::default(), |path| path.frenet);
            for channel in &header.channels {
                let vector = match channel.name.as_str() {
                    "rotation" => {
                        let q: [f64; 4] = body.rotation().into();
                        out.extend(q.map(|x| x as f32));
                        continue;
                    }
                    "matrix" => {
                        out.extend(self.matrix(i).cols.iter().flat_map(|column| column.to_array()).map(|x| x as f32));
                        continue;
                    }
                    "position" => body.position() - origin,
                    "center" => body.center_of_mass() - origin,
                    "velocity" => body.velocity(),
                    "angular_velocity" => body.angular_velocity(),
                    "angular_momentum" => body.angular_momentum(),
                    "force" => body.wrench().force,
                    "torque" => body.wrench().torque,
                    "tangent" => frenet.tangent.unwrap_or(Vec3::ZERO),
                    "normal" => frenet.normal.unwrap_or(Vec3::ZERO),
                    "parallel" => path.and_then(|path| path.parallel).map_or(Vec3::ZERO, |frame| frame.normal()),
                    _ => Vec3::ZERO,
                };
                out.extend(vector.to_array().map(|x| x as f32));
            }
        }
    }
}
