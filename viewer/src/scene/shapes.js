// One shape of FORMAT.md → a surface, the lines on it, and the radius of a ball about its origin that holds it.
// Axis of revolution along the shape's own z.

import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  CapsuleGeometry,
  ConeGeometry,
  CylinderGeometry,
  EdgesGeometry,
  Path,
  Shape,
  ShapeGeometry,
  SphereGeometry,
  TorusGeometry,
} from 'three';
import { toCreasedNormals } from 'three/addons/utils/BufferGeometryUtils.js';
import { Outline } from './outline.js';

const QUARTER = Math.PI / 2;
const AROUND = 64;
const CREASE = (35 * Math.PI) / 180;
// Finding creases hashes every corner of the mesh; beyond this many triangles the page would stutter on opening.
const MOST_CREASED = 80_000;

function ellipsoid([a, b, c]) {
  const geometry = new SphereGeometry(1, AROUND, AROUND / 2).rotateX(QUARTER).scale(a, b, c);
  const lines = new Outline()
    .arc([0, 0, 0], [a, 0, 0], [0, b, 0])
    .arc([0, 0, 0], [a, 0, 0], [0, 0, c])
    .arc([0, 0, 0], [0, b, 0], [0, 0, c]);
  return { geometry, lines, radius: Math.max(a, b, c) };
}

function cuboid([x, y, z]) {
  const geometry = new BoxGeometry(x, y, z);
  return { geometry, lines: edges(geometry), radius: Math.hypot(x, y, z) / 2 };
}

function capsule(radius, length) {
  const geometry = new CapsuleGeometry(radius, length, 16, AROUND).rotateX(QUARTER);
  const half = length / 2;
  const lines = new Outline().ring(radius, half).ring(radius, -half);
  for (const side of [[radius, 0, 0], [0, radius, 0]]) {
    const other = side.map((s) => -s);
    const bottom = [0, 0, -radius];
    lines.arc([0, 0, half], side, [0, 0, radius], 0, Math.PI).arc([0, 0, -half], side, bottom, 0, Math.PI);
    for (const [sx, sy] of [side, other]) lines.segment([sx, sy, -half], [sx, sy, half]);
  }
  return { geometry, lines, radius: half + radius };
}

function cylinder(radius, length) {
  const geometry = new CylinderGeometry(radius, radius, length, AROUND).rotateX(QUARTER);
  const h = length / 2;
  const lines = new Outline().ring(radius, h).ring(radius, -h);
  for (const side of [-radius, radius]) lines.segment([side, 0, -h], [side, 0, h]);
  for (const z of [-h, h]) lines.segment([-radius, 0, z], [radius, 0, z]);
  return { geometry, lines, radius: Math.hypot(radius, h) };
}

function cone(radius, length) {
  // The centre of mass of a solid cone lies a quarter of its height above the base.
  const geometry = new ConeGeometry(radius, length, AROUND).rotateX(QUARTER).translate(0, 0, length / 4);
  const [base, apex] = [-length / 4, (3 * length) / 4];
  const lines = new Outline().ring(radius, base);
  for (const [x, y] of [[radius, 0], [-radius, 0], [0, radius], [0, -radius]]) {
    lines.segment([x, y, base], [0, 0, apex]);
  }
  return { geometry, lines, radius: Math.max(apex, Math.hypot(radius, base)) };
}

function torus(major, minor) {
  const geometry = new TorusGeometry(major, minor, 32, 96);
  const lines = new Outline().ring(major + minor, 0).ring(major - minor, 0).ring(major, minor).ring(major, -minor);
  for (let k = 0; k < 6; k++) {
    const [c, s] = [Math.cos((k * Math.PI) / 3), Math.sin((k * Math.PI) / 3)];
    lines.arc([major * c, major * s, 0], [minor * c, minor * s, 0], [0, 0, minor]);
  }
  return { geometry, lines, radius: major + minor };
}

