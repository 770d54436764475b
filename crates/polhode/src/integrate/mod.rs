//! One scheme a file: slices in, slices out, no bodies and no world.
//!
//! There are two families. A *split* step composes kicks (momenta change at fixed positions) with drifts (bodies move freely
//! at fixed momenta); the drift of a rotation is one of several maps, and symmetric steps compose to higher order. A
//! *coupled* step evaluates all rates together at its stages, as the classical methods of the books do.

pub mod phase;

pub mod exponential;
pub mod implicit_midpoint;
pub mod pdmv;
pub mod lanes;
pub mod splitting;
pub mod symmetric_top;
pub mod exact;
mod cayley;

pub mod explicit_euler;
pub mod explicit_matrix;
pub mod buss;
pub mod lie_midpoint;
pub mod rk4;
pub mod rkmk4;
pub mod crouch_grossman;
pub mod commutator_free;
pub mod dormand_prince;
pub mod phase_solver;

pub mod composition;

pub use composition::Composition;
pub use phase::Phase;

use crate::Error;
use crate::math::{Quat, Vec3};
use core::fmt;
use core::str::FromStr;
use pdmv::Order;

/// The map that turns a free body over a step at constant angular momentum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Drift {
    /// rot ← exp(h ω) rot with ω frozen: order 1.
    Exponential,
    /// Implicit midpoint in the Cayley form: order 2, conserves energy.
    ImplicitMidpoint,
    /// The (preprocessed) discrete Moser–Veselov map: order 2 to 10, conserves energy. Order 6 is the default.
    Pdmv(Order),
    /// Rotations about the body axes 1-2-3-2-1: order 2, symplectic.
    Splitting,
    /// An exact symmetric top and one rotation: order 2, symplectic.
    SymmetricTop,
    /// The exact solution in Jacobi functions.
    Exact,
}

impl Drift {
    /// Turns one body over `h` \[s\]: `l` in world axes, `k` reciprocal principal moments.
    pub fn rotate(self, rot: Quat, l: Vec3, k: Vec3, h: f64) -> Quat {
        let inertia = || Vec3::new(1.0 / k.x, 1.0 / k.y, 1.0 / k.z);
        match self {
            Self::Exponential => exponential::rotate(rot, l, inertia(), h),
            Self::ImplicitMidpoint => implicit_midpoint::rotate(rot, l, inertia(), h),
            Self::Pdmv(order) => lanes::rotate_one(order, rot, l, k, h),
            Self::Splitting => splitting::rotate(rot, l, inertia(), h),
            Self::SymmetricTop => symmetric_top::rotate(rot, l, inertia(), h),
            Self::Exact => exact::rotate(rot, l, inertia(), h),
        }
    }
}

/// When the momenta change within a split step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kick {
    /// After the drift, with the forces from before it: explicit Euler, order 1.
    Explicit,
    /// Before the drift: symplectic Euler, order 1.
    Symplectic,
    /// Half before and half after: velocity Verlet (Strang), order 2, symmetric, exact for constant forces.
    Verlet,
}

/// A scheme whose stages see positions and momenta together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Coupled {
    /// x += h v, rot ← exp(h ω) rot, p += h F, L += h τ: order 1.
    ExplicitEuler,
    /// The same on the nine numbers of R, as the lecture's slides print it: R leaves the rotations.
    ExplicitMatrix {
        /// Whether Gram–Schmidt brings R back after each step.
        gram_schmidt: bool,
    },
    /// Buss's augmented second-order method.
    Buss,
    /// The midpoint rule on the rotation group: order 2.
    LieMidpoint,
    /// Classical Runge–Kutta on the components of the quaternion: order 4.
    Rk4,
    /// Runge–Kutta–Munthe-Kaas: order 4.
    Rkmk4,
    /// Crouch–Grossman: order 3.
    CrouchGrossman3,
    /// The commutator-free method: order 4.
    CommutatorFree4,
    /// Adaptive Dormand–Prince 5(4), relative and absolute tolerance 1e-13 a step: the general reference.
    DormandPrince,
}

/// How a world is advanced in time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Integrator {
    /// Kicks and drifts, composed.
    Split {
        /// How a free body turns.
        drift: Drift,
        /// When the momenta change.
        kick: Kick,
        /// How a symmetric step is composed to a higher order.
        composition: Composition,
    },
    /// All rates at once.
    Coupled(Coupled),
}

impl Default for Integrator {
    /// Velocity Verlet with the sixth-order pDMV rotation.
    fn default() -> Self {
        Self::verlet(Drift::Pdmv(Order::Six))
    }
}

