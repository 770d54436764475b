// Small recordings that between them use everything the page can draw.

import { encode } from './write.mjs';
import { CHANNELS, channelsOf, columns, simulate } from './motion.mjs';

const REST = { force: [0, 0, 0], torque: [0, 0, 0], w: [0, 0, 0] };
const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);

/** A free body turning about its middle axis. */
export function racket({ label = 'pdmv6', drift = 0 } = {}) {
  const mass = 1;
  const inertia = [0.0217, 0.0833, 0.105];
  const moments = simulate({ mass, inertia, seconds: 12, state: { x: [0, 0, 0], q: [1, 0, 0, 0], p: [0, 0, 0], l: [0.0001, 0.0833 * 3, 0] } });
  const frames = moments.map((moment, k) => {
    const energy = dot(moment.w, moment.l) / 2;
    return { t: moment.t, series: [energy * (1 + drift * moment.t) + 1e-16 * (k % 5), Math.hypot(...moment.l), 1e-15 * (1 + Math.sin(k)) * (k % 7 ? 1 : 0)], bodies: [channelsOf(moment, mass)] };
  });
  return encode({
    title: 'The tennis racket flips',
    explanation: 'A body turning freely about its middle axis does not keep doing so: it turns over, again and again, while L stands still in space.',
    look_for: 'The handle flips by half a turn about every four seconds. The purple arrow L never moves; the orange arrow ω swings around it.',
    label, gravity: [0, 0, 0],
    bodies: [{ name: 'racket', kind: 'dynamic', color: null, mass, inertia, principal_rotation: [1, 0, 0, 0], shapes: [
      { type: 'cuboid', size: [1, 0.5, 0.08], position: [0, 0, 0], rotation: [1, 0, 0, 0] },
      { type: 'capsule', radius: 0.05, length: 0.45, position: [-0.72, 0, 0], rotation: [Math.SQRT1_2, 0, Math.SQRT1_2, 0] },
    ] }],
    channels: CHANNELS,
    series: [{ name: 'energy', label: 'T', unit: 'J' }, { name: 'momentum', label: '|L|', unit: 'kg·m²/s' }, { name: 'error', label: 'attitude error', unit: 'rad' }],
    plots: [
      { title: 'Kinetic energy', unit: 'J', series: ['energy'], log: false },
      { title: 'Angular momentum', unit: 'kg·m²/s', series: ['momentum'], log: false },
      { title: 'Attitude error', unit: 'rad', series: ['error'], log: true },
    ],
  }, frames);
}

/** A thrown, spinning box over a floor, with the frames of its path. */
export function projectile() {
  const mass = 2;
  const inertia = [0.05, 0.12, 0.15];
  const g = [0, 0, -9.81 * mass];
  const moments = simulate({ mass, inertia, seconds: 1.9, interval: 1 / 60, state: { x: [-3.6, 0, 0.6], q: [1, 0, 0, 0], p: [7.6, 0, 18.2], l: [0.1, 1.1, 0.4] }, load: () => ({ force: g, torque: [0, 0, 0] }) });
  const frames = moments.map((moment) => {
    const v = moment.p.map((p) => p / mass);
    const speed = Math.hypot(...v);
    const tangent = v.map((x) => x / speed);
    const normal = [tangent[2], 0, -tangent[0]];
    const straight = moment.t > 1.5;
    const body = { ...channelsOf(moment, mass), tangent, normal: straight ? [0, 0, 0] : normal, parallel: [0, 1, 0] };
    const energy = 0.5 * mass * speed ** 2 + dot(moment.w, moment.l) / 2 + mass * 9.81 * moment.x[2];
    return { t: moment.t, series: [energy, speed], bodies: [body, { ...channelsOf({ x: [0, 0, 0], q: [1, 0, 0, 0], p: [0, 0, 0], l: [0, 0, 0], ...REST }, 1), tangent: [0, 0, 0], normal: [0, 0, 0], parallel: [0, 0, 0] }] };
  });
  return encode({
    title: 'Two frames that are not one', explanation: 'The Frenet frame T, N, B belongs to the path; the axes x, y, z belong to the body. They agree only by accident.',
    look_for: 'T stays along the path while the box turns under it.', show: ['axes', 'path', 'frenet', 'velocity', 'force'],
    bodies: [
      { name: 'box', kind: 'dynamic', color: '#5f9ea8', mass, inertia, principal_rotation: [1, 0, 0, 0], shapes: [{ type: 'cuboid', size: [0.9, 0.5, 0.35] }] },
      { name: 'floor', kind: 'fixed', color: null, mass: null, inertia: null, shapes: [{ type: 'half_space', normal: [0, 0, 1] }] },
    ],
    channels: [...CHANNELS, { name: 'tangent', size: 3 }, { name: 'normal', size: 3 }, { name: 'parallel', size: 3 }],
    series: [{ name: 'energy', label: 'E', unit: 'J' }, { name: 'speed', label: 'speed', unit: 'm/s' }],
    plots: [{ title: 'Energy', unit: 'J', series: ['energy'] }, { title: 'Speed', unit: 'm/s', series: ['speed'] }],
  }, frames);
}

