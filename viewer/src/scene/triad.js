// Three arrows from one point: the body's axes, the Frenet frame, the parallel frame.

import { Group } from 'three';
import { Arrow } from './arrow.js';

export class Triad {
  /** @param {{color, symbol}[]} axes three of them */
  constructor(axes, { length, thickness, halo }) {
    this.group = new Group();
    this.length = length;
    this.arrows = axes.map(({ color, symbol }) => new Arrow({ color, symbol, thickness, halo }));
    for (const arrow of this.arrows) this.group.add(arrow.group);
  }

  /** @param {number[][]} vectors three world vectors; one that is zero or not finite is not drawn */
  set(origin, vectors) {
    this.arrows.forEach((arrow, k) => arrow.set(origin, vectors[k].map((x) => x * this.length)));
  }
}

export function cross(a, b) {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

/** Two directions, one frame after the other: normalised, or zero when there is none. */
export function direction(v) {
  const length = Math.hypot(...v);
  return length > 0.5 ? v.map((x) => x / length) : [0, 0, 0];
}
