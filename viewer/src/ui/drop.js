// A page without recordings opens files: dropped on it or picked.

import { element } from './element.js';

export class DropZone {
  /** `open(sources)` is given what was chosen. */
  constructor(open) {
    this.open = open;
    this.input = element('input', { type: 'file', accept: '.plh', multiple: true, class: 'sr-only', id: 'files', onchange: () => this.take(this.input.files) });
    this.element = element(
      'section',
      { class: 'drop' },
      element('h1', {}, 'Open a recording'),
      element('p', {}, 'Drop one or more .plh files here, or choose them. Several play side by side.'),
      this.input,
      element('label', { for: 'files', class: 'button' }, 'Choose files'),
      element('p', { class: 'quiet' }, 'Nothing leaves this computer. ', element('code', {}, 'polhode run SCENE --record motion.plh'), ' writes one.'),
    );
    const stop = (event, over) => {
      event.preventDefault();
      this.element.classList.toggle('over', over);
    };
    window.addEventListener('dragover', (event) => stop(event, true));
    window.addEventListener('dragleave', (event) => stop(event, false));
    window.addEventListener('drop', (event) => {
      stop(event, false);
      this.take(event.dataTransfer.files);
    });
  }

  async take(files) {
    const chosen = [...files];
    if (!chosen.length || !this.element.isConnected) return;
    const buffers = await Promise.all(chosen.map((file) => file.arrayBuffer()));
    this.open(chosen.map((file, k) => ({ name: file.name, bytes: () => new Uint8Array(buffers[k]) })));
  }
}
