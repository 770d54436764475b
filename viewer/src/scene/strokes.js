// Lines with a width in pixels, at any distance and on any screen.

import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';
import { Line2 } from 'three/addons/lines/Line2.js';
import { LineGeometry } from 'three/addons/lines/LineGeometry.js';

function material(color, width, opacity, dashed) {
  return new LineMaterial({
    color,
    linewidth: width,
    opacity,
    transparent: opacity < 1,
    depthWrite: opacity >= 1,
    dashed: Boolean(dashed),
    dashSize: dashed || 1,
    gapSize: (dashed || 1) * 0.7,
  });
}

/** Separate segments: pairs of points, flat. `dashed` is the dash length in metres, or 0. */
export function segments(points, { color, width = 1.5, opacity = 1, dashed = 0 }) {
  const geometry = new LineSegmentsGeometry();
  geometry.setPositions(points);
  const line = new LineSegments2(geometry, material(color, width, opacity, dashed));
  if (dashed) line.computeLineDistances();
  return line;
}

/** A curve through all points, flat. */
export function curve(points, { color, width = 2, opacity = 1 }) {
  const geometry = new LineGeometry();
  geometry.setPositions(points);
  return new Line2(geometry, material(color, width, opacity, 0));
}
