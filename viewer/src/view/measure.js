// How large the scene is, where it is, and how long arrows should be: the same for all recordings of the page, so that
// what is side by side is drawn to one scale.

import { bodyRadius } from '../scene/body.js';
import { principalOmega } from '../recording/sample.js';
import { VECTORS } from '../scene/layers.js';

const LOOKS = 240;

function median(numbers) {
  if (!numbers.length) return 0;
  const sorted = [...numbers].sort((a, b) => a - b);
  return sorted[sorted.length >> 1];
}

function sampleFrames(recording) {
  const count = Math.min(LOOKS, recording.nFrames);
  return Array.from({ length: count }, (_, k) =>
    count === 1 ? 0 : Math.round((k * (recording.nFrames - 1)) / (count - 1)),
  );
}

/** Points the camera should see, with the radius of the body there. */
function gather(recording) {
  const radii = recording.bodies.map(bodyRadius);
  const found = [];
  for (const frame of sampleFrames(recording)) {
    recording.bodies.forEach((body, k) => {
      const endless = !radii[k] && (body.shapes ?? []).some((shape) => shape.type === 'half_space');
      if (endless) return;
      const point = recording.read('position', frame, k, [0, 0, 0]);
      if (point.every(Number.isFinite)) found.push({ point, radius: radii[k], moving: body.kind !== 'fixed', first: frame === 0 });
    });
  }
  for (const link of recording.header.links ?? []) {
    for (const [body, point] of [[link.a, link.point_a], [link.b, link.point_b]]) {
      if (body === null || body === undefined) found.push({ point, radius: 0, moving: false, first: true });
    }
  }
  return found;
}

// A scheme that diverges ends at 10³⁰ m. No scene grows by this factor from its first frame.
const MOST_SPREAD = 1e5;

/** Drops what flew away: points farther from the middle than three times the distance that nine tenths keep. */
function withoutOutliers(all) {
  const starts = all.filter(({ first }) => first);
  const start = Math.max(0, ...starts.map(({ point, radius }) => Math.hypot(...point) + radius)) || 1;
  const found = all.filter(({ point }) => Math.hypot(...point) < MOST_SPREAD * start);
  const middle = [0, 1, 2].map((k) => median(found.map(({ point }) => point[k])));
  const far = ({ point }) => Math.hypot(...point.map((x, k) => x - middle[k]));
  const distances = found.map(far).sort((a, b) => a - b);
  const usual = distances[Math.floor(0.9 * (distances.length - 1))] ?? 0;
  return found.filter((one) => one.first || far(one) <= 3 * usual + one.radius);
}

/** The length an arrow of ordinary size stands for: a vector much larger now and then does not shrink all others. */
function ordinary(recordings, channel) {
  let most = 0;
  const v = [0, 0, 0];
  for (const recording of recordings) {
    if (!recording.has(channel)) continue;
    const peaks = sampleFrames(recording).map((frame) =>
      recording.bodies.reduce((peak, _, body) => Math.max(peak, Math.hypot(...recording.read(channel, frame, body, v)) || 0), 0),
    );
    const finite = peaks.filter((x) => Number.isFinite(x));
    most = Math.max(most, median(finite));
    if (most === 0) most = Math.max(0, ...finite);
  }
  return most || Math.max(0, ...recordings.map((recording) => recording.largest(channel)));
}

function turnsAtAll(recording) {
  const q = [1, 0, 0, 0];
  return recording.bodies.some((body, k) => {
    if (body.kind === 'fixed' || !recording.nFrames) return false;
    const start = recording.read('rotation', 0, k, [1, 0, 0, 0]);
    return sampleFrames(recording).some((frame) => {
      recording.read('rotation', frame, k, q);
      return Math.abs(q.reduce((sum, x, i) => sum + x * start[i], 0)) < 1 - 1e-5;
    });
  });
}

/**
 * `{ center, radius, low, unit, travels, turns, scale }`: lengths in metres relative to the recordings' origin;
 * `unit`, the size of arrows, is the radius of an ordinary moving body, or more where that would be a dot in the whole
 * scene (not when `near`: the camera is with the body); `thickness` is
 * the radius of their shafts; `scale[layer]` is the metres drawn per unit of a vector.
 */
