// One canvas for all views of the page: each recording is drawn into its own rectangle of it, by one camera.

import { Raycaster, Vector2, Vector3, WebGLRenderer } from 'three';
import { LABEL_PIXELS } from '../scene/label.js';
import { RecordingScene } from '../scene/recording_scene.js';
import { roundBelow } from '../scene/ground.js';
import { readTheme } from '../scene/theme.js';
import { number } from '../plot/numbers.js';
import { Cell } from './cell.js';
import { Gestures } from './gestures.js';
import { measure } from './measure.js';
import { Rig } from './rig.js';

const MOST_PIXELS_PER_PIXEL = 2;
const TURN = 0.0075;

export class Stage {
  /** Throws where the browser has no WebGL. `ask` is told of clicks and of the need to draw again. */
  constructor(container, recordings, colors, ask) {
    this.container = container;
    this.recordings = recordings;
    this.ask = ask;
    this.following = false;
    this.measures = [measure(recordings), measure(recordings, true)];
    this.canvas = document.createElement('canvas');
    this.renderer = new WebGLRenderer({ canvas: this.canvas, antialias: true, alpha: true, stencil: true });
    this.renderer.setScissorTest(true);
    this.renderer.autoClear = false;
    const planar = recordings.every((recording) => recording.planar);
    this.rig = new Rig({ planar, ...this.home() });
    this.cells = recordings.map((recording, k) =>
      new Cell({
        label: recordings.length > 1 ? recording.label || `Recording ${k + 1}` : '',
        color: recordings.length > 1 ? colors[k] : null,
        description: `3D view of ${recording.header.title ?? 'the recording'}${recording.label ? `, ${recording.label}` : ''}`,
      }),
    );
    this.canvas.setAttribute('aria-hidden', 'true');
    container.append(this.canvas, ...this.cells.map((cell) => cell.element));
    container.dataset.views = String(Math.min(recordings.length, 7));
    this.gestures = new Gestures(container, {
      turn: (dx, dy) => this.moved(() => (planar ? this.shift(dx, dy) : this.rig.orbit(dx * TURN, dy * TURN))),
      shift: (dx, dy) => this.moved(() => this.shift(dx, dy)),
      zoom: (factor) => this.moved(() => this.rig.zoomBy(factor)),
      reset: () => this.moved(() => this.rig.reset()),
      click: (x, y) => this.click(x, y),
    });
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(container);
    this.rebuild();
    this.resize();
  }

  /**
   * What fills the view: the whole scene, or a body and its surroundings when the camera goes with it; in either case
   * with room for the ellipsoids while they are shown.
   */
  home() {
    const { center, spheres, unit, ellipsoid } = this.measure;
    const wanted = this.following ? [{ point: center, radius: 3.5 * unit }] : spheres;
    const room = this.ellipsoids ? 1.05 * ellipsoid : 0;
    return { center, spheres: wanted.map(({ point, radius }) => ({ point, radius: Math.max(radius, room) })) };
  }

  get measure() {
    return this.measures[this.following ? 1 : 0];
  }

  /** With the camera near a body, arrows are in its size and no longer in that of the whole scene. */
  follow(following) {
    this.following = following;
    this.rig.setHome(this.home());
    this.rig.pan.set(0, 0, 0);
    if (this.measures[0].unit !== this.measures[1].unit) this.rebuild();
  }

  /** Colours are baked into materials, so a change of theme builds the scenes again. */
  rebuild() {
    this.theme = readTheme();
    for (const view of this.views ?? []) view.dispose();
    this.views = this.recordings.map((recording) => new RecordingScene(recording, this.measure, this.theme));
  }

  resize() {
    const { clientWidth, clientHeight } = this.container;
    this.renderer.setPixelRatio(Math.min(MOST_PIXELS_PER_PIXEL, window.devicePixelRatio || 1));
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.ask.draw();
  }

  moved(change) {
    change();
    this.ask.draw();
  }

  shift(dx, dy) {
    const { width, height } = this.rectangle(0);
    this.rig.panBy(dx, -dy, height, width / height);
  }

  /** A cell's place in the canvas, CSS pixels from its top left. */
  rectangle(k) {
    const all = this.container.getBoundingClientRect();
    const one = this.cells[k].element.getBoundingClientRect();
    return { left: one.left - all.left, top: one.top - all.top, width: one.width, height: one.height };
  }

