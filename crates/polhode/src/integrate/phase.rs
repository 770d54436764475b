//! The moving state of all bodies at once, and its rate of change.
//!
//! The coupled schemes ask for forces at their stages. A stage is a [`Phase`], the answer is a [`Rates`], and
//! [`Work`] keeps the storage of the stages so that a step allocates nothing.

use crate::math::{Lane, Quat, Vec3};

/// Everything that moves, as arrays over bodies; all four of one length.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Phase {
    /// Centres of mass \[m\], world axes, (n_bodies).
    pub x: Vec<Vec3>,
    /// Orientations: unit quaternions, body (principal) axes to world axes, (n_bodies).
    pub rot: Vec<Quat>,
    /// Linear momenta \[kg·m/s\], world axes, (n_bodies).
    pub p: Vec<Vec3>,
    /// Angular momenta about the centres of mass \[kg·m²/s\], world axes, (n_bodies).
    pub l: Vec<Vec3>,
}

/// The rate of change of a [`Phase`]: ẋ, ω, ṗ, L̇, all in world axes.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rates {
    /// Velocities of the centres of mass, ẋ = p/m \[m/s\], (n_bodies).
    pub v: Vec<Vec3>,
    /// Angular velocities, ω = R J0⁻¹ Rᵀ L \[rad/s\], (n_bodies).
    pub w: Vec<Vec3>,
    /// Forces, ṗ \[N\], (n_bodies).
    pub force: Vec<Vec3>,
    /// Torques about the centres of mass, L̇ \[N·m\], (n_bodies).
    pub torque: Vec<Vec3>,
}

/// The law of motion: writes every rate of the phase at time t \[s\]. The arrays of [`Rates`] come with n_bodies entries,
/// of any content.
pub type Law<'a> = dyn FnMut(f64, &Phase, &mut Rates) + 'a;

/// ω = R J0⁻¹ Rᵀ L, the angular velocity of angular momentum `l`, in world axes \[rad/s\].
#[inline(always)]
pub fn angular_velocity<T: Lane>(rot: Quat<T>, l: Vec3<T>, inertia: Vec3<T>) -> Vec3<T> {
    let y = rot.inverse_rotate(l);
    rot.rotate(Vec3::new(y.x / inertia.x, y.y / inertia.y, y.z / inertia.z))
}

impl Phase {
    /// `n` bodies at rest at the origin.
    pub fn at_rest(n: usize) -> Self {
        Self { x: vec![Vec3::ZERO; n], rot: vec![Quat::IDENTITY; n], p: vec![Vec3::ZERO; n], l: vec![Vec3::ZERO; n] }
    }
    /// The number of bodies.
    pub fn n_bodies(&self) -> usize {
        self.x.len()
    }
    /// Takes over the values of `other` without giving up this one's storage.
    pub fn copy_from(&mut self, other: &Self) {
        self.x.clone_from(&other.x);
        self.rot.clone_from(&other.rot);
        self.p.clone_from(&other.p);
        self.l.clone_from(&other.l);
    }
    /// x, p and l, which form a vector space, go on by h Σ bᵢ kᵢ; `rot` is left to the scheme.
    pub(super) fn add_vectors(&mut self, h: f64, terms: &[(f64, &Rates)]) {
        for &(b, k) in terms {
            let hb = h * b;
            for (x, v) in self.x.iter_mut().zip(&k.v) {
                *x += *v * hb;
            }
            for (p, force) in self.p.iter_mut().zip(&k.force) {
                *p += *force * hb;
            }
            for (l, torque) in self.l.iter_mut().zip(&k.torque) {
                *l += *torque * hb;
            }
        }
    }
    /// rot ← `rotation`(body) · rot, renormalised.
    pub(super) fn turn(&mut self, mut rotation: impl FnMut(usize) -> Quat) {
        for (body, rot) in self.rot.iter_mut().enumerate() {
            *rot = (rotation(body) * *rot).renormalized();
        }
    }
}

impl Rates {
    /// All zero, for `n` bodies.
    pub fn zero(n: usize) -> Self {
        let mut rates = Self::default();
        rates.resize(n);
        rates
    }
    fn resize(&mut self, n: usize) {
        for array in [&mut self.v, &mut self.w, &mut self.force, &mut self.torque] {
            array.resize(n, Vec3::ZERO);
        }
    }
}

/// Storage of the stages of a step. One serves every scheme; after the first step with the largest number of bodies no
/// step allocates.
#[derive(Clone, Debug, Default)]
pub struct Work {
    /// The stage where forces are asked for.
    pub(super) at: Phase,
    /// The rates at up to four stages.
    pub(super) k: [Rates; 4],
    /// Rates of the orientation in the coordinates of the scheme, at up to four stages.
    pub(super) u: [Vec<Vec3>; 4],
    /// Quaternion rates q̇ = ½ ω q at up to four stages.
    pub(super) dq: [Vec<Quat>; 4],
}

impl Work {
    /// No storage yet: the first step makes it.
    pub fn new() -> Self {
        Self::default()
    }
    /// Overwrites everything with what no computation survives.
    pub fn poison(&mut self) {
        let nan = Vec3::splat(f64::NAN);
        let Self { at, k, u, dq } = self;
        for array in [&mut at.x, &mut at.p, &mut at.l].into_iter().chain(u) {
            array.fill(nan);
        }
        for rates in k {
            for array in [&mut rates.v, &mut rates.w, &mut rates.force, &mut rates.torque] {
                array.fill(nan);
            }
        }
        for array in dq.iter_mut().chain([&mut at.rot]) {
            array.fill(Quat::new(f64::NAN, f64::NAN, f64::NAN, f64::NAN));
        }
    }
    /// Room for n bodies, `at` at the start of the step.
    pub(super) fn prepare(&mut self, start: &Phase) -> &mut Self {
        let n = start.n_bodies();
        self.at.copy_from(start);
        self.k.iter_mut().for_each(|k| k.resize(n));
        self.u.iter_mut().for_each(|u| u.resize(n, Vec3::ZERO));
        self.dq.iter_mut().for_each(|dq| dq.resize(n, Quat::IDENTITY));
        self
    }
}
