// Play, step, scrub, speed, loop; and what time it is.

import { SPEEDS } from '../player.js';
import { seconds } from '../plot/numbers.js';
import { element } from './element.js';
import { icon } from './icons.js';

const SCRUB_STEPS = 10_000;

export class Transport {
  /** `act` has: togglePlay, step, seek, setSpeed, toggleLoop. */
  constructor(player, act) {
    this.player = player;
    const button = (name, label, does) =>
      element('button', { type: 'button', class: 'icon', 'aria-label': label, title: label, onclick: does }, icon(name));
    this.play = button('play', 'Play (space)', act.togglePlay);
    this.back = button('back', 'Step back one frame (←)', () => act.step(-1));
    this.forward = button('forward', 'Step on one frame (→)', () => act.step(1));
    this.loop = button('loop', 'Repeat', act.toggleLoop);
    this.scrub = element('input', {
      type: 'range',
      class: 'scrub',
      min: 0,
      max: SCRUB_STEPS,
      step: 1,
      'aria-label': 'Time',
      oninput: () => act.seek(player.start + (this.scrub.valueAsNumber / SCRUB_STEPS) * player.duration),
    });
    const options = SPEEDS.map((speed) => element('option', { value: speed }, `${speed}×`));
    this.speed = element('select', { 'aria-label': 'Speed', title: 'Speed (, and .)', onchange: () => act.setSpeed(Number(this.speed.value)) }, ...options);
    this.clock = element('span', { class: 'clock' });
    this.element = element(
      'section',
      { class: 'transport', 'aria-label': 'Playback' },
      this.back,
      this.play,
      this.forward,
      this.scrub,
      this.clock,
      this.speed,
      this.loop,
    );
    const { frames } = player;
    this.resolution = frames.length > 1 ? player.duration / (frames.length - 1) : 0.01;
    this.update();
  }

  update() {
    const { player } = this;
    const u = player.duration > 0 ? (player.time - player.start) / player.duration : 0;
    this.scrub.value = String(Math.round(u * SCRUB_STEPS));
    this.scrub.style.setProperty('--done', `${100 * u}%`);
    const now = seconds(player.time, this.resolution);
    const end = seconds(player.end, 0.01);
    this.scrub.setAttribute('aria-valuetext', `${now} of ${end} seconds`);
    this.clock.textContent = `${now} / ${end} s`;
    if (this.shownPlaying !== player.playing) {
      this.shownPlaying = player.playing;
      this.play.replaceChildren(icon(player.playing ? 'pause' : 'play'));
      this.play.setAttribute('aria-label', player.playing ? 'Pause (space)' : 'Play (space)');
      this.play.title = player.playing ? 'Pause (space)' : 'Play (space)';
    }
    this.loop.setAttribute('aria-pressed', String(player.loop));
    if (Number(this.speed.value) !== player.speed) this.speed.value = String(player.speed);
  }
}
