// Just enough mechanics to have something to show: a body under forces, by RK4 on (x, q, p, L).

import { between, conjugate, columns, multiply, normalize, rotate } from '../src/recording/rotation.js';

export function omegaOf(state, inertia) {
  const l = rotate(conjugate(state.q), state.l, [0, 0, 0]);
  return rotate(state.q, l.map((x, k) => x / inertia[k]), [0, 0, 0]);
}

function slope(state, mass, inertia, load) {
  const w = omegaOf(state, inertia);
  const dq = multiply([0, ...w], state.q, [0, 0, 0, 0]).map((x) => x / 2);
  const { force, torque } = load(state);
  return { x: state.p.map((p) => p / mass), q: dq, p: force, l: torque };
}

function along(state, d, h) {
  const go = (key) => state[key].map((x, k) => x + h * d[key][k]);
  return { x: go('x'), q: go('q'), p: go('p'), l: go('l') };
}

/** Frames at `interval` from `state` = {x, q, p, l}; `load(state)` gives force and torque. */
export function simulate({ mass, inertia, state, seconds, interval = 1 / 30, substeps = 40, load = () => ({ force: [0, 0, 0], torque: [0, 0, 0] }) }) {
  const out = [];
  const h = interval / substeps;
  for (let k = 0; k <= Math.round(seconds / interval); k++) {
    out.push({ t: k * interval, ...structuredClone(state), w: omegaOf(state, inertia), ...load(state) });
    for (let s = 0; s < substeps; s++) {
      const a = slope(state, mass, inertia, load);
      const b = slope(along(state, a, h / 2), mass, inertia, load);
      const c = slope(along(state, b, h / 2), mass, inertia, load);
      const d = slope(along(state, c, h), mass, inertia, load);
      const sum = {};
      for (const key of ['x', 'q', 'p', 'l']) sum[key] = a[key].map((x, i) => (x + 2 * b[key][i] + 2 * c[key][i] + d[key][i]) / 6);
      state = along(state, sum, h);
      normalize(state.q);
    }
  }
  return out;
}

export const CHANNELS = [
  ['position', 3], ['rotation', 4], ['velocity', 3], ['angular_velocity', 3], ['angular_momentum', 3], ['force', 3], ['torque', 3],
].map(([name, size]) => ({ name, size }));

/** A simulated moment as the channels of a recording. */
export function channelsOf(moment, mass) {
  return {
    position: moment.x, center: moment.x, rotation: moment.q, velocity: moment.p.map((p) => p / mass),
    angular_velocity: moment.w, angular_momentum: moment.l, force: moment.force, torque: moment.torque,
  };
}

export { between, columns };
