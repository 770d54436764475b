// Reading a recording and asking it for moments between its frames; no browser.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { crc32 } from '../src/recording/crc32.js';
import { DamagedRecording, decode } from '../src/recording/decode.js';
import { centerAt, locate, matrixAt, poseAt, newPose, principalOmega, rotationAt, vectorAt } from '../src/recording/sample.js';
import { encode } from './write.mjs';
import * as scenes from './scenes.mjs';

const close = (a, b, tolerance) => a.forEach((x, k) => assert.ok(Math.abs(x - b[k]) <= tolerance, `${a} against ${b}`));
// Channels are stored in f32.
const F32 = 2 ** -23;

test('the checksum is that of zip and png', () => {
  assert.equal(crc32(new TextEncoder().encode('123456789')), 0xcbf43926);
});

test('what is written is read', () => {
  const body = (k) => ({ position: [k, 2, 3], rotation: [0, 1, 0, 0], force: [k + 0.5, 0, 0] });
  const channels = [{ name: 'position', size: 3 }, { name: 'force', size: 3 }, { name: 'rotation', size: 4 }];
  const header = { title: 'è', bodies: [{ name: 'a' }, { name: 'b' }, { name: 'c' }], channels, series: [{ name: 'E' }] };
  const frames = [0, 1].map((f) => ({ t: f, series: [1 / 3 + f], bodies: [0, 1, 2].map(body) }));
  const recording = decode(encode(header, frames));
  assert.equal(recording.header.title, 'è');
  assert.equal(recording.nFrames, 2);
  assert.equal(recording.series.get('E').values[1], 1 / 3 + 1);
  assert.deepEqual(recording.read('force', 1, 2, [0, 0, 0]), [2.5, 0, 0]);
  assert.deepEqual(recording.read('rotation', 0, 1, [0, 0, 0, 0]), [0, 1, 0, 0]);
});

test('damage is named', () => {
  const good = scenes.links();
  const damaged = (change) => {
    const bytes = Buffer.from(good);
    return () => decode(change(bytes) ?? bytes);
  };
  const says = (pattern) => (error) => error instanceof DamagedRecording && pattern.test(error.message);
  assert.throws(damaged(() => Buffer.from('not this')), says(/not a polhode recording/));
  assert.throws(damaged((bytes) => void bytes.write('POLHODE7')), says(/version 7/));
  assert.throws(damaged((bytes) => bytes.subarray(0, 12)), says(/cut short/));
  assert.throws(damaged((bytes) => bytes.subarray(0, 100)), says(/inside its header/));
  assert.throws(damaged((bytes) => bytes.subarray(0, bytes.length - 60)), says(/120 of its 121 frames/));
  assert.throws(damaged((bytes) => void (bytes[bytes.length - 40] ^= 1)), says(/checksum/));
  assert.throws(damaged((bytes) => Buffer.concat([bytes, Buffer.alloc(8)])), says(/8 bytes follow/));
  assert.throws(damaged((bytes) => void (bytes[16] = 0x20)), says(/not valid JSON/));
});

const oneBody = (names, frames) =>
  decode(encode({ bodies: [{ name: 'a' }], channels: names.map(([name, size]) => ({ name, size })) }, frames));

test('a body in free fall follows its parabola between frames', () => {
  const names = [['position', 3], ['rotation', 4], ['velocity', 3]];
  const g = -9.81;
  const frames = [0, 0.1, 0.2].map((t) => ({ t, bodies: [{ position: [t, 0, (g * t * t) / 2], rotation: [1, 0, 0, 0], velocity: [1, 0, g * t] }] }));
  const recording = oneBody(names, frames);
  for (const t of [0.02, 0.05, 0.13, 0.2]) {
    close(centerAt(recording, locate(recording, t), 0, [0, 0, 0]), [t, 0, (g * t * t) / 2], 2 * F32);
  }
});

