// A decoded recording: its header, its times and series in f64, and a view on the channels in f32.

export class Recording {
  /**
   * @param {object} header as in FORMAT.md
   * @param {number} nFrames
   * @param {ArrayBuffer} frames the frames and nothing else
   * @param {number} frameBytes size of one frame
   */
  constructor(header, nFrames, frames, frameBytes) {
    this.header = header;
    this.label = header.label ?? '';
    this.bodies = header.bodies;
    this.planar = Boolean(header.planar);
    this.origin = header.origin ?? [0, 0, 0];
    this.nFrames = nFrames;

    const doubles = new Float64Array(frames);
    const rowDoubles = frameBytes / 8;
    const column = (k) => Float64Array.from({ length: nFrames }, (_, frame) => doubles[frame * rowDoubles + k]);
    this.times = column(0);
    this.series = new Map(
      header.series.map((series, k) => [series.name, { ...series, values: column(1 + k) }]),
    );

    this.floats = new Float32Array(frames);
    this.rowFloats = frameBytes / 4;
    this.firstFloat = 2 * (1 + header.series.length);
    this.channels = new Map();
    this.bodyFloats = 0;
    for (const { name, size } of header.channels) {
      this.channels.set(name, { offset: this.bodyFloats, size });
      this.bodyFloats += size;
    }
  }

  get startTime() {
    return this.nFrames ? this.times[0] : 0;
  }

  get endTime() {
    return this.nFrames ? this.times[this.nFrames - 1] : 0;
  }

  has(channel) {
    return this.channels.has(channel);
  }

  /** Copies a channel of a body at a frame into `out`. The channel must exist. */
  read(channel, frame, body, out) {
    const { offset, size } = this.channels.get(channel);
    const at = frame * this.rowFloats + this.firstFloat + body * this.bodyFloats + offset;
    for (let k = 0; k < size; k++) out[k] = this.floats[at + k];
    return out;
  }

  /** The centre of mass if it is recorded, else the origin of the body frame: where arrows start. */
  get centerChannel() {
    return this.has('center') ? 'center' : 'position';
  }

  /** The largest finite length of a vector channel over all bodies and frames; 0 when there is none. */
  largest(channel) {
    if (!this.has(channel)) return 0;
    const v = [0, 0, 0];
    let most = 0;
    for (let frame = 0; frame < this.nFrames; frame++) {
      for (let body = 0; body < this.bodies.length; body++) {
        this.read(channel, frame, body, v);
        const square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        if (square > most && square < Infinity) most = square;
      }
    }
    return Math.sqrt(most);
  }
}
