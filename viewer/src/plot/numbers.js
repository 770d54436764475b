// Numbers as a reader writes them: 0.05, 12.3, 1.5×10⁻¹⁵.

const RAISED = { '-': '⁻', 0: '⁰', 1: '¹', 2: '²', 3: '³', 4: '⁴', 5: '⁵', 6: '⁶', 7: '⁷', 8: '⁸', 9: '⁹' };
const MINUS = '−';

export function powerOfTen(exponent) {
  return `10${[...String(exponent)].map((character) => RAISED[character]).join('')}`;
}

function plain(text) {
  const short = text.includes('.') ? text.replace(/\.?0+$/, '') : text;
  return short === '-0' ? '0' : short.replace('-', MINUS);
}

/** `x` with `digits` significant digits, without trailing zeros. */
export function number(x, digits = 4) {
  if (Number.isNaN(x)) return 'undefined';
  if (!Number.isFinite(x)) return x > 0 ? '∞' : `${MINUS}∞`;
  if (x === 0) return '0';
  const [mantissa, exponent] = x.toExponential(digits - 1).split('e');
  const power = Number(exponent);
  if (power >= -3 && power < Math.max(5, digits)) return plain(Number(x.toPrecision(digits)).toFixed(Math.max(0, digits - 1 - power)));
  const front = plain(mantissa);
  return front === '1' ? powerOfTen(power) : `${front}×${powerOfTen(power)}`;
}

/**
 * The components of one vector to the precision of its largest, `digits` significant digits, all with the same
 * decimals: a readout that does not jump about. `power`, when not 0, is a power of ten common to them.
 */
export function components(values, digits = 5) {
  const largest = Math.max(0, ...values.map(Math.abs).filter(Number.isFinite));
  const exponent = largest === 0 ? 0 : Number(largest.toExponential(digits - 1).split('e')[1]);
  const power = exponent < -3 || exponent >= digits ? exponent : 0;
  const decimals = power ? digits - 1 : digits - 1 - Math.max(0, exponent);
  const texts = values.map((x) => {
    if (!Number.isFinite(x)) return number(x);
    const text = (x / 10 ** power).toFixed(decimals);
    return (Number(text) === 0 ? text.replace('-', '') : text).replace('-', MINUS);
  });
  return { texts, power };
}

/** Seconds with as many decimals as `resolution` needs. */
export function seconds(t, resolution) {
  const decimals = Math.min(6, Math.max(2, Math.ceil(-Math.log10(resolution || 0.01))));
  return t.toFixed(decimals).replace('-', MINUS);
}
