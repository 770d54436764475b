// One recording as a three.js scene: built once, then moved to any time.

import { DirectionalLight, Group, HemisphereLight, Mesh, Scene, Vector3 } from 'three';
import { columns, rotate } from '../recording/rotation.js';
import { centerAt, locate, matrixAt, newPose, poseAt, vectorAt } from '../recording/sample.js';
import { Arrow, ArcArrow } from './arrow.js';
import { BodyView, MOST_GROWN } from './body.js';
import { Ground, flatten, roundBelow, shadowMaterial } from './ground.js';
import { VECTORS } from './layers.js';
import { LinkView } from './links.js';
import { Poinsot } from './poinsot.js';
import { Trace, sampleTimes } from './trace.js';
import { Triad, cross, direction } from './triad.js';

// Arrows and curves of more bodies than this would hide each other: then only the selected body has them.
const MOST_SUBJECTS = 6;
const MOST_SHADOWED = 400;
const MOST_NOTES = 3;
const MOST_CURVE_POINTS = 60_000;
/** Arrows end here even where a diverging scheme makes the vector endless. */
const LONGEST_ARROW = 4.5;

/** Length of a body axis, in units of the scene. */
const AXIS = 1.28;

/** Where a half-space lies in the first frame; they are drawn as standing still. */
function halfSpaceAt(recording, body, shape) {
  const pose = newPose();
  if (recording.nFrames) poseAt(recording, locate(recording, recording.startTime), body, pose);
  const offset = rotate(pose.rotation, shape.position ?? [0, 0, 0], [0, 0, 0]);
  const turned = rotate(shape.rotation ?? [1, 0, 0, 0], shape.normal ?? [0, 0, 1], [0, 0, 0]);
  return { point: pose.position.map((x, k) => x + offset[k]), normal: rotate(pose.rotation, turned, [0, 0, 0]) };
}

export class RecordingScene {
  constructor(recording, measure, theme) {
    this.recording = recording;
    this.measure = measure;
    this.theme = theme;
    this.scene = new Scene();
    this.farthest = 1e5 * measure.radius;
    this.lift = recording.planar ? measure.unit : 0;
    this.notes = [];
    this.growth = 1;
    this.poses = recording.bodies.map(newPose);
    this.matrices = recording.bodies.map(() => new Array(9).fill(0));
    this.extras = new Map();
    this.addLights();
    this.addGround();
    this.bodies = recording.bodies.map((body, k) => new BodyView(body, k, recording.bodies.length, theme));
    this.bodyGroup = new Group();
    for (const view of this.bodies) this.bodyGroup.add(view.group);
    this.scene.add(this.bodyGroup);
    this.links = (recording.header.links ?? []).map((link) => new LinkView(link, { unit: measure.unit, theme }));
    for (const link of this.links) {
      // Seen face on, what joins bodies and what acts on them lies in front of them.
      link.group.position.z = this.lift;
      this.bodyGroup.add(link.group);
    }
    this.addShadows();
  }

  addLights() {
    const sky = new HemisphereLight(0xffffff, this.theme.color('--bounce'), this.theme.dark ? 1.7 : 2.1);
    sky.position.set(0, 0, 1);
    const sun = new DirectionalLight(0xfff6e8, this.theme.dark ? 1.9 : 1.7);
    sun.position.set(-0.35, -0.55, 1);
    this.scene.add(sky, sun);
  }

  addGround() {
    const { recording, measure, theme } = this;
    // Without bodies there is nothing to stand on.
    if (recording.bodies.length === 0) return;
    const halfSpaces = recording.bodies.flatMap((body, k) =>
      (body.shapes ?? []).filter((shape) => shape.type === 'half_space').map((shape) => halfSpaceAt(recording, k, shape)),
    );
    this.ground = new Ground(halfSpaces, { planar: recording.planar, level: this.gridLevel(), reach: 40 * measure.radius, theme });
    this.scene.add(this.ground.group);
  }

  /** Height of the grid, relative to the origin: the world's zero when all is above it, else a round height below. */
  gridLevel() {
    const { low, radius, unit } = this.measure;
    const zero = -this.recording.origin[2];
    if (low[2] >= zero - 1e-6 * radius && low[2] - zero < 4 * radius) return zero;
    const step = roundBelow(0.5 * unit);
    return zero + Math.floor((low[2] - zero - 0.45 * unit) / step) * step;
  }

