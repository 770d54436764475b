// What the page tells scripts and tests: `window.polhode`.

export function publish(page) {
  const { player, recordings } = page;
  window.polhode = {
    ready: true,
    get time() {
      return player.time;
    },
    get playing() {
      return player.playing;
    },
    start: player.start,
    end: player.end,
    frames: player.frames.length,
    bodies: recordings[0].bodies.map((body) => body.name),
    recordings: recordings.map((recording) => ({ label: recording.label, frames: recording.nFrames, bodies: recording.bodies.length })),
    get layers() {
      return [...page.layers];
    },
    get selected() {
      return page.selected;
    },
    play: () => page.setPlaying(true),
    pause: () => page.setPlaying(false),
    /** Pauses at `t` and paints before it returns. */
    seek(t) {
      player.setPlaying(false);
      player.seek(t);
      page.paint();
    },
    toggle: (name, on) => page.toggle(name, on),
    select: (body, recording = 0) => page.select(recording, body),
    /** Per view: `variance` of the picture, `bodyPixels` and `bodyShare` that bodies cover. Empty without WebGL. */
    pixels() {
      page.paint();
      return page.stage?.pixels() ?? [];
    },
    /** Per plot: how many points its curves have, and how long they are in pixels. */
    plots: () =>
      page.plots.map((plot) => ({
        title: plot.plot.title ?? '',
        curves: plot.paths.map((path) => ({ length: path.getAttribute('d') ? path.getTotalLength() : 0 })),
      })),
  };
}