export function measure(recordings, near = false) {
  const found = recordings.flatMap((recording) => withoutOutliers(gather(recording)));
  const low = [0, 1, 2].map((k) => Math.min(...found.map(({ point, radius }) => point[k] - radius)));
  const high = [0, 1, 2].map((k) => Math.max(...found.map(({ point, radius }) => point[k] + radius)));
  if (!found.length) low.fill(-1) && high.fill(1);
  const center = low.map((x, k) => (x + high[k]) / 2);
  const sizes = found.filter(({ moving, radius }) => moving && radius > 0).map(({ radius }) => radius);
  const biggest = Math.max(0, ...found.filter(({ moving }) => moving).map(({ radius }) => radius));
  let radius = Math.hypot(...high.map((x, k) => x - low[k])) / 2;
  if (!(radius > 0)) radius = 1;
  const body = median(sizes) || biggest || radius / 2;
  const unit = near ? body : Math.max(body, 0.08 * radius);
  const scale = {};
  for (const { layer, channel, length } of VECTORS) {
    const size = ordinary(recordings, channel);
    scale[layer] = size > 0 ? (length * unit) / size : 0;
  }
  // ω ends on the energy ellipsoid. A long ellipsoid would leave the view: while it is shown, both are drawn smaller.
  const longest = longestSemiAxis(recordings);
  scale.poinsot = longest > 0 ? Math.max(0.65 * scale.omega, Math.min(scale.omega, (1.7 * unit) / longest)) : 0;
  return {
    center,
    low,
    ellipsoid: scale.poinsot * longest,
    radius: Math.max(radius, 1.35 * unit),
    spheres: toShow(found, center, unit),
    unit,
    thickness: Math.max(0.018 * unit, near ? 0 : 0.0035 * radius),
    scale,
    travels: recordings.some((recording) => recording.bodies.some((b, k) => b.kind !== 'fixed' && wanders(recording, k, body))),
    turns: recordings.some(turnsAtAll),
  };
}

/** The longest semi-axis of an energy ellipsoid, √(2T / least moment) [rad/s]; 0 where there is none. */
function longestSemiAxis(recordings) {
  let most = 0;
  for (const recording of recordings) {
    if (recording.planar || !recording.has('angular_velocity')) continue;
    recording.bodies.forEach(({ inertia, kind }, body) => {
      if (kind === 'fixed' || !inertia || !(Math.min(...inertia) > 0)) return;
      const axes = sampleFrames(recording).map((frame) => {
        const w = principalOmega(recording, { frame, next: frame, u: 0, dt: 0 }, body, [0, 0, 0]);
        const twice = inertia.reduce((sum, moment, k) => sum + moment * w[k] ** 2, 0);
        return Math.sqrt(twice / Math.min(...inertia));
      });
      most = Math.max(most, median(axes.filter(Number.isFinite)));
    });
  }
  return most;
}

/** What the first view must hold: bodies wherever they go, with room for the arrows on moving ones. */
function toShow(found, center, unit) {
  if (!found.length) return [{ point: center, radius: 1 }];
  // Every body where it starts, and of the rest one in so many: by the golden ratio, which no number of bodies divides.
  const stride = Math.ceil(found.length / 1500);
  return found
    .filter(({ first }, k) => first || ((k * 0.6180339887498949) % 1) * stride < 1)
    .map(({ point, radius, moving }) => ({ point, radius: moving ? Math.max(radius, 1.32 * unit) : radius }));
}

function wanders(recording, body, size) {
  const start = recording.nFrames ? recording.read(recording.centerChannel, 0, body, [0, 0, 0]) : [0, 0, 0];
  const now = [0, 0, 0];
  return sampleFrames(recording).some((frame) => {
    recording.read(recording.centerChannel, frame, body, now);
    return Math.hypot(...now.map((x, k) => x - start[k])) > 0.05 * size;
  });
}