  addShadows() {
    const { recording, theme, measure } = this;
    if (recording.planar || !this.ground || recording.bodies.length > MOST_SHADOWED) return;
    this.shadows = new Group();
    this.shadows.matrixAutoUpdate = false;
    const towardsLight = new Vector3(-0.16, -0.22, 1).normalize();
    if (this.ground.shadowPlane.normal.dot(towardsLight) < 0.2) return;
    this.shadows.matrix.copy(flatten(this.ground.shadowPlane, towardsLight, 0.004 * measure.unit));
    const material = shadowMaterial(theme);
    this.casters = [];
    this.bodies.forEach((view, k) => {
      const isFloor = (recording.bodies[k].shapes ?? []).some((shape) => shape.type === 'half_space');
      if (isFloor) return;
      const group = new Group();
      group.matrixAutoUpdate = false;
      for (const mesh of view.meshes) {
        const shade = new Mesh(mesh.geometry, material);
        shade.frustumCulled = false;
        shade.renderOrder = -5;
        shade.matrixAutoUpdate = false;
        mesh.parent.updateMatrix();
        shade.matrix.copy(mesh.parent.matrix);
        group.add(shade);
      }
      this.casters.push({ view, group });
      this.shadows.add(group);
    });
    this.scene.add(this.shadows);
  }

  /** Bodies that have arrows and curves. */
  subjects(selected) {
    const moving = this.recording.bodies.map((_, k) => k).filter((k) => this.recording.bodies[k].kind !== 'fixed');
    return moving.length <= MOST_SUBJECTS ? moving : moving.filter((k) => k === selected);
  }

  /** Moves everything to time `t`. `layers` is a set of names, `selected` an index, `marked` whether it is outlined. */
  update(t, layers, selected, marked) {
    const { recording, measure } = this;
    this.notes = [];
    this.growth = 1;
    if (!recording.bodies.length || !recording.nFrames) {
      this.notes.push(`This recording holds no ${recording.bodies.length ? 'frames' : 'bodies'}`);
      return;
    }
    const at = locate(recording, t);
    const lost = new Set();
    recording.bodies.forEach((body, k) => {
      const pose = poseAt(recording, at, k, this.poses[k]);
      if (recording.has('matrix')) this.deform(at, k, pose);
      else columns(pose.rotation, this.matrices[k]);
      const layer = recording.planar ? k * 1e-3 * measure.unit : 0;
      const wrong = this.bodies[k].place(this.matrices[k], pose.position, layer, this.farthest);
      if (!wrong) return;
      lost.add(k);
      if (lost.size <= MOST_NOTES) this.notes.push(`${body.name || `body ${k + 1}`}: ${wrong}`);
    });
    for (const link of this.links) link.update((k) => this.poses[k]);
    for (const { view, group } of this.casters ?? []) {
      group.visible = view.group.visible;
      group.matrix.copy(view.group.matrix);
    }
    if (this.ground) this.ground.grid.visible = layers.has('grid');

    const subjects = this.subjects(selected).filter((k) => !lost.has(k));
    for (const [key, extra] of this.extras) {
      const [name, body] = key.split(' ');
      extra.group.visible = layers.has(name) && subjects.includes(Number(body));
    }
    const veil = layers.has('polhode') || layers.has('herpolhode');
    this.scales = veil && measure.scale.poinsot > 0 ? { ...measure.scale, omega: measure.scale.poinsot } : measure.scale;
    for (const k of subjects) {
      this.updateVectors(at, k, layers);
      this.updateFrames(at, k, layers);
      this.updateCurves(at, t, k, layers);
      const veiled = veil && this.extras.has(`polhode ${k}`);
      this.bodies[k].fade(Math.min(this.bodies[k].look.opacity, veiled ? 0.62 : 1));
    }
    this.bodies.forEach((view, k) => view.select(Boolean(marked) && k === selected));
  }

  /** The matrix of an explicit scheme in place of a rotation. `growth` is how far its columns outgrew one. */
  deform(at, body, pose) {
    const m = matrixAt(this.recording, at, body, this.matrices[body]);
    for (let c = 0; c < 3; c++) {
      const length = Math.hypot(m[3 * c], m[3 * c + 1], m[3 * c + 2]);
      if (length < MOST_GROWN) this.growth = Math.max(this.growth, length);
    }
    if (!m.some((x) => x !== 0)) columns(pose.rotation, m);
  }

  extra(name, body, make) {
    const key = `${name} ${body}`;
    if (!this.extras.has(key)) {
      const made = make();
      this.extras.set(key, made);
      this.scene.add(made.group);
    }
    return this.extras.get(key);
  }

  /** Where the arrows of a body start. */
  start(body) {
    const [x, y, z] = this.poses[body].center;
    return [x, y, z + this.lift];
  }

  get arrowStyle() {
    return { thickness: this.measure.thickness, halo: this.theme.css('--stage') };
  }

  updateVectors(at, body, layers) {
    const { recording, measure, theme, arrowStyle } = this;
    for (const { layer, channel, symbol, color, axial, arc, weight = 1.3 } of VECTORS) {
      if (!layers.has(layer) || !recording.has(channel) || !(this.scales[layer] > 0)) continue;
      const arrow = this.extra(layer, body, () => {
        const style = { ...arrowStyle, color: theme.color(color), symbol };
        if (recording.planar && axial) return new ArcArrow({ ...style, radius: arc * measure.unit });
        return new Arrow({ ...style, thickness: weight * style.thickness });
      });
      const v = vectorAt(recording, channel, at, body, [0, 0, 0]).map((x) => x * this.scales[layer]);
      const length = Math.hypot(...v);
      const longest = LONGEST_ARROW * measure.unit;
      const shown = length > longest ? v.map((x) => (x * longest) / length) : v;
      arrow.set(this.start(body), shown);
    }
  }

