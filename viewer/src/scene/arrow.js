// A vector drawn as an arrow; in a planar scene, a vector along z drawn as an arc that turns the way it points.

import {
  BufferAttribute,
  BufferGeometry,
  ConeGeometry,
  CylinderGeometry,
  DynamicDrawUsage,
  GreaterDepth,
  Group,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  DoubleSide,
  Vector3,
} from 'three';
import { label } from './label.js';

const SHAFT = new CylinderGeometry(1, 1, 1, 16).rotateX(Math.PI / 2).translate(0, 0, 0.5);
const HEAD = new ConeGeometry(1, 1, 20).rotateX(Math.PI / 2).translate(0, 0, -0.5);
const Z = new Vector3(0, 0, 1);

export class Arrow {
  /** @param {number} thickness radius of the shaft [m] */
  constructor({ color, symbol, thickness, halo }) {
    this.group = new Group();
    this.thickness = thickness;
    const material = new MeshLambertMaterial({ color, emissive: color, emissiveIntensity: 0.35 });
    this.shaft = new Mesh(SHAFT, material);
    this.head = new Mesh(HEAD, material);
    // What a body hides of the arrow shines through it.
    const ghost = new MeshBasicMaterial({ color, transparent: true, opacity: 0.3, depthFunc: GreaterDepth, depthWrite: false });
    for (const part of [this.shaft, this.head]) {
      const hidden = new Mesh(part.geometry, ghost);
      hidden.renderOrder = 15;
      part.add(hidden);
    }
    this.group.add(this.shaft, this.head);
    if (symbol) {
      this.label = label(symbol, color, halo);
      this.group.add(this.label);
    }
  }

  /** From `origin`, along `vector` (metres on the screen). False and hidden where there is nothing to draw. */
  set(origin, vector) {
    const length = Math.hypot(...vector);
    const shown = length > 0.5 * this.thickness && Number.isFinite(length) && origin.every(Number.isFinite);
    this.group.visible = shown;
    if (!shown) return false;
    const head = Math.min(6.5 * this.thickness, 0.45 * length);
    const width = Math.min(1, head / (6.5 * this.thickness));
    this.group.position.set(...origin);
    this.group.quaternion.setFromUnitVectors(Z, new Vector3(...vector).divideScalar(length));
    this.shaft.scale.set(this.thickness * width, this.thickness * width, length - 0.9 * head);
    this.head.scale.set(2.6 * this.thickness * width, 2.6 * this.thickness * width, head);
    this.head.position.z = length;
    if (this.label) this.label.position.set(0, 0, length + 4 * this.thickness);
    return true;
  }
}

const ARC_STEPS = 48;

export class ArcArrow {
  /** @param {number} radius of the arc [m]; its angle shows the magnitude */
  constructor({ color, symbol, thickness, halo, radius }) {
    this.group = new Group();
    this.radius = radius;
    this.thickness = thickness;
    const geometry = new BufferGeometry();
    this.corners = new BufferAttribute(new Float32Array(3 * (2 * (ARC_STEPS + 1) + 3)), 3);
    this.corners.setUsage(DynamicDrawUsage);
    geometry.setAttribute('position', this.corners);
    geometry.setIndex(arcIndex());
    this.band = new Mesh(geometry, new MeshBasicMaterial({ color, side: DoubleSide, toneMapped: false }));
    this.band.frustumCulled = false;
    this.group.add(this.band);
    if (symbol) {
      this.label = label(symbol, color, halo);
      this.group.add(this.label);
    }
  }

  /** `turn`: the length an arrow would have, in radii of the arc; its sign is that of z. */
  set(origin, vector) {
    const turn = Math.max(-5.2, Math.min(5.2, (2 * vector[2]) / this.radius));
    this.group.visible = Math.abs(turn) > 0.01 && origin.every(Number.isFinite);
    if (!this.group.visible) return false;
    this.group.position.set(...origin);
    const head = Math.sign(turn) * Math.min(0.35, Math.abs(turn) * 0.5);
    const at = (k, r, angle) => this.corners.setXYZ(k, r * Math.cos(angle), r * Math.sin(angle), 0);
    for (let k = 0; k <= ARC_STEPS; k++) {
      const angle = ((turn - head) * k) / ARC_STEPS;
      at(2 * k, this.radius - this.thickness, angle);
      at(2 * k + 1, this.radius + this.thickness, angle);
    }
    const tip = 2 * (ARC_STEPS + 1);
    at(tip, this.radius - 3.4 * this.thickness, turn - head);
    at(tip + 1, this.radius + 3.4 * this.thickness, turn - head);
    at(tip + 2, this.radius, turn);
    this.corners.needsUpdate = true;
    if (this.label) {
      const out = this.radius + 6 * this.thickness;
      this.label.position.set(out * Math.cos(turn), out * Math.sin(turn), 0);
    }
    return true;
  }
}

function arcIndex() {
  const index = [];
  for (let k = 0; k < ARC_STEPS; k++) {
    const a = 2 * k;
    index.push(a, a + 1, a + 2, a + 1, a + 3, a + 2);
  }
  const tip = 2 * (ARC_STEPS + 1);
  index.push(tip, tip + 1, tip + 2);
  return index;
}