/// Every name, what it means, and the scheme.
const NAMES: [(&str, &str, Integrator); 22] = [
    ("pdmv6", "velocity Verlet with the preprocessed Moser-Veselov rotation of order 6 (default)", pdmv(Order::Six)),
    ("pdmv4", "the same with a rotation of order 4", pdmv(Order::Four)),
    ("pdmv8", "the same with a rotation of order 8", pdmv(Order::Eight)),
    ("pdmv10", "the same with a rotation of order 10", pdmv(Order::Ten)),
    ("dmv", "the same with the plain Moser-Veselov rotation, order 2", pdmv(Order::Two)),
    (
        "implicit-midpoint",
        "velocity Verlet with the implicit midpoint rotation",
        Integrator::verlet(Drift::ImplicitMidpoint),
    ),
    ("splitting", "velocity Verlet with rotations about the axes 1-2-3-2-1", Integrator::verlet(Drift::Splitting)),
    ("symmetric-top", "velocity Verlet with the symmetric-top splitting", Integrator::verlet(Drift::SymmetricTop)),
    ("exact", "velocity Verlet with the exact free rotation (Jacobi functions)", Integrator::verlet(Drift::Exact)),
    ("verlet", "velocity Verlet with the rotation exp(h w)", Integrator::verlet(Drift::Exponential)),
    ("symplectic-euler", "kick, then drift: order 1", first_order(Kick::Symplectic)),
    ("kick-explicit", "drift, then kick with the old forces: order 1", first_order(Kick::Explicit)),
    (
        "explicit-euler",
        "all rates from the start of the step, rotation exp(h w): order 1",
        Integrator::Coupled(Coupled::ExplicitEuler),
    ),
    ("slides", "explicit Euler on the matrix R, as the lecture prints it", slides(false)),
    ("slides-gram-schmidt", "the same with Gram-Schmidt after each step", slides(true)),
    ("buss", "Buss's augmented second-order method", Integrator::Coupled(Coupled::Buss)),
    ("lie-midpoint", "midpoint rule on the rotation group, order 2", Integrator::Coupled(Coupled::LieMidpoint)),
    ("rk4", "classical Runge-Kutta on (x, rot, p, L), order 4", Integrator::Coupled(Coupled::Rk4)),
    ("rkmk4", "Runge-Kutta-Munthe-Kaas, order 4", Integrator::Coupled(Coupled::Rkmk4)),
    ("crouch-grossman3", "Crouch-Grossman, order 3", Integrator::Coupled(Coupled::CrouchGrossman3)),
    (
        "dormand-prince",
        "adaptive Dormand-Prince 5(4), tolerance 1e-13: the general reference",
        Integrator::Coupled(Coupled::DormandPrince),
    ),
    ("commutator-free4", "commutator-free Lie group method, order 4", Integrator::Coupled(Coupled::CommutatorFree4)),
];

const fn pdmv(order: Order) -> Integrator {
    Integrator::verlet(Drift::Pdmv(order))
}
const fn first_order(kick: Kick) -> Integrator {
    Integrator::Split { drift: Drift::Exponential, kick, composition: Composition::Single }
}
const fn slides(gram_schmidt: bool) -> Integrator {
    Integrator::Coupled(Coupled::ExplicitMatrix { gram_schmidt })
}

impl Integrator {
    /// Velocity Verlet around a rotation.
    pub const fn verlet(drift: Drift) -> Self {
        Self::Split { drift, kick: Kick::Verlet, composition: Composition::Single }
    }
    /// A symmetric composition of velocity Verlet around a rotation.
    pub const fn composed(composition: Composition, drift: Drift) -> Self {
        Self::Split { drift, kick: Kick::Verlet, composition }
    }
    /// Every name with a line of explanation. A composition goes before a symmetric one: `suzuki4:pdmv10`.
    pub fn names() -> impl Iterator<Item = (&'static str, &'static str)> {
        NAMES.iter().map(|&(name, meaning, _)| (name, meaning))
    }
    /// Whether the scheme closes pinned points.
    pub fn closes_pins(&self) -> bool {
        matches!(self, Self::Split { kick: Kick::Verlet, .. })
    }
    /// Whether the scheme keeps the matrix R itself and lets it drift from a rotation.
    pub fn keeps_matrix(&self) -> bool {
        matches!(self, Self::Coupled(Coupled::ExplicitMatrix { .. }))
    }
}

impl FromStr for Integrator {
    type Err = Error;
    fn from_str(text: &str) -> Result<Self, Error> {
        let (composition, name) = text.split_once(':').map_or((None, text), |(c, name)| (Some(c), name));
        let found = NAMES.iter().find(|(n, ..)| *n == name).map(|&(.., scheme)| scheme);
        let Some(scheme) = found else {
            let all: Vec<_> = NAMES.iter().map(|(n, ..)| *n).collect();
            return Err(Error::new("integrator", format!("`{name}` is not one of {}", all.join(", "))));
        };
        let Some(prefix) = composition else { return Ok(scheme) };
        let Some(composition) = Composition::ALL.into_iter().find(|c| c.name() == prefix) else {
            let all: Vec<_> = Composition::ALL.iter().map(|c| c.name()).collect();
            return Err(Error::new(
                "integrator",
                format!("the composition `{prefix}` is not one of {}", all.join(", ")),
            ));
        };
        match scheme {
            Self::Split { drift, kick: Kick::Verlet, .. } if drift != Drift::Exponential => {
                Ok(Self::composed(composition, drift))
            }
            _ => {
                Err(Error::new("integrator", format!("`{name}` is not symmetric, so {prefix} gains no order with it")))
            }
        }
    }
}

impl fmt::Display for Integrator {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let plain = match *self {
            Self::Split { drift, kick, composition } => {
                if composition != Composition::Single {
                    write!(f, "{}:", composition.name())?;
                }
                Self::Split { drift, kick, composition: Composition::Single }
            }
            Self::Coupled(_) => *self,
        };
        match NAMES.iter().find(|(.., scheme)| *scheme == plain) {
            Some((name, ..)) => f.write_str(name),
            None => write!(f, "{self:?}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_read_back() {
        for (name, ..) in NAMES {
            assert_eq!(name.parse::<Integrator>().unwrap().to_string(), name);
        }
        assert_eq!("suzuki4:pdmv10".parse::<Integrator>().unwrap().to_string(), "suzuki4:pdmv10");
        for wrong in ["pdmv5", "suzuki4:rk4", "suzuki5:pdmv6", "", ":", "yoshida4:verlet"] {
            assert!(wrong.parse::<Integrator>().is_err(), "{wrong}");
        }
    }
}