const TETRAHEDRON = { type: 'mesh', positions: [0.5, 0.5, 0.5, -0.5, -0.5, 0.5, -0.5, 0.5, -0.5, 0.5, -0.5, -0.5], indices: [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3] };

export const SHAPES = [
  { type: 'sphere', radius: 0.5 },
  { type: 'cuboid', size: [1, 0.7, 0.4] },
  { type: 'capsule', radius: 0.25, length: 0.6 },
  { type: 'cylinder', radius: 0.4, length: 0.7 },
  { type: 'cone', radius: 0.45, length: 0.9 },
  { type: 'ellipsoid', semi_axes: [0.6, 0.4, 0.25] },
  { type: 'torus', major: 0.4, minor: 0.14 },
  TETRAHEDRON,
  { type: 'disc', radius: 0.45 },
  { type: 'rectangle', size: [0.9, 0.6] },
  { type: 'polygon', points: [[-0.4, -0.4], [0.5, -0.3], [0.1, 0.5]] },
  { type: 'ring', inner: 0.25, outer: 0.45 },
  { type: 'half_space', normal: [0, 0, 1] },
];

/** One body a shape, in a row or (all of them) in a square, turning slowly. */
export function gallery(shapes = SHAPES, { planar = false } = {}) {
  const side = Math.ceil(Math.sqrt(shapes.length));
  const kinds = ['dynamic', 'kinematic', 'fixed'];
  const bodies = shapes.map((shape, k) => ({ name: shape.type, kind: shape.type === 'half_space' ? 'fixed' : kinds[k % 3 && shapes.length > 1 ? (k % 6 === 1 ? 1 : k % 6 === 2 ? 2 : 0) : 0], color: null, mass: 1, inertia: [1, 1, 1], shapes: [shape] }));
  const frames = Array.from({ length: 31 }, (_, f) => ({
    t: f / 15,
    bodies: shapes.map((shape, k) => {
      if (shape.type === 'half_space') return { position: [0, 0, 0], rotation: [1, 0, 0, 0] };
      const angle = f / 20;
      const axis = planar ? [0, 0, 1] : [0.6, 0.8, 0];
      const s = Math.sin(angle / 2);
      return { position: [1.5 * (k % side), 1.5 * Math.floor(k / side), planar ? 0 : 1], rotation: [Math.cos(angle / 2), ...axis.map((x) => x * s)] };
    }),
  }));
  return encode({ title: 'Every shape', bodies, planar }, frames);
}

/** A puck struck off its centre, seen face on, with a spring and an edge. */
export function puck() {
  const frames = Array.from({ length: 91 }, (_, k) => {
    const t = k / 30;
    const angle = 1.8 * t;
    const still = { rotation: [1, 0, 0, 0], velocity: [0, 0, 0], angular_velocity: [0, 0, 0], angular_momentum: [0, 0, 0], force: [0, 0, 0], torque: [0, 0, 0] };
    return { t, series: [0.5, 0.3 * t], bodies: [
      { ...still, position: [-1.4 + 0.9 * t, 0.4, 0], rotation: [Math.cos(angle / 2), 0, 0, Math.sin(angle / 2)], velocity: [0.9, 0, 0], angular_velocity: [0, 0, 1.8], angular_momentum: [0, 0, 0.2], force: [0.3, 0.2, 0] },
      { ...still, position: [0, -1, 0] },
    ] };
  });
  return encode({
    title: 'A puck struck off its centre', planar: true, explanation: 'The whole force moves the centre of mass, wherever it acts.', look_for: 'v does not depend on the offset.',
    bodies: [
      { name: 'puck', kind: 'dynamic', color: '#d98c84', mass: 1, inertia: [0.1, 0.1, 0.2], shapes: [{ type: 'disc', radius: 0.45 }, { type: 'rectangle', size: [0.2, 0.2], position: [0.2, 0, 0.001] }] },
      { name: 'edge', kind: 'fixed', color: null, mass: null, inertia: null, shapes: [{ type: 'half_space', normal: [0, 1, 0] }] },
    ],
    channels: CHANNELS,
    links: [{ kind: 'spring', a: 0, point_a: [0, 0.45, 0], b: null, point_b: [0, 2, 0] }, { kind: 'pin', a: null, point_a: [0, 2, 0], b: null, point_b: [0, 2, 0] }],
    series: [{ name: 'p', label: 'p', unit: 'kg·m/s' }, { name: 's', label: 's', unit: 'm' }],
    plots: [{ title: 'Momentum', unit: 'kg·m/s', series: ['p'] }],
  }, frames);
}

