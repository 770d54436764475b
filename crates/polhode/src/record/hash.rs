//! One number that tells whether two worlds are in the same state, to the last bit.

use crate::math::Vec3;
use crate::world::World;

/// A 64-bit hash of x, rot, p, l (and R, where an integrator keeps it) of every body, of the pins' impulses, of the applied
/// forces and of the clock.
///
/// Two runs that print the same hash went the same way: on any machine, with any number of threads and any width of the
/// arithmetic.
pub fn state_hash(world: &World) -> u64 {
    let state = world.state();
    let mut hash = Hash::default();
    hash.number(state.time);
    hash.number(state.time_error);
    hash.word(state.steps);
    let bodies = &state.bodies;
    for slot in 0..world.len() {
        for v in [bodies.x[slot], bodies.p[slot], bodies.l[slot]] {
            hash.numbers(v);
        }
        let rot = bodies.rot[slot];
        hash.number(rot.w);
        hash.numbers(rot.vector());
    }
    for &v in state.pin_closing.iter().chain(&state.pin_impulse) {
        hash.numbers(v);
    }
    for column in state.matrix.iter().flat_map(|m| m.cols) {
        hash.numbers(column);
    }
    hash.number(state.last_step);
    if world.inputs().any {
        world.inputs().force.iter().chain(&world.inputs().torque).for_each(|&v| hash.numbers(v));
    }
    hash.finish()
}

/// Multiply and rotate, one word after the other: every bit of every word reaches every bit of the result.
struct Hash(u64);

impl Default for Hash {
    fn default() -> Self {
        Self(0x9e37_79b9_7f4a_7c15)
    }
}

impl Hash {
    fn number(&mut self, x: f64) {
        self.word(x.to_bits());
    }
    fn numbers(&mut self, v: Vec3) {
        self.number(v.x);
        self.number(v.y);
        self.number(v.z);
    }
    fn word(&mut self, word: u64) {
        self.0 = (self.0 ^ word).wrapping_mul(0xff51_afd7_ed55_8ccd).rotate_left(29);
    }
    fn finish(&self) -> u64 {
        let mut h = self.0;
        h = (h ^ (h >> 33)).wrapping_mul(0xc4ce_b9fe_1a85_ec53);
        h ^ (h >> 33)
    }
}
