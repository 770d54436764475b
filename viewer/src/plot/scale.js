// From values to a place on an axis, with the ticks and how they are written.

import { number, powerOfTen } from './numbers.js';

/** Round steps 1, 2, 5 × 10ⁿ that put about `count` ticks between `low` and `high`. */
export function roundStep(low, high, count) {
  const rough = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  return ([1, 2, 5].find((k) => k * power >= rough * (1 - 1e-9)) ?? 10) * power;
}

export function roundTicks(low, high, count) {
  const step = roundStep(low, high, count);
  const ticks = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) ticks.push(k * step);
  return ticks;
}

function finiteRange(lists) {
  let low = Infinity;
  let high = -Infinity;
  for (const values of lists) {
    for (const x of values) {
      if (!Number.isFinite(x)) continue;
      if (x < low) low = x;
      if (x > high) high = x;
    }
  }
  return low <= high ? [low, high] : null;
}

/** One power of ten for all ticks, so that labels stay short: 1.5 with ×10⁻¹⁵ above the axis. */
function commonPower(ticks) {
  const most = Math.max(...ticks.map(Math.abs));
  if (most === 0) return 0;
  const power = Math.floor(Math.log10(most) + 1e-9);
  return power >= 4 || power <= -3 ? power : 0;
}

/**
 * `{ place(x) 0…1, ticks: [{at, text}], above, lists }` for values on a linear axis. Where they hardly differ from one
 * large value, the axis shows the change from it: 19.62 J + 3×10⁻¹⁵ is read as 3×10⁻¹⁵.
 */
export function linearScale(lists, count = 4) {
  const range = finiteRange(lists);
  if (!range) return null;
  let [low, high] = range;
  const largest = Math.max(Math.abs(low), Math.abs(high));
  let from = 0;
  if (high > low && high - low < 1e-4 * largest) {
    from = lists.flatMap((values) => [values.find(Number.isFinite)]).find((x) => x !== undefined);
    low -= from;
    high -= from;
  }
  if (high === low) {
    const pad = low === 0 ? 1 : 0.5 * Math.abs(low);
    [low, high] = [low - pad, high + pad];
  } else {
    const pad = 0.06 * (high - low);
    [low, high] = [low - pad, high + pad];
  }
  const values = roundTicks(low, high, count);
  const power = commonPower(values);
  const above = [];
  if (power) above.push(`×${powerOfTen(power)}`);
  if (from) above.push(`change from ${number(from, 6)}`);
  return {
    place: (x) => (x - from - low) / (high - low),
    ticks: values.map((x) => ({ at: (x - low) / (high - low), text: number(x / 10 ** power, 6) })),
    above: above.join(', '),
  };
}

// Zeros have no place on a logarithmic axis, yet an error that is exactly zero is what one hopes to see: they lie on
// a line of their own below the axis.
const ZERO_BAND = 0.1;

/** Magnitudes on a logarithmic axis. Null when no value is finite. */
export function logScale(lists, count = 5) {
  const range = finiteRange(lists);
  if (!range) return null;
  let low = Infinity;
  let high = 0;
  let zeros = false;
  for (const values of lists) {
    for (const x of values) {
      const size = Math.abs(x);
      if (size === 0) zeros = true;
      else if (Number.isFinite(size)) {
        low = Math.min(low, size);
        high = Math.max(high, size);
      }
    }
  }
  const bottom = zeros ? ZERO_BAND : 0;
  if (high === 0) return { place: (x) => (x === 0 ? 0.5 : NaN), ticks: [{ at: 0.5, text: '0' }], above: '' };
  let from = Math.floor(Math.log10(low) + 1e-9);
  let to = Math.ceil(Math.log10(high) - 1e-9);
  if (to === from) to += 1;
  const at = (exponent) => bottom + ((1 - bottom) * (exponent - from)) / (to - from);
  const stride = Math.max(1, Math.ceil((to - from) / count));
  const ticks = zeros ? [{ at: 0.03, text: '0' }] : [];
  for (let exponent = from; exponent <= to; exponent += stride) {
    ticks.push({ at: at(exponent), text: powerOfTen(exponent) });
  }
  return {
    place: (x) => (x === 0 ? 0.03 : at(Math.log10(Math.abs(x)))),
    ticks,
    above: '',
  };
}
