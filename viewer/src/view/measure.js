// How large the scene is, where it is, and how long arrows should be. Shared by all recordings of the page, so that
// what is side by side is drawn to one scale.

import { bodyRadius } from '../scene/body.js';
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

/** Drops what flew away: points farther from the middle than three times the distance that nine tenths keep. */
function withoutOutliers(found) {
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
 * `unit` is the radius of an ordinary moving body, `scale[layer]` the metres drawn per unit of a vector.
 */
export function measure(recordings) {
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
  const unit = Math.max(body, 0.05 * radius);
  const spread = found.filter(({ moving }) => moving).map(({ point }) => point);
  const span = [0, 1, 2].map((k) => Math.max(...spread.map((p) => p[k])) - Math.min(...spread.map((p) => p[k])));
  const scale = {};
  for (const { layer, channel } of VECTORS) {
    const size = ordinary(recordings, channel);
    scale[layer] = size > 0 ? (1.45 * unit) / size : 0;
  }
  return {
    center,
    low,
    radius: Math.max(radius, 1.35 * unit),
    unit,
    scale,
    travels: recordings.some((recording) => recording.bodies.some((b, k) => b.kind !== 'fixed' && wanders(recording, k, body))),
    turns: recordings.some(turnsAtAll),
    // A body small against its way is a dot when all is in view: the camera goes with it.
    follow: spread.length > 0 && Math.hypot(...span) > 40 * body,
  };
}

function wanders(recording, body, size) {
  const start = recording.nFrames ? recording.read(recording.centerChannel, 0, body, [0, 0, 0]) : [0, 0, 0];
  const now = [0, 0, 0];
  return sampleFrames(recording).some((frame) => {
    recording.read(recording.centerChannel, frame, body, now);
    return Math.hypot(...now.map((x, k) => x - start[k])) > 0.05 * size;
  });
}
