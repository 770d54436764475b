// The frame of one recording's view: its name, what is undefined or out of scale, the width of a grid square.

import { element } from '../ui/element.js';

export class Cell {
  constructor({ label, color, description }) {
    this.name = element('span', { class: 'cell-name' }, label);
    this.notes = element('div', { class: 'cell-notes', 'aria-live': 'off' });
    this.ruler = element('span', { class: 'cell-ruler', title: 'Width of a grid square' });
    const head = element('div', { class: 'cell-head' });
    if (label) {
      if (color) head.append(element('span', { class: 'dot', style: `background:${color}` }));
      head.append(this.name);
    }
    this.element = element('div', { class: 'cell', role: 'img', 'aria-label': description }, head, this.notes, this.ruler);
    this.shownNotes = null;
  }

  setNotes(notes) {
    const text = notes.join('\n');
    if (text === this.shownNotes) return;
    this.shownNotes = text;
    this.notes.replaceChildren(...notes.map((note) => element('div', {}, note)));
  }

  setRuler(text) {
    if (this.ruler.textContent !== text) this.ruler.textContent = text;
  }
}
