// The recording between its frames: where everything is at any time t.

import { between, conjugate, multiply, normalize, rotate, columns } from './rotation.js';

/** The last frame at or before `t`, and how far `t` is on the way to the next one (0…1). */
export function locate(recording, t) {
  const { times, nFrames } = recording;
  if (nFrames === 0) return { frame: 0, next: 0, u: 0, dt: 0 };
  let low = 0;
  let high = nFrames - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle] <= t) low = middle;
    else high = middle - 1;
  }
  const next = Math.min(low + 1, nFrames - 1);
  const dt = times[next] - times[low];
  const u = dt > 0 ? Math.min(1, Math.max(0, (t - times[low]) / dt)) : 0;
  return { frame: low, next, u, dt };
}

/** A vector channel, linear between frames. */
export function vectorAt(recording, channel, at, body, out) {
  recording.read(channel, at.frame, body, out);
  if (at.u === 0) return out;
  const b = recording.read(channel, at.next, body, scratch(out.length));
  for (let k = 0; k < out.length; k++) out[k] += at.u * (b[k] - out[k]);
  return out;
}

const SCRATCH = new Map();
function scratch(n) {
  if (!SCRATCH.has(n)) SCRATCH.set(n, new Array(n).fill(0));
  return SCRATCH.get(n);
}

export function rotationAt(recording, at, body, out) {
  recording.read('rotation', at.frame, body, out);
  if (at.u === 0) return normalize(out);
  const q1 = recording.read('rotation', at.next, body, [0, 0, 0, 0]);
  let turn = null;
  if (recording.has('angular_velocity')) {
    const a = recording.read('angular_velocity', at.frame, body, [0, 0, 0]);
    const b = recording.read('angular_velocity', at.next, body, [0, 0, 0]);
    turn = a.map((x, k) => 0.5 * at.dt * (x + b[k]));
    if (!turn.every(Number.isFinite)) turn = null;
  }
  return between(normalize([...out]), normalize(q1), at.u, turn, out);
}

/** The centre of mass: a cubic through both frames where the recorded velocities agree with it, else a straight line. */
export function centerAt(recording, at, body, out) {
  const channel = recording.centerChannel;
  vectorAt(recording, channel, at, body, out);
  if (at.u === 0 || !recording.has('velocity')) return out;
  const x0 = recording.read(channel, at.frame, body, [0, 0, 0]);
  const x1 = recording.read(channel, at.next, body, [0, 0, 0]);
  const v0 = recording.read('velocity', at.frame, body, [0, 0, 0]);
  const v1 = recording.read('velocity', at.next, body, [0, 0, 0]);
  const way = x1.map((x, k) => x - x0[k]);
  const mismatch = Math.hypot(...way.map((d, k) => d - 0.5 * at.dt * (v0[k] + v1[k])));
  // A kick inside the interval makes the end velocities wrong for a cubic: it would swing past the corner.
  if (!(mismatch <= 0.1 * Math.hypot(...way))) return out;
  const u = at.u;
  const h = u * (1 - u);
  for (let k = 0; k < 3; k++) {
    out[k] += h * ((1 - u) * (at.dt * v0[k] - way[k]) - u * (at.dt * v1[k] - way[k]));
  }
  return out;
}

/**
 * The pose of a body: `center`, `position` (origin of the body frame) and `rotation`.
 * The centre of mass moves smoothly while the body's origin may whirl about it, so the origin follows from the centre.
 */
export function poseAt(recording, at, body, out) {
  rotationAt(recording, at, body, out.rotation);
  if (!recording.has('center')) {
    centerAt(recording, at, body, out.center);
    for (let k = 0; k < 3; k++) out.position[k] = out.center[k];
    return out;
  }
  centerAt(recording, at, body, out.center);
  const offset = centerInBody(recording, at.frame, body);
  const offsetNext = at.u === 0 ? offset : centerInBody(recording, at.next, body);
  rotate(out.rotation, offset.map((a, k) => a + at.u * (offsetNext[k] - a)), out.position);
  for (let k = 0; k < 3; k++) out.position[k] = out.center[k] - out.position[k];
  return out;
}

export function newPose() {
  return { center: [0, 0, 0], position: [0, 0, 0], rotation: [1, 0, 0, 0] };
}

/** The centre of mass in body axes; constant for a rigid body. */
export function centerInBody(recording, frame, body) {
  const center = recording.read(recording.centerChannel, frame, body, [0, 0, 0]);
  const origin = recording.read('position', frame, body, [0, 0, 0]);
  const q = normalize(recording.read('rotation', frame, body, [1, 0, 0, 0]));
  return rotate(conjugate(q), center.map((x, k) => x - origin[k]), [0, 0, 0]);
}

/** ω in principal axes, where the inertia tensor is diagonal. */
export function principalOmega(recording, at, body, out) {
  vectorAt(recording, 'angular_velocity', at, body, out);
  const q = rotationAt(recording, at, body, [1, 0, 0, 0]);
  const principal = multiply(q, recording.bodies[body].principal_rotation ?? [1, 0, 0, 0], [0, 0, 0, 0]);
  return rotate(conjugate(normalize(principal)), out, out);
}

/**
 * The 3×3 matrix an explicit scheme keeps in place of a rotation, as columns.
 * Linear interpolation of the columns themselves would shrink a turning body between frames, so what is interpolated
 * linearly is the deformation seen from the body.
 */
export function matrixAt(recording, at, body, out) {
  recording.read('matrix', at.frame, body, out);
  if (at.u === 0) return out;
  const a = deformation(recording, at.frame, body);
  const b = deformation(recording, at.next, body);
  const r = columns(rotationAt(recording, at, body, [1, 0, 0, 0]), new Array(9));
  for (let column = 0; column < 3; column++) {
    for (let row = 0; row < 3; row++) {
      let sum = 0;
      for (let k = 0; k < 3; k++) {
        const entry = a[3 * column + k] + at.u * (b[3 * column + k] - a[3 * column + k]);
        sum += r[3 * k + row] * entry;
      }
      out[3 * column + row] = sum;
    }
  }
  return out;
}

function deformation(recording, frame, body) {
  const m = recording.read('matrix', frame, body, new Array(9));
  const q = conjugate(normalize(recording.read('rotation', frame, body, [1, 0, 0, 0])));
  const out = new Array(9);
  for (let column = 0; column < 3; column++) {
    const image = rotate(q, m.slice(3 * column, 3 * column + 3), [0, 0, 0]);
    for (let row = 0; row < 3; row++) out[3 * column + row] = image[row];
  }
  return out;
}