  updateFrames(at, body, layers) {
    const { recording, theme, measure, arrowStyle } = this;
    const center = this.start(body);
    const triad = (name, length, colors, symbols) =>
      this.extra(name, body, () => {
        const axes = colors.map((color, k) => ({ color: theme.color(color), symbol: symbols[k] }));
        return new Triad(axes, { ...arrowStyle, length: length * measure.unit });
      });
    if (layers.has('axes')) {
      const m = this.matrices[body];
      const third = recording.planar ? [0, 0, 0] : m.slice(6, 9);
      triad('axes', AXIS, ['--x', '--y', '--z'], ['x', 'y', 'z']).set(center, [m.slice(0, 3), m.slice(3, 6), third]);
    }
    if (!recording.has('tangent')) return;
    const tangent = direction(vectorAt(recording, 'tangent', at, body, [0, 0, 0]));
    const moving = tangent.some((x) => x !== 0);
    if (layers.has('frenet') && recording.has('normal')) {
      const normal = direction(vectorAt(recording, 'normal', at, body, [0, 0, 0]));
      const bends = normal.some((x) => x !== 0);
      const colors = ['--tangent', '--normal', '--binormal'];
      triad('frenet', 1.6, colors, ['T', 'N', 'B']).set(center, [tangent, normal, cross(tangent, normal)]);
      if (!moving) this.notes.push('Frenet frame undefined here: at rest');
      else if (!bends) this.notes.push('N and B undefined here: the path is straight');
    }
    if (layers.has('parallel') && recording.has('parallel')) {
      const side = direction(vectorAt(recording, 'parallel', at, body, [0, 0, 0]));
      const colors = ['--tangent', '--parallel', '--parallel'];
      triad('parallel', 1.4, colors, ['T', 'U', 'V']).set(center, [tangent, side, cross(tangent, side)]);
      if (!moving) this.notes.push('Parallel frame undefined here: at rest');
    }
  }

  updateCurves(at, t, body, layers) {
    const { recording, theme, measure } = this;
    const times = () => sampleTimes(recording, Math.min(4096, MOST_CURVE_POINTS / this.subjects(body).length));
    if (layers.has('path')) {
      this.extra('path', body, () => {
        const center = (when) => centerAt(recording, locate(recording, when), body, [0, 0, 0]);
        return new Trace(times(), center, {
          color: theme.color('--path'),
          paper: theme.color('--stage'),
          width: 2.4,
          farthest: this.farthest,
        });
      }).setTime(t);
    }
    if (layers.has('trail')) this.extra('trail', body, () => this.makeTrail(body, times())).setTime(t);
    const omega = recording.has('angular_velocity') && recording.bodies[body].inertia && !recording.planar;
    if (omega && measure.scale.poinsot > 0 && (layers.has('polhode') || layers.has('herpolhode'))) {
      const poinsot = this.extra('polhode', body, () => {
        const made = new Poinsot(recording, body, { scale: measure.scale.poinsot, farthest: this.farthest, theme });
        made.group = new Group();
        made.group.add(made.inBody, made.inSpace);
        return made;
      });
      poinsot.group.visible = true;
      const show = { polhode: layers.has('polhode'), herpolhode: layers.has('herpolhode') };
      poinsot.update(at, t, this.poses[body], show);
    }
  }

  /** Curves of the tips of the body axes. */
  makeTrail(body, times) {
    const { recording, theme, measure } = this;
    const pose = newPose();
    const m = new Array(9);
    const group = new Group();
    const traces = ['--x', '--y', '--z'].map((color, axis) => {
      const tip = (when) => {
        const at = locate(recording, when);
        poseAt(recording, at, body, pose);
        if (recording.has('matrix')) matrixAt(recording, at, body, m);
        else columns(pose.rotation, m);
        return pose.center.map((x, i) => x + AXIS * measure.unit * m[3 * axis + i]);
      };
      const trace = new Trace(times, tip, { color: theme.color(color), width: 1.6, farthest: this.farthest });
      group.add(trace.group);
      return trace;
    });
    return { group, setTime: (t) => traces.forEach((trace) => trace.setTime(t)) };
  }

  /** Hides all but bodies and links, to measure whether they are seen at all. Returns what puts it back. */
  bareBodies() {
    const others = this.scene.children.filter((child) => !child.isLight && child !== this.bodyGroup);
    const before = others.map((child) => child.visible);
    for (const child of others) child.visible = false;
    return () => others.forEach((child, k) => (child.visible = before[k]));
  }

  dispose() {
    this.scene.traverse((node) => {
      for (const material of [node.material].flat()) material?.dispose();
    });
  }
}
