// A series as the d attribute of an SVG path: gaps where values are not finite, and never more than a few points a
// pixel column (first, lowest, highest, last), so that a spike is not lost and a long series stays quick.

const COLUMN = 0.75;

/**
 * @param {ArrayLike<number>} times increasing
 * @param {ArrayLike<number>} values
 * @param {(t: number) => number} x pixels from the left
 * @param {(v: number) => number} y pixels from the top; not finite is a gap
 */
export function tracePath(times, values, x, y) {
  const parts = [];
  let column = [];
  let drawing = false;
  const point = ([px, py]) => {
    parts.push(`${drawing ? 'L' : 'M'}${px.toFixed(2)} ${py.toFixed(2)}`);
    drawing = true;
  };
  const flush = () => {
    if (!column.length) return;
    const lowest = column.reduce((a, b) => (b[1] > a[1] ? b : a));
    const highest = column.reduce((a, b) => (b[1] < a[1] ? b : a));
    const kept = [column[0], lowest, highest, column[column.length - 1]];
    column.filter((one) => kept.includes(one)).forEach(point);
    column = [];
  };
  for (let k = 0; k < times.length; k++) {
    const next = [x(times[k]), y(values[k])];
    if (!Number.isFinite(next[0]) || !Number.isFinite(next[1])) {
      closeRun();
      continue;
    }
    if (column.length && next[0] - column[0][0] > COLUMN) flush();
    column.push(next);
  }
  closeRun();
  return parts.join('');

  // A lone point between gaps is drawn as a dot: a round cap needs a line, however short.
  function closeRun() {
    const lone = column.length === 1 && !drawing;
    const last = column[0];
    flush();
    if (lone) parts.push(`L${(last[0] + 0.01).toFixed(2)} ${last[1].toFixed(2)}`);
    drawing = false;
  }
}
