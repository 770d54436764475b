// One plot over time: an SVG with axes, a path a series, a cursor at the current time; drag on it to seek.

import { element, svg } from '../ui/element.js';
import { linearScale, logScale, roundTicks } from './scale.js';
import { number } from './numbers.js';
import { tracePath } from './trace_path.js';

const HEIGHT = 190;
const MARGIN = { top: 22, right: 14, bottom: 30, left: 58 };
const DASHES = ['none', '6 4', '2 3', '9 3 2 3'];

/** A pure number has no unit to write. */
function unitOf(unit) {
  return unit && unit !== '1' ? unit : '';
}

/** Lines of a plot: every wanted series of every recording that has it. */
function linesOf(plot, recordings) {
  const lines = [];
  recordings.forEach((recording, r) => {
    plot.series.forEach((name, s) => {
      const series = recording.series.get(name);
      if (!series) return;
      const many = recordings.length > 1;
      const what = series.label || series.name;
      const whose = recording.label || `Recording ${r + 1}`;
      lines.push({
        times: recording.times,
        values: series.values,
        text: !many ? what : plot.series.length > 1 ? `${whose}: ${what}` : whose,
        color: `var(--s${((many ? r : s) % 8) + 1})`,
        dash: many ? DASHES[s % DASHES.length] : 'none',
        unit: unitOf(series.unit),
      });
    });
  });
  return lines;
}

export class Plot {
  /** `span` is [first, last] time of the page; `seek(t)` is called while the reader drags. */
  constructor(plot, recordings, span, seek) {
    this.plot = plot;
    this.lines = linesOf(plot, recordings);
    this.span = span;
    this.seek = seek;
    this.log = Boolean(plot.log);
    this.time = span[0];
    this.values = this.lines.map(() => element('span', { class: 'plot-value' }));
    this.toggle = element('button', { class: 'plot-log', type: 'button', onclick: () => this.setLog(!this.log) }, 'log');
    this.svg = svg('svg', { class: 'plot-area', role: 'img', height: HEIGHT });
    this.element = element(
      'figure',
      { class: 'plot' },
      element('figcaption', {}, element('span', { class: 'plot-title' }, plot.title ?? plot.series.join(', ')), this.toggle),
      this.svg,
      element('ul', { class: 'plot-legend' }, ...this.lines.map((line, k) => this.legendRow(line, k))),
    );
    this.svg.addEventListener('pointerdown', (event) => {
      this.svg.setPointerCapture(event.pointerId);
      this.seekTo(event);
    });
    this.svg.addEventListener('pointermove', (event) => event.buttons && this.seekTo(event));
    this.observer = new ResizeObserver(() => this.layout());
    this.observer.observe(this.element);
    this.setLog(this.log);
  }

  legendRow(line, k) {
    const stroke = svg('line', { x1: 1, y1: 5, x2: 21, y2: 5, style: `stroke:${line.color};stroke-dasharray:${line.dash}` });
    const swatch = svg('svg', { width: 22, height: 10, class: 'swatch', 'aria-hidden': 'true' }, stroke);
    return element('li', {}, swatch, element('span', { class: 'plot-name' }, line.text), this.values[k]);
  }

  setLog(log) {
    this.log = log;
    this.toggle.setAttribute('aria-pressed', String(log));
    this.toggle.setAttribute('aria-label', `Logarithmic axis of ${this.plot.title ?? 'this plot'}`);
    this.layout();
  }

  seekTo(event) {
    const box = this.svg.getBoundingClientRect();
    const u = (event.clientX - box.left - MARGIN.left) / (box.width - MARGIN.left - MARGIN.right);
    this.seek(this.span[0] + Math.min(1, Math.max(0, u)) * (this.span[1] - this.span[0]));
  }

