// Springs as coils, torsion springs as spirals, pins as small balls, rods as lines.

import { Group, Mesh, MeshStandardMaterial, SphereGeometry, Vector3 } from 'three';
import { rotate } from '../recording/rotation.js';
import { curve } from './strokes.js';

const Z = new Vector3(0, 0, 1);
const BALL = new SphereGeometry(1, 24, 16);
const TURNS = 9;

/** A coil of radius 1 around z from 0 to 1, with straight ends: stretching it scales only its pitch. */
function coil() {
  const points = [0, 0, 0, 0, 0, 0.08];
  for (let k = 0; k <= TURNS * 24; k++) {
    const angle = (2 * Math.PI * k) / 24;
    points.push(Math.cos(angle), Math.sin(angle), 0.1 + (0.8 * k) / (TURNS * 24));
  }
  points.push(0, 0, 0.92, 0, 0, 1);
  return points;
}

function spiral() {
  const points = [];
  for (let k = 0; k < 96; k++) {
    const angle = (6 * Math.PI * k) / 95;
    const r = 0.12 + (0.88 * k) / 95;
    points.push(r * Math.cos(angle), r * Math.sin(angle), 0);
  }
  return points;
}

export class LinkView {
  constructor(link, { unit, theme }) {
    this.link = link;
    this.unit = unit;
    this.group = new Group();
    const color = theme.color('--link');
    const stroke = (points, width) => {
      const line = curve(points, { color, width });
      line.frustumCulled = false;
      this.group.add(line);
      return line;
    };
    if (link.kind === 'spring') this.along = stroke(coil(), 2.2);
    if (link.kind === 'rod') this.along = stroke([0, 0, 0, 0, 0, 1], 3);
    if (link.kind === 'torsion') this.spiral = stroke(spiral(), 2.2);
    const material = new MeshStandardMaterial({ color, roughness: 0.5 });
    this.ends = [0, 1].map(() => new Mesh(BALL, material));
    this.group.add(...this.ends);
  }

  /** `poseOf(index)` gives a body's pose; null stands for the world. */
  update(poseOf) {
    const a = this.end(this.link.a, this.link.point_a, poseOf);
    const b = this.end(this.link.b, this.link.point_b, poseOf);
    this.group.visible = [...a, ...b].every(Number.isFinite);
    if (!this.group.visible) return;
    const from = new Vector3(...a);
    const to = new Vector3(...b);
    const way = to.clone().sub(from);
    const length = way.length();
    const ball = (this.link.kind === 'pin' ? 0.06 : 0.03) * this.unit;
    this.ends.forEach((end, k) => {
      end.position.copy(k ? to : from);
      end.scale.setScalar(ball);
    });
    if (this.along) {
      this.along.position.copy(from);
      this.along.quaternion.setFromUnitVectors(Z, length > 0 ? way.divideScalar(length) : Z);
      const across = 0.085 * this.unit;
      this.along.scale.set(across, across, Math.max(length, 1e-9));
    }
    if (this.spiral) {
      this.spiral.position.copy(from);
      this.spiral.scale.setScalar(0.2 * this.unit);
    }
  }

  end(body, point, poseOf) {
    if (body === null || body === undefined) return point;
    const pose = poseOf(body);
    return rotate(pose.rotation, point, [0, 0, 0]).map((x, k) => x + pose.position[k]);
  }
}
