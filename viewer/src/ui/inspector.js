// The numbers of one body at the current time, with units.

import { locate, newPose, poseAt, vectorAt } from '../recording/sample.js';
import { components, number, powerOfTen } from '../plot/numbers.js';
import { element } from './element.js';

const ROWS = [
  ['x', 'Position of the centre of mass', 'm', (state) => state.center],
  ['v', 'Velocity', 'm/s', (state) => state.velocity],
  ['ω', 'Angular velocity', 'rad/s', (state) => state.angular_velocity],
  ['|ω|', 'Size of the angular velocity', 'rad/s', (state) => size(state.angular_velocity)],
  ['L', 'Angular momentum', 'kg·m²/s', (state) => state.angular_momentum],
  ['|L|', 'Size of the angular momentum', 'kg·m²/s', (state) => size(state.angular_momentum)],
  ['F', 'Force', 'N', (state) => state.force],
  ['τ', 'Torque', 'N·m', (state) => state.torque],
  ['q', 'Orientation, a unit quaternion w, x, y, z', '', (state) => state.rotation],
];
const VECTORS = ['velocity', 'angular_velocity', 'angular_momentum', 'force', 'torque'];

function size(vector) {
  return vector && [Math.hypot(...vector)];
}

export class Inspector {
  /** `choose(recording, body)` is called when the reader picks another. */
  constructor(recordings, choose) {
    this.recordings = recordings;
    this.body = element('select', { 'aria-label': 'Body', onchange: () => choose(this.recordingIndex, Number(this.body.value)) });
    this.which = element('select', {
      'aria-label': 'Recording',
      onchange: () => choose(Number(this.which.value), Number(this.body.value)),
      hidden: recordings.length < 2,
    });
    recordings.forEach((recording, k) => this.which.append(element('option', { value: k }, recording.label || `Recording ${k + 1}`)));
    this.facts = element('p', { class: 'facts' });
    this.cells = ROWS.map(() => element('td'));
    this.rows = ROWS.map(([symbol, name, unit], k) =>
      element('tr', {}, element('th', { scope: 'row', title: name }, symbol), this.cells[k], element('td', { class: 'unit' }, unit)),
    );
    this.table = element('table', {}, element('tbody', {}, ...this.rows));
    this.element = element(
      'section',
      { class: 'panel inspector', 'aria-label': 'The selected body' },
      element('h2', {}, 'Body'),
      element('div', { class: 'pick' }, this.body, this.which),
      this.facts,
      this.table,
    );
    this.select(0, 0);
  }

  select(recordingIndex, body) {
    const recording = this.recordings[recordingIndex];
    const changed = this.recordingIndex !== recordingIndex;
    this.recordingIndex = recordingIndex;
    this.bodyIndex = body;
    if (changed) {
      this.body.replaceChildren(...recording.bodies.map((one, k) => element('option', { value: k }, one.name || `body ${k + 1}`)));
      this.which.value = String(recordingIndex);
    }
    this.body.value = String(body);
    const one = recording.bodies[body];
    this.facts.textContent = one ? factsOf(one) : 'This recording holds no bodies.';
    this.pose = newPose();
  }

  update(t) {
    const recording = this.recordings[this.recordingIndex];
    const empty = !recording?.bodies[this.bodyIndex] || !recording.nFrames;
    this.table.hidden = empty;
    if (empty) return;
    const at = locate(recording, t);
    const state = { ...poseAt(recording, at, this.bodyIndex, this.pose) };
    state.center = state.center.map((x, k) => x + recording.origin[k]);
    for (const channel of VECTORS) {
      if (recording.has(channel)) state[channel] = vectorAt(recording, channel, at, this.bodyIndex, [0, 0, 0]);
    }
    ROWS.forEach(([, , , get], k) => {
      const values = get(state);
      this.rows[k].hidden = !values;
      if (!values) return;
      const { texts, power } = components(values);
      const spans = texts.map((text) => element('span', {}, text));
      this.cells[k].replaceChildren(...spans, ...(power ? [element('span', {}, `×${powerOfTen(power)}`)] : []));
    });
  }
}

function factsOf(body) {
  const parts = [body.kind];
  if (Number.isFinite(body.mass)) parts.push(`m = ${number(body.mass)} kg`);
  if (body.inertia) parts.push(`J₀ = ${body.inertia.map((x) => number(x)).join(', ')} kg·m²`);
  return parts.join(' · ');
}
