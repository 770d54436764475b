// What time it is in the recording, and how fast it passes.

export const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 5, 10];
// A tab that was hidden must not jump ahead by minutes.
const LONGEST_TICK = 1;

export class Player {
  /** @param {import('./recording/recording.js').Recording[]} recordings */
  constructor(recordings) {
    const filled = recordings.filter((recording) => recording.nFrames > 0);
    this.start = filled.length ? Math.min(...filled.map((recording) => recording.startTime)) : 0;
    this.end = filled.length ? Math.max(...filled.map((recording) => recording.endTime)) : 0;
    const finest = filled.reduce((best, one) => (!best || one.nFrames > best.nFrames ? one : best), null);
    this.frames = finest ? finest.times : new Float64Array(0);
    this.time = this.start;
    this.playing = false;
    this.speed = 1;
    this.loop = true;
  }

  get duration() {
    return this.end - this.start;
  }

  seek(t) {
    if (Number.isFinite(t)) this.time = Math.min(this.end, Math.max(this.start, t));
  }

  /** Advances by `elapsed` seconds of the reader's time. */
  tick(elapsed) {
    if (!this.playing || this.duration <= 0) return;
    const next = this.time + Math.min(LONGEST_TICK, elapsed) * this.speed;
    if (next <= this.end) this.time = next;
    else if (this.loop) this.time = this.start + ((next - this.start) % this.duration);
    else {
      this.time = this.end;
      this.playing = false;
    }
  }

  setPlaying(playing) {
    if (playing && !this.loop && this.time >= this.end) this.time = this.start;
    this.playing = playing && this.duration > 0;
  }

  /** The index of the last frame not after now. */
  get frame() {
    let low = 0;
    let high = Math.max(0, this.frames.length - 1);
    while (low < high) {
      const middle = (low + high + 1) >> 1;
      if (this.frames[middle] <= this.time + 1e-12) low = middle;
      else high = middle - 1;
    }
    return low;
  }

  /** To another recorded frame; pauses, because who steps wants to look. */
  step(by) {
    this.playing = false;
    if (!this.frames.length) return;
    const between = this.time - this.frames[this.frame] > 1e-9;
    const from = by < 0 && between ? this.frame + 1 : this.frame;
    this.time = this.frames[Math.min(this.frames.length - 1, Math.max(0, from + by))];
  }

  faster(by) {
    const now = SPEEDS.findIndex((speed) => speed >= this.speed);
    this.speed = SPEEDS[Math.min(SPEEDS.length - 1, Math.max(0, now + by))];
  }
}