  update(t, layers, selected, marked) {
    if (layers.has('follow') !== this.following) this.follow(!this.following);
    const ellipsoids = layers.has('polhode') || layers.has('herpolhode');
    if (ellipsoids !== this.ellipsoids) {
      this.ellipsoids = ellipsoids;
      this.rig.setHome(this.home());
    }
    this.views.forEach((view, k) => {
      view.update(t, layers, selected, marked);
      const notes = [...view.notes];
      if (view.growth > 1.3) notes.push(`The body has grown ×${number(view.growth, 3)}; this view is zoomed out to keep it in sight`);
      this.cells[k].setNotes(notes);
    });
    this.selected = selected;
    this.gridShown = layers.has('grid');
  }

  draw() {
    this.renderer.setScissor(0, 0, this.container.clientWidth, this.container.clientHeight);
    this.renderer.clear();
    this.views.forEach((_, k) => this.drawCell(k));
  }

  drawCell(k) {
    const view = this.views[k];
    const { left, top, width, height } = this.rectangle(k);
    if (width < 2 || height < 2) return;
    const { distance, metresPerPixel } = this.aim(k, width, height);
    for (const body of view.bodies) body.setScale(metresPerPixel);
    const spacing = roundBelow(distance / 12);
    view.ground?.setView(spacing, 6 * distance, this.rig.target);
    this.cells[k].setRuler(view.ground && this.gridShown ? `grid ${number(spacing)} m` : '');
    const point = new Vector3();
    view.scene.updateMatrixWorld();
    view.scene.traverseVisible((node) => {
      if (!node.userData.label) return;
      node.getWorldPosition(point);
      node.scale.setScalar(this.rig.sizeOf(LABEL_PIXELS, point, height));
    });
    const bottom = this.container.clientHeight - top - height;
    this.renderer.setViewport(left, bottom, width, height);
    this.renderer.setScissor(left, bottom, width, height);
    this.renderer.render(view.scene, this.rig.camera);
  }

  aim(k, width, height) {
    const view = this.views[k];
    const body = Math.max(0, this.selected ?? 0);
    const center = view.poses[body]?.center;
    const follow = this.following && center?.every(Number.isFinite) ? new Vector3(...center) : null;
    const growth = view.growth > 1.3 ? view.growth / 1.3 : 1;
    return this.rig.aim({ aspect: width / height, height, growth, follow });
  }

  click(clientX, clientY) {
    const all = this.container.getBoundingClientRect();
    const [x, y] = [clientX - all.left, clientY - all.top];
    for (let k = 0; k < this.cells.length; k++) {
      const { left, top, width, height } = this.rectangle(k);
      if (x < left || x > left + width || y < top || y > top + height) continue;
      this.aim(k, width, height);
      const ray = new Raycaster();
      ray.setFromCamera(new Vector2(((x - left) / width) * 2 - 1, 1 - ((y - top) / height) * 2), this.rig.camera);
      const meshes = this.views[k].bodies.filter((body) => body.group.visible).flatMap((body) => body.meshes);
      const hit = ray.intersectObjects(meshes, false)[0];
      if (hit) this.ask.select(k, hit.object.userData.body);
      return;
    }
  }

  /**
   * What is on the canvas, for tests: for each view the variance of its pixels (0…1 a channel, averaged), and how
   * many pixels bodies and links cover when all else is hidden, as a number and as a share. Call it right after `draw`.
   */
  pixels() {
    const seen = this.views.map((_, k) => this.readCell(k));
    const restore = this.views.map((view) => view.bareBodies());
    this.draw();
    const bare = this.views.map((_, k) => this.readCell(k));
    restore.forEach((put) => put());
    this.ask.draw();
    return this.views.map((_, k) => ({ variance: variance(seen[k]), ...covered(bare[k]) }));
  }

  readCell(k) {
    const gl = this.renderer.getContext();
    const ratio = this.renderer.getPixelRatio();
    const { left, top, width, height } = this.rectangle(k);
    const [w, h] = [Math.floor(width * ratio), Math.floor(height * ratio)];
    const data = new Uint8Array(4 * w * h);
    const bottom = this.canvas.height - Math.round((top + height) * ratio);
    gl.readPixels(Math.round(left * ratio), bottom, w, h, gl.RGBA, gl.UNSIGNED_BYTE, data);
    return data;
  }
}

function variance(data) {
  const sum = [0, 0, 0, 0];
  const squares = [0, 0, 0, 0];
  const n = data.length / 4;
  for (let k = 0; k < data.length; k++) {
    const x = data[k] / 255;
    sum[k & 3] += x;
    squares[k & 3] += x * x;
  }
  return n ? sum.reduce((total, s, c) => total + squares[c] / n - (s / n) ** 2, 0) / 4 : 0;
}

function covered(data) {
  let count = 0;
  for (let k = 3; k < data.length; k += 4) if (data[k] > 0) count++;
  return { bodyPixels: count, bodyShare: data.length ? (4 * count) / data.length : 0 };
}
