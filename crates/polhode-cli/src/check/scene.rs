//! What several checks set up, and how they go through time.

use polhode::mass::MassProperties;
use polhode::math::{Mat3, Vec3};
use polhode::model::Body;
use polhode::{Error, World};

/// A body of given mass \[kg\] and principal moments [kg·m²], at rest with its axes along the world's.
pub(super) fn rigid(mass: f64, inertia: impl Into<Vec3>) -> Result<Body, Error> {
    let properties = MassProperties::new(mass, Vec3::ZERO, Mat3::diagonal(inertia.into()))?;
    Ok(Body::dynamic().mass_properties(properties))
}

/// A body of which only the centre of mass matters.
pub(super) fn ball(mass: f64) -> Result<Body, Error> {
    rigid(mass, [1.0, 1.0, 1.0])
}

/// Takes steps of `h`, and shows the world at each of the times, which are whole numbers of steps.
pub(super) fn visit(
    world: &mut World,
    h: f64,
    times: impl IntoIterator<Item = f64>,
    mut see: impl FnMut(usize, &World),
) {
    for (row, time) in times.into_iter().enumerate() {
        let goal = (time / h).round() as u64;
        while world.steps() < goal {
            world.step(h);
        }
        see(row, world);
    }
}

/// Takes `n` steps of `h`.
pub(super) fn steps(world: &mut World, n: usize, h: f64) {
    for _ in 0..n {
        world.step(h);
    }
}

/// The maximum of errors: what is no number counts as greater than all, so that it cannot pass unseen.
pub(super) trait Greatest {
    /// The greater of two, or NaN if one of them is.
    fn greatest(self, other: Self) -> Self;
}

impl Greatest for f64 {
    fn greatest(self, other: Self) -> Self {
        if self.is_nan() || self >= other { self } else { other }
    }
}

/// Whether two vectors are the same to the bit.
pub(super) fn same_bits(a: Vec3, b: Vec3) -> bool {
    a.to_array().map(f64::to_bits) == b.to_array().map(f64::to_bits)
}