function mesh(positions, indices) {
  let geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
  geometry.setIndex(indices);
  const creased = indices.length / 3 <= MOST_CREASED;
  const lines = creased ? edges(geometry) : new Outline();
  if (creased) geometry = toCreasedNormals(geometry, CREASE);
  else geometry.computeVertexNormals();
  let radius = 0;
  for (let k = 0; k < positions.length; k += 3) {
    radius = Math.max(radius, Math.hypot(positions[k], positions[k + 1], positions[k + 2]));
  }
  return { geometry, lines, radius };
}

function edges(geometry) {
  const outline = new Outline();
  outline.segments = Array.from(new EdgesGeometry(geometry, 30).getAttribute('position').array);
  return outline;
}

function flat(outer, holes, lines, radius) {
  const shape = new Shape();
  shape.setFromPoints(outer);
  shape.holes = holes;
  return { geometry: new ShapeGeometry(shape), lines, radius, flat: true };
}

function circle(radius) {
  return Array.from({ length: AROUND }, (_, k) => {
    const angle = (2 * Math.PI * k) / AROUND;
    return { x: radius * Math.cos(angle), y: radius * Math.sin(angle) };
  });
}

function disc(radius) {
  const lines = new Outline().ring(radius, 0).segment([0, 0, 0], [radius, 0, 0]);
  return flat(circle(radius), [], lines, radius);
}

function ring(inner, outer) {
  const hole = new Path();
  hole.setFromPoints(circle(inner));
  const lines = new Outline().ring(inner, 0).ring(outer, 0);
  for (const [x, y] of [[1, 0], [0, 1], [-1, 0], [0, -1]]) {
    lines.segment([inner * x, inner * y, 0], [outer * x, outer * y, 0]);
  }
  return flat(circle(outer), [hole], lines, outer);
}

function polygon(points) {
  const lines = new Outline().polyline(points.map(([x, y]) => [x, y, 0]), true);
  const radius = Math.max(...points.map(([x, y]) => Math.hypot(x, y)));
  return flat(points.map(([x, y]) => ({ x, y })), [], lines, radius);
}

function rectangle([w, h]) {
  return polygon([[-w / 2, -h / 2], [w / 2, -h / 2], [w / 2, h / 2], [-w / 2, h / 2]]);
}

const BUILD = {
  sphere: (s) => ellipsoid([s.radius, s.radius, s.radius]),
  ellipsoid: (s) => ellipsoid(s.semi_axes),
  cuboid: (s) => cuboid(s.size),
  capsule: (s) => capsule(s.radius, s.length),
  cylinder: (s) => cylinder(s.radius, s.length),
  cone: (s) => cone(s.radius, s.length),
  torus: (s) => torus(s.major, s.minor),
  mesh: (s) => mesh(s.positions, s.indices),
  disc: (s) => disc(s.radius),
  rectangle: (s) => rectangle(s.size),
  polygon: (s) => polygon(s.points),
  ring: (s) => ring(s.inner, s.outer),
};

const known = new Map();

/**
 * `{ geometry, lines: Float32Array, radius, flat }`, or null for a half-space (which has no end, see ground.js)
 * and for a shape this page does not know.
 */
export function buildShape(shape) {
  const build = BUILD[shape.type];
  if (!build) return null;
  const { position, rotation, ...form } = shape;
  // Side by side recordings hold the same mesh many times; a key of its whole text would cost as much as building it.
  const key = form.type === 'mesh' ? meshKey(form) : JSON.stringify(form);
  if (!known.has(key)) {
    const built = build(shape);
    known.set(key, { ...built, lines: built.lines.toArray() });
  }
  return known.get(key);
}

function meshKey({ positions, indices }) {
  const sum = (numbers) => numbers.reduce((total, x, k) => (total * 31 + x * (k + 1)) % 1e15, 7);
  return `mesh ${positions.length} ${indices.length} ${sum(positions)} ${sum(indices)}`;
}