test('a kick inside an interval does not make the path swing', () => {
  const names = [['position', 3], ['rotation', 4], ['velocity', 3]];
  const frames = [[0, 0], [0.1, 30]].map(([t, v]) => ({ t, bodies: [{ position: [t, 0, 0], rotation: [1, 0, 0, 0], velocity: [1, 0, v] }] }));
  close(centerAt(oneBody(names, frames), { frame: 0, next: 1, u: 0.5, dt: 0.1 }, 0, [0, 0, 0]), [0.05, 0, 0], F32);
});

test('a fast body turns on, not back, between frames', () => {
  const names = [['position', 3], ['rotation', 4], ['angular_velocity', 3]];
  const rate = 150;
  const spin = (t) => [Math.cos((rate * t) / 2), 0, Math.sin((rate * t) / 2), 0];
  const frames = [0, 1 / 30, 2 / 30].map((t) => ({ t, bodies: [{ position: [0, 0, 0], rotation: spin(t), angular_velocity: [0, rate, 0] }] }));
  const recording = oneBody(names, frames);
  for (const t of [0.004, 0.02, 0.05]) {
    const q = rotationAt(recording, locate(recording, t), 0, [0, 0, 0, 0]);
    const want = spin(t);
    const same = Math.abs(q.reduce((sum, x, k) => sum + x * want[k], 0));
    // Two quaternions ε apart have a dot product of 1 − ε²/2; five radians a frame of f32 poses are good to 1e-6.
    assert.ok(same > 1 - 1e-11, `at ${t}: ${q} against ${want}`);
  }
});

test('the origin of the body frame goes around the centre of mass, not through it', () => {
  const names = [['position', 3], ['rotation', 4], ['center', 3]];
  const frames = [0, 1].map((t) => {
    const angle = Math.PI * 0.9 * t;
    return { t, bodies: [{ center: [t, 0, 0], position: [t - Math.cos(angle), -Math.sin(angle), 0], rotation: [Math.cos(angle / 2), 0, 0, Math.sin(angle / 2)] }] };
  });
  const recording = oneBody(names, frames);
  const pose = poseAt(recording, locate(recording, 0.5), 0, newPose());
  assert.ok(Math.abs(Math.hypot(...pose.position.map((x, k) => x - pose.center[k])) - 1) < 4 * F32);
});

test('a matrix that is a rotation stays one between frames', () => {
  const recording = decode(scenes.explicitR({ kept: true }));
  const m = matrixAt(recording, locate(recording, 0.05), 0, new Array(9));
  for (let c = 0; c < 3; c++) assert.ok(Math.abs(Math.hypot(...m.slice(3 * c, 3 * c + 3)) - 1) < 8 * F32);
});

test('the polhode stays on the energy ellipsoid and on the momentum sphere', () => {
  const recording = decode(scenes.racket());
  const inertia = recording.bodies[0].inertia;
  const invariants = (t) => {
    const w = principalOmega(recording, locate(recording, t), 0, [0, 0, 0]);
    return [0, 1].map((power) => w.reduce((sum, x, k) => sum + inertia[k] ** (1 + power) * x * x, 0));
  };
  const first = invariants(0);
  for (const frame of [30, 100, 200, 360]) {
    // ω in f32 is good to 2⁻²⁴ a component, rotated and squared: a few units of it.
    invariants(recording.times[frame]).forEach((x, k) => assert.ok(Math.abs(x / first[k] - 1) < 16 * F32));
  }
});

test('times outside the recording give its ends', () => {
  const recording = decode(scenes.links());
  assert.equal(locate(recording, -5).frame, 0);
  assert.equal(locate(recording, 99).frame, recording.nFrames - 1);
  const v = vectorAt(recording, 'position', locate(recording, 99), 0, [0, 0, 0]);
  assert.deepEqual(v, recording.read('position', recording.nFrames - 1, 0, [0, 0, 0]));
});
