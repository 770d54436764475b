// Poinsot's picture of free rotation. The energy ellipsoid Σ I_i ω_i² = 2T, fixed in the body, rolls without slipping
// on the invariable plane ω·L = 2T, fixed in space: the tip of ω is the point of contact. It draws the polhode on the
// ellipsoid and the herpolhode on the plane.
//
// All is drawn in the scale of the ω arrow [m per rad/s], about the centre of mass.

import { CircleGeometry, DoubleSide, Group, Mesh, MeshBasicMaterial, MeshStandardMaterial, SphereGeometry } from 'three';
import { locate, principalOmega, vectorAt } from '../recording/sample.js';
import { multiply, normalize } from '../recording/rotation.js';
import { Trace, sampleTimes } from './trace.js';
import { Outline } from './outline.js';
import { segments } from './strokes.js';

const BALL = new SphereGeometry(1, 64, 32);
const PLATE = new CircleGeometry(1, 96);

function rings() {
  return new Outline()
    .arc([0, 0, 0], [1, 0, 0], [0, 1, 0])
    .arc([0, 0, 0], [1, 0, 0], [0, 0, 1])
    .arc([0, 0, 0], [0, 1, 0], [0, 0, 1])
    .toArray();
}

export class Poinsot {
  /** For a body with inertia in a recording with angular velocity. `scale` [m per rad/s]. */
  constructor(recording, body, { scale, farthest, theme }) {
    this.recording = recording;
    this.body = body;
    this.scale = scale;
    this.inertia = recording.bodies[body].inertia;
    const times = sampleTimes(recording);
    const omega = [0, 0, 0];

    this.inBody = new Group();
    this.ellipsoid = new Group();
    const skin = new MeshStandardMaterial({
      color: theme.color('--ellipsoid'),
      transparent: true,
      opacity: 0.13,
      roughness: 0.6,
      depthWrite: false,
      side: DoubleSide,
    });
    this.ellipsoid.add(new Mesh(BALL, skin));
    this.ellipsoid.add(segments(rings(), { color: theme.color('--ellipsoid'), width: 1, opacity: 0.55 }));
    this.polhode = new Trace(
      times,
      (t) => principalOmega(recording, locate(recording, t), body, omega).map((w) => w * scale),
      { color: theme.color('--omega'), paper: theme.color('--stage'), width: 3, farthest },
    );
    this.inBody.add(this.ellipsoid, this.polhode.group);

    this.inSpace = new Group();
    this.herpolhode = new Trace(
      times,
      (t) => vectorAt(recording, 'angular_velocity', locate(recording, t), body, omega).map((w) => w * scale),
      { color: theme.color('--herpolhode'), width: 2.4, farthest },
    );
    const plate = { color: theme.color('--momentum'), transparent: true, depthWrite: false, side: DoubleSide };
    this.plane = new Mesh(PLATE, new MeshBasicMaterial({ ...plate, opacity: theme.dark ? 0.2 : 0.13 }));
    this.inSpace.add(this.herpolhode.group, this.plane);
  }

  /** `pose` as sampled at `at`; `show` says which half is wanted. */
  update(at, t, pose, show) {
    const { recording, body, inertia, scale } = this;
    const w = principalOmega(recording, at, body, [0, 0, 0]);
    const twice = inertia[0] * w[0] ** 2 + inertia[1] * w[1] ** 2 + inertia[2] * w[2] ** 2;
    const l = inertia.map((moment, k) => moment * w[k]);
    const size = Math.hypot(...l);
    const drawable = twice > 0 && Number.isFinite(twice) && size > 0;
    this.inBody.visible = show.polhode && drawable;
    this.inSpace.visible = show.herpolhode && drawable;
    if (!drawable) return;

    const principal = normalize(
      multiply(pose.rotation, recording.bodies[body].principal_rotation ?? [1, 0, 0, 0], [0, 0, 0, 0]),
    );
    this.inBody.position.set(...pose.center);
    this.inBody.quaternion.set(principal[1], principal[2], principal[3], principal[0]);
    // A thin rod has no moment about its axis: its ellipsoid is a long cylinder, drawn with an end.
    const most = 40 * Math.hypot(...w);
    this.ellipsoid.scale.set(...inertia.map((moment) => scale * Math.min(most, Math.sqrt(twice / moment))));
    this.polhode.setTime(t);

    this.inSpace.position.set(...pose.center);
    this.herpolhode.setTime(t);
    const { x, y, z } = this.plane.position.set(...l).applyQuaternion(this.inBody.quaternion).divideScalar(size);
    this.plane.quaternion.setFromUnitVectors(this.plane.up.set(0, 0, 1), this.plane.position);
    const height = (scale * twice) / size;
    this.plane.position.set(x * height, y * height, z * height);
    const reach = scale * Math.sqrt(Math.max(0, Math.hypot(...w) ** 2 - (twice / size) ** 2));
    this.plane.scale.setScalar(Math.max(1.6 * reach, 0.9 * height));
  }
}