  layout() {
    const width = Math.max(160, this.element.clientWidth);
    const right = width - MARGIN.right;
    const bottom = HEIGHT - MARGIN.bottom;
    this.svg.setAttribute('viewBox', `0 0 ${width} ${HEIGHT}`);
    this.svg.setAttribute('width', width);
    const [first, last] = this.span;
    const long = last > first ? last - first : 1;
    this.x = (t) => MARGIN.left + ((t - first) / long) * (right - MARGIN.left);
    const lists = this.lines.map((line) => line.values);
    const scale = this.log ? logScale(lists) : linearScale(lists);
    const y = scale && ((v) => bottom - scale.place(v) * (bottom - MARGIN.top));
    const unit = unitOf(this.plot.unit) || this.lines[0]?.unit || '';
    const title = [unit && `[${unit}]`, this.log && 'logarithmic', scale?.above];
    const axis = svg('g', { class: 'axis' });
    axis.append(svg('text', { x: MARGIN.left, y: 13, class: 'plot-unit' }, title.filter(Boolean).join('  ')));
    for (const { at, text } of scale?.ticks ?? []) {
      const level = bottom - at * (bottom - MARGIN.top);
      axis.append(svg('line', { x1: MARGIN.left, x2: right, y1: level, y2: level, class: 'rule' }));
      axis.append(svg('text', { x: MARGIN.left - 7, y: level + 3.5, 'text-anchor': 'end' }, text));
    }
    const timeTicks = roundTicks(first, first + long, Math.max(2, Math.floor(width / 90)));
    for (const t of timeTicks) {
      axis.append(svg('line', { x1: this.x(t), x2: this.x(t), y1: bottom, y2: bottom + 4, class: 'tick' }));
      axis.append(svg('text', { x: this.x(t), y: bottom + 16, 'text-anchor': 'middle' }, number(t, 6)));
    }
    axis.append(svg('line', { x1: MARGIN.left, x2: right, y1: bottom, y2: bottom, class: 'base' }));
    axis.append(svg('text', { x: right, y: HEIGHT - 2, 'text-anchor': 'end', class: 'plot-unit' }, 't [s]'));
    this.paths = scale
      ? this.lines.map((line) => {
          const d = tracePath(line.times, line.values, this.x, y);
          return svg('path', { d, class: 'trace', style: `stroke:${line.color};stroke-dasharray:${line.dash}` });
        })
      : [];
    this.cursor = svg('line', { y1: MARGIN.top, y2: bottom, class: 'cursor' });
    this.y = y;
    this.dots = this.paths.map((_, k) => svg('circle', { r: 3.2, style: `fill:${this.lines[k].color}` }));
    const empty = !scale && svg('text', { x: (MARGIN.left + right) / 2, y: HEIGHT / 2, 'text-anchor': 'middle' }, 'no finite values');
    this.svg.replaceChildren(...[axis, ...this.paths, this.cursor, ...this.dots, empty].filter(Boolean));
    this.svg.setAttribute('aria-label', `${this.plot.title ?? 'Plot'} over time`);
    this.setTime(this.time);
  }

  setTime(t) {
    this.time = t;
    if (!this.cursor) return;
    const x = this.x(t);
    this.cursor.setAttribute('x1', x);
    this.cursor.setAttribute('x2', x);
    this.lines.forEach((line, k) => {
      const value = valueAt(line, t);
      const unit = unitOf(this.plot.unit) || line.unit;
      this.values[k].textContent = value === null ? '' : `${number(value, 6)}${unit && Number.isFinite(value) ? ` ${unit}` : ''}`;
      const y = value === null || !this.y ? NaN : this.y(value);
      const dot = this.dots[k];
      if (!dot) return;
      dot.setAttribute('visibility', Number.isFinite(y) ? 'visible' : 'hidden');
      if (Number.isFinite(y)) {
        dot.setAttribute('cx', x);
        dot.setAttribute('cy', y);
      }
    });
  }
}

/** The recorded value at the last frame not after `t`: a series is shown as computed, not interpolated. */
function valueAt(line, t) {
  if (!line.times.length) return null;
  let low = 0;
  let high = line.times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (line.times[middle] <= t + 1e-12) low = middle;
    else high = middle - 1;
  }
  return line.values[low];
}

/** All plots of the headers; those with the same title in several recordings are one. */
export function mergePlots(recordings) {
  const merged = new Map();
  for (const recording of recordings) {
    for (const plot of recording.header.plots ?? []) {
      const key = plot.title ?? plot.series.join();
      const known = merged.get(key);
      if (known) known.series = [...new Set([...known.series, ...plot.series])];
      else merged.set(key, { ...plot, series: [...plot.series] });
    }
  }
  return [...merged.values()];
}
