// Unit quaternions as [w, x, y, z], world ← body, on plain arrays.

export function multiply(a, b, out) {
  const [aw, ax, ay, az] = a;
  const [bw, bx, by, bz] = b;
  out[0] = aw * bw - ax * bx - ay * by - az * bz;
  out[1] = aw * bx + ax * bw + ay * bz - az * by;
  out[2] = aw * by - ax * bz + ay * bw + az * bx;
  out[3] = aw * bz + ax * by - ay * bx + az * bw;
  return out;
}

export function conjugate(q) {
  return [q[0], -q[1], -q[2], -q[3]];
}

export function normalize(q) {
  const length = Math.hypot(...q);
  if (length > 0) for (let k = 0; k < 4; k++) q[k] /= length;
  return q;
}

/** q v q*, without building the matrix. */
export function rotate(q, v, out) {
  const [w, x, y, z] = q;
  const tx = 2 * (y * v[2] - z * v[1]);
  const ty = 2 * (z * v[0] - x * v[2]);
  const tz = 2 * (x * v[1] - y * v[0]);
  const [vx, vy, vz] = v;
  out[0] = vx + w * tx + y * tz - z * ty;
  out[1] = vy + w * ty + z * tx - x * tz;
  out[2] = vz + w * tz + x * ty - y * tx;
  return out;
}

/** Columns of the rotation matrix, one after another. */
export function columns(q, out) {
  const axis = [0, 0, 0];
  for (let k = 0; k < 3; k++) {
    axis.fill(0);
    axis[k] = 1;
    rotate(q, axis, axis);
    for (let row = 0; row < 3; row++) out[3 * k + row] = axis[row];
  }
  return out;
}

/**
 * The rotation a fraction `u` of the way from `q0` to `q1`, about a fixed world axis.
 *
 * Two poses leave the number of whole turns between them open. `turn`, the mean angular velocity times the time
 * between the two [rad], settles it: a top that turns by 300° a frame is not shown turning back by 60°.
 */
export function between(q0, q1, u, turn, out) {
  const step = multiply(q1, conjugate(q0), [0, 0, 0, 0]);
  if (step[0] < 0) for (let k = 0; k < 4; k++) step[k] = -step[k];
  const sine = Math.hypot(step[1], step[2], step[3]);
  let angle = 2 * Math.atan2(sine, step[0]);
  let axis = sine > 1e-12 ? [step[1] / sine, step[2] / sine, step[3] / sine] : [0, 0, 1];
  if (turn) {
    const size = Math.hypot(...turn);
    if (sine <= 1e-6 && size > 1) axis = turn.map((x) => x / size);
    const along = axis[0] * turn[0] + axis[1] * turn[1] + axis[2] * turn[2];
    angle += 2 * Math.PI * Math.round((along - angle) / (2 * Math.PI));
  }
  const s = Math.sin((u * angle) / 2);
  multiply([Math.cos((u * angle) / 2), axis[0] * s, axis[1] * s, axis[2] * s], q0, out);
  return normalize(out);
}
