// Numbers, axes and curves of the plots; no browser.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { components, number } from '../src/plot/numbers.js';
import { linearScale, logScale } from '../src/plot/scale.js';
import { tracePath } from '../src/plot/trace_path.js';

const texts = (scale) => scale.ticks.map((tick) => tick.text);

test('numbers are written as a reader writes them', () => {
  assert.equal(number(0), '0');
  assert.equal(number(0.05), '0.05');
  assert.equal(number(-12.3), '−12.3');
  assert.equal(number(1.5e-15), '1.5×10⁻¹⁵');
  assert.equal(number(1e-15), '10⁻¹⁵');
  assert.equal(number(2e9), '2×10⁹');
  assert.equal(number(9.81, 6), '9.81');
  assert.equal(number(100), '100');
  assert.equal(number(NaN), 'undefined');
  assert.equal(number(-Infinity), '−∞');
  assert.deepEqual(components([0, -3.14159265, 1e-9]), { texts: ['0.0000', '−3.1416', '0.0000'], power: 0 });
  assert.deepEqual(components([2.5e-7, -1e-8]), { texts: ['2.5000', '−0.1000'], power: -7 });
  assert.deepEqual(components([0, 0]), { texts: ['0.0000', '0.0000'], power: 0 });
});

test('an axis has round ticks and one power of ten', () => {
  const scale = linearScale([[0, 3.1e-15]]);
  assert.deepEqual(texts(scale), ['0', '1', '2', '3']);
  assert.equal(scale.above, '×10⁻¹⁵');
});

test('a small change of a large value is shown as a change', () => {
  const scale = linearScale([[19.62, 19.62 + 7.1e-15, 19.62 - 3.6e-15]]);
  assert.match(scale.above, /×10⁻¹⁵, change from 19\.62/);
  assert.ok(scale.place(19.62) > 0.2 && scale.place(19.62) < 0.5);
});

test('constant, zero and missing values have an axis or none', () => {
  assert.equal(linearScale([[5, 5]]).place(5), 0.5);
  assert.equal(linearScale([[0, 0]]).place(0), 0.5);
  assert.equal(linearScale([[NaN, Infinity]]), null);
  assert.equal(linearScale([[]]), null);
  assert.equal(linearScale([[NaN, 2, 4]]).ticks.length > 1, true);
});

test('a logarithmic axis keeps a line for zeros and takes magnitudes', () => {
  const scale = logScale([[0, 1e-15, -1e-9]]);
  assert.deepEqual(texts(scale).slice(0, 2), ['0', '10⁻¹⁵']);
  assert.ok(scale.place(0) < scale.place(1e-15));
  assert.equal(scale.place(-1e-9), 1);
  assert.deepEqual(texts(logScale([[0, 0]])), ['0']);
  assert.equal(logScale([[NaN]]), null);
});

test('a curve has gaps where values are missing, and keeps its spikes when there are many points', () => {
  const x = (t) => t;
  const gap = tracePath([0, 10, 20, 30], [1, 1, NaN, 1], x, (v) => v);
  assert.equal(gap.split('M').length - 1, 2);
  const times = Array.from({ length: 10_000 }, (_, k) => k / 100);
  const values = times.map((t) => (t === 50 ? 7 : 1));
  const path = tracePath(times, values, x, (v) => v);
  assert.match(path, / 7\.00/);
  assert.ok(path.split('L').length < 1000);
});
