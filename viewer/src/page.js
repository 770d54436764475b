// The page of one or several recordings: puts the parts together and keeps them at one time.

import { measure } from './view/measure.js';
import { Stage } from './view/stage.js';
import { Player } from './player.js';
import { Plot, mergePlots } from './plot/plot.js';
import { availableLayers, defaultLayers } from './scene/layers.js';
import { element } from './ui/element.js';
import { explain, headline, wordsFor } from './ui/explain.js';
import { Help } from './ui/help.js';
import { Inspector } from './ui/inspector.js';
import { listen } from './ui/keys.js';
import { complaint } from './ui/message.js';
import { Show } from './ui/show.js';
import { Transport } from './ui/transport.js';

const INSPECT_EVERY = 80;

export class Page {
  constructor(root, recordings, pageWords, complaints) {
    this.recordings = recordings;
    this.player = new Player(recordings);
    this.available = availableLayers(recordings);
    this.layers = defaultLayers(recordings, this.available, measure(recordings));
    this.selected = Math.max(0, recordings[0].bodies.findIndex((body) => body.kind !== 'fixed'));
    const followed = recordings.map((one) => one.header.follow).find((body) => Number.isInteger(body));
    if (recordings[0].bodies[followed]) {
      this.selected = followed;
      this.layers.add('follow');
    }
    this.build(root, pageWords, complaints);
    this.bindKeys();
    const dark = matchMedia('(prefers-color-scheme: dark)');
    dark.addEventListener('change', () => {
      this.stage?.rebuild();
      this.draw();
    });
    if (!matchMedia('(prefers-reduced-motion: reduce)').matches) this.player.setPlaying(true);
    this.lastTick = null;
    this.draw();
  }

  build(root, pageWords, complaints) {
    const { recordings, player } = this;
    const words = wordsFor(pageWords, recordings);
    document.title = words.title;
    this.help = new Help(this.available);
    this.show = new Show(this.available, this.layers, (name) => this.toggle(name));
    this.inspector = new Inspector(recordings, (recording, body) => this.select(recording, body));
    this.inspector.select(0, this.selected);
    this.transport = new Transport(player, {
      togglePlay: () => this.setPlaying(!player.playing),
      step: (by) => this.step(by),
      seek: (t) => this.seek(t),
      setSpeed: (speed) => this.change(() => (player.speed = speed)),
      toggleLoop: () => this.change(() => (player.loop = !player.loop)),
    });
    const span = [player.start, player.end];
    this.plots = mergePlots(recordings).map((plot) => new Plot(plot, recordings, span, (t) => this.seek(t)));
    const views = element('section', { class: 'views', 'aria-label': '3D view', tabindex: 0 });
    const main = element('div', { class: 'main' }, views, this.transport.element);
    if (this.plots.length) {
      main.append(element('section', { class: 'plots', 'aria-label': 'Plots' }, ...this.plots.map((plot) => plot.element)));
    }
    const side = element('div', { class: 'side' }, ...[explain(words), this.show.element, this.inspector.element].filter(Boolean));
    const keys = element('button', { type: 'button', class: 'keys', 'aria-label': 'Keys (?)', title: 'Keys (?)', onclick: () => this.help.toggle() }, '?');
    root.replaceChildren(
      element('header', { class: 'top' }, headline(words), keys),
      ...(complaints.length ? [complaint(complaints)] : []),
      element('main', { class: `app${this.plots.length ? '' : ' no-plots'}` }, main, side),
      this.help.dialog,
    );
    this.makeStage(views);
  }

  makeStage(views) {
    const style = getComputedStyle(document.documentElement);
    const colors = this.recordings.map((_, k) => style.getPropertyValue(`--s${(k % 8) + 1}`).trim());
    try {
      this.stage = new Stage(views, this.recordings, colors, {
        draw: () => this.draw(),
        select: (recording, body) => this.select(recording, body),
      });
    } catch (error) {
      views.replaceChildren(complaint(['This browser has no WebGL, so the bodies cannot be drawn. The plots and numbers work without it.']));
      console.warn(error);
    }
  }

  /** Redraws in the next animation frame, once however often it is asked. */
  draw() {
    if (this.asked || !this.transport) return;
    this.asked = true;
    requestAnimationFrame((now) => this.frame(now));
  }

  frame(now) {
    this.asked = false;
    const elapsed = this.lastTick === null ? 0 : (now - this.lastTick) / 1000;
    this.player.tick(elapsed);
    this.lastTick = this.player.playing ? now : null;
    this.paint();
    if (this.player.playing) this.draw();
    document.documentElement.dataset.ready = '1';
  }

  /** Everything at the player's time, now. */
  paint() {
    const { time, playing } = this.player;
    this.stage?.update(time, this.layers, this.selected, this.marked);
    this.stage?.draw();
    this.transport.update();
    for (const plot of this.plots) plot.setTime(time);
    // Digits that change sixty times a second are not read.
    const now = performance.now();
    if (!playing || !(now - this.inspected < INSPECT_EVERY)) {
      this.inspected = now;
      this.inspector.update(time);
    }
  }

  change(does) {
    does();
    this.draw();
  }

  setPlaying(playing) {
    this.change(() => this.player.setPlaying(playing));
  }

  seek(t) {
    this.change(() => this.player.seek(t));
  }

  step(by) {
    this.change(() => this.player.step(by));
  }

  toggle(name, on = !this.layers.has(name)) {
    if (!this.available.some((layer) => layer.name === name)) return;
    if (on) this.layers.add(name);
    else this.layers.delete(name);
    this.show.update(this.layers);
    this.draw();
  }

  select(recording, body) {
    this.selected = Math.min(body, this.recordings[recording].bodies.length - 1);
    this.marked = true;
    this.inspector.select(recording, Math.max(0, this.selected));
    this.draw();
  }

  bindKeys() {
    const { player } = this;
    const arrow = (sign) => (event) => (event.shiftKey ? this.seek(player.time + sign) : this.step(sign));
    const bindings = new Map([
      [' ', () => this.setPlaying(!player.playing)],
      ['ArrowLeft', arrow(-1)],
      ['ArrowRight', arrow(1)],
      ['Home', () => this.seek(player.start)],
      ['End', () => this.seek(player.end)],
      [',', () => this.change(() => player.faster(-1))],
      ['.', () => this.change(() => player.faster(1))],
      ['r', () => this.change(() => (player.loop = !player.loop))],
      ['c', () => this.change(() => this.stage?.rig.reset())],
      ['+', () => this.change(() => this.stage?.rig.zoomBy(1.2))],
      ['=', () => this.change(() => this.stage?.rig.zoomBy(1.2))],
      ['-', () => this.change(() => this.stage?.rig.zoomBy(1 / 1.2))],
      ['[', () => this.change(() => this.stage?.rig.orbit(0.15, 0))],
      [']', () => this.change(() => this.stage?.rig.orbit(-0.15, 0))],
      ['{', () => this.change(() => this.stage?.rig.orbit(0, -0.1))],
      ['}', () => this.change(() => this.stage?.rig.orbit(0, 0.1))],
      ['?', () => this.help.toggle()],
      ...this.available.map((layer) => [layer.key, () => this.toggle(layer.name)]),
    ]);
    listen(bindings);
  }
}
