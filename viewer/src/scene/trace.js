// A curve drawn by a moving point: what lies behind is strong, what is to come is faint.

import { Group } from 'three';
import { curve } from './strokes.js';

const MOST_POINTS = 4096;

/** Times at which a curve is sampled: up to four points a frame, so that arcs look round. */
export function sampleTimes(recording, most = MOST_POINTS) {
  const { times, nFrames } = recording;
  if (nFrames < 2) return Array.from(times);
  const split = Math.max(1, Math.min(4, Math.floor(most / nFrames)));
  const stride = Math.max(1, Math.ceil(nFrames / most));
  const out = [];
  for (let frame = 0; frame < nFrames - 1; frame += stride) {
    for (let k = 0; k < split; k++) out.push(times[frame] + ((times[frame + 1] - times[frame]) * k) / split);
  }
  out.push(times[nFrames - 1]);
  return out;
}

export class Trace {
  /**
   * @param {number[]} times increasing
   * @param {(t: number) => number[]} pointAt where the pen is; a point that is `farthest` away or not finite ends the curve
   * @param {{color, paper?, width?: number, farthest: number}} style with `paper`, the colour behind, what is to come is drawn too
   */
  constructor(times, pointAt, { color, paper, width = 2.2, farthest }) {
    this.group = new Group();
    this.times = [];
    const points = [];
    for (const t of times) {
      const point = pointAt(t);
      if (!point.every((x) => Math.abs(x) < farthest)) break;
      this.times.push(t);
      points.push(...point);
    }
    if (this.times.length < 2) return;
    this.past = curve(points, { color, width });
    this.past.frustumCulled = false;
    this.group.add(this.past);
    // From the end backwards, so that it too can be cut at any time. Mixed with the paper and not translucent: pieces of a fat line overlap, and would show as a row of dots.
    if (paper) {
      const reversed = [];
      for (let k = points.length - 3; k >= 0; k -= 3) reversed.push(points[k], points[k + 1], points[k + 2]);
      this.future = curve(reversed, { color: color.clone().lerp(paper, 0.6), width: 0.7 * width });
      this.future.frustumCulled = false;
      // A closed orbit comes back to where it was: what was drawn stays in front.
      Object.assign(this.future.material, { polygonOffset: true, polygonOffsetFactor: 4, polygonOffsetUnits: 200 });
      this.group.add(this.future);
    }
  }

  setTime(t) {
    if (!this.past) return;
    let low = 0;
    let high = this.times.length - 1;
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.times[middle] <= t) low = middle;
      else high = middle - 1;
    }
    // One instance is one piece between two points.
    this.past.geometry.instanceCount = low;
    this.past.visible = low > 0;
    if (this.future) this.future.geometry.instanceCount = this.times.length - 1 - low;
  }
}
