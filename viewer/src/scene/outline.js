// Lines drawn on shapes so that a turning sphere is seen to turn: pairs of points, flat in one array.

const STEPS = 64;

export class Outline {
  constructor() {
    this.segments = [];
  }

  segment(a, b) {
    this.segments.push(...a, ...b);
    return this;
  }

  polyline(points, closed = false) {
    for (let k = 1; k < points.length; k++) this.segment(points[k - 1], points[k]);
    if (closed && points.length > 2) this.segment(points[points.length - 1], points[0]);
    return this;
  }

  /** An ellipse about `center` through `center + u` and `center + v`; from angle `from` to `to`. */
  arc(center, u, v, from = 0, to = 2 * Math.PI) {
    const n = Math.max(4, Math.round((STEPS * (to - from)) / (2 * Math.PI)));
    const points = [];
    for (let k = 0; k <= n; k++) {
      const angle = from + ((to - from) * k) / n;
      const [c, s] = [Math.cos(angle), Math.sin(angle)];
      points.push(center.map((x, i) => x + c * u[i] + s * v[i]));
    }
    return this.polyline(points);
  }

  /** A circle around the z axis. */
  ring(radius, z) {
    return this.arc([0, 0, z], [radius, 0, 0], [0, radius, 0]);
  }

  toArray() {
    return new Float32Array(this.segments);
  }
}