/** A pendulum and a weight, with every kind of link. */
export function links() {
  const frames = Array.from({ length: 121 }, (_, k) => {
    const t = k / 30;
    const angle = 0.7 * Math.cos(2.2 * t);
    return { t, bodies: [
      { position: [Math.sin(angle), 0, 2 - Math.cos(angle)], rotation: [Math.cos(angle / 2), 0, -Math.sin(angle / 2), 0] },
      { position: [2, 0, 1 + 0.35 * Math.sin(3 * t)], rotation: [1, 0, 0, 0] },
    ] };
  });
  const body = (name, shape) => ({ name, kind: 'dynamic', color: null, mass: 1, inertia: [1, 1, 1], shapes: [shape] });
  return encode({
    title: 'Links', gravity: [0, 0, -9.81],
    bodies: [body('bob', { type: 'sphere', radius: 0.25 }), body('weight', { type: 'cuboid', size: [0.4, 0.4, 0.4] })],
    links: [
      { kind: 'rod', a: null, point_a: [0, 0, 2], b: 0, point_b: [0, 0, 0] },
      { kind: 'pin', a: null, point_a: [0, 0, 2], b: 0, point_b: [0, 0, 1] },
      { kind: 'spring', a: null, point_a: [2, 0, 2.4], b: 1, point_b: [0, 0, 0.2] },
      { kind: 'torsion', a: null, point_a: [2, 0, 2.4], b: null, point_b: [2, 0, 2.4] },
    ],
  }, frames);
}

/** The slide's R += h [ω]× R: a matrix that leaves the rotations, or with `kept` one that does not. */
export function explicitR({ label, kept = false } = {}) {
  const w = 4;
  const frames = Array.from({ length: 151 }, (_, k) => {
    const t = k / 30;
    const angle = w * t;
    const q = [Math.cos(angle / 2), 0, 0, Math.sin(angle / 2)];
    const grow = kept ? 1 : Math.exp(0.35 * t);
    const m = columns(q, new Array(9)).map((x, i) => (i < 6 ? x * grow : x));
    return { t, series: [kept ? 0 : grow ** 2 - 1, kept ? 1 : grow ** 2], bodies: [{ position: [0, 0, 0], rotation: q, angular_velocity: [0, 0, w], angular_momentum: [0, 0, 0.8], matrix: m }] };
  });
  return encode({
    title: 'R leaves the rotations', label, explanation: 'Added step by step, R + h [ω]×R stretches the columns across ω.', look_for: 'The left body grows; the right one does not.',
    bodies: [{ name: 'block', kind: 'dynamic', color: null, mass: 1, inertia: [0.1, 0.15, 0.2], shapes: [{ type: 'cuboid', size: [1, 0.6, 0.4] }] }],
    channels: [{ name: 'position', size: 3 }, { name: 'rotation', size: 4 }, { name: 'angular_velocity', size: 3 }, { name: 'angular_momentum', size: 3 }, { name: 'matrix', size: 9 }],
    series: [{ name: 'defect', label: '‖RᵀR − 1‖', unit: '' }, { name: 'det', label: 'det R', unit: '' }],
    plots: [{ title: 'Defect of R', series: ['defect'], log: true }, { title: 'det R', series: ['det'] }],
  }, frames);
}

/** A body whose numbers end halfway, one whose matrix grows without end, and one without shapes, in one frame or several. */
export function broken({ nFrames = 20 } = {}) {
  const frames = Array.from({ length: nFrames }, (_, k) => {
    const bad = k >= nFrames / 2 && nFrames > 1;
    const x = bad ? NaN : 0.1 * k;
    const m = [10 ** k, 0, 0, 0, 10 ** k, 0, 0, 0, 1];
    const one = { rotation: [1, 0, 0, 0], angular_velocity: [0, 0, bad ? NaN : 1], matrix: [1, 0, 0, 0, 1, 0, 0, 0, 1] };
    return { t: k, series: [bad ? NaN : 1, NaN, bad ? Infinity : 0], bodies: [{ ...one, position: [x, 0, 0] }, { ...one, position: [0, 2, 0], matrix: m }, { ...one, position: [1e30 ** (k > 2), 0, 0] }] };
  });
  const cube = { type: 'cuboid', size: [1, 1, 1] };
  return encode({
    title: 'Broken',
    bodies: [
      { name: 'lost', kind: 'dynamic', mass: 1, inertia: [1, 1, 1], shapes: [cube] },
      { name: 'grown', kind: 'dynamic', mass: 1, inertia: [0, 1, 1], shapes: [cube, { type: 'shape of tomorrow' }] },
      { name: 'bare' },
    ],
    channels: [{ name: 'position', size: 3 }, { name: 'rotation', size: 4 }, { name: 'angular_velocity', size: 3 }, { name: 'matrix', size: 9 }],
    series: [{ name: 'a' }, { name: 'b' }, { name: 'c' }],
    plots: [{ title: 'a', series: ['a'] }, { title: 'b', series: ['b'], log: true }, { title: 'c', series: ['c', 'no such'], log: true }],
  }, frames);
}

/** No bodies and no frames: the page must not look as if it played something. */
export function empty() {
  return encode({ title: 'Nothing' }, []);
}
