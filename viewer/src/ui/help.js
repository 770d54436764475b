// The list of keys, over the page; `?` opens and closes it.

import { element } from './element.js';

const GENERAL = [
  ['Space', 'Play or pause'],
  ['← →', 'One frame back or on'],
  ['Shift ← →', 'One second back or on'],
  ['Home End', 'To the start, to the end'],
  [', .', 'Slower, faster'],
  ['R', 'Repeat'],
  ['C', 'Camera back to the start'],
  ['+ −', 'Nearer, farther'],
  ['[ ]', 'Camera to the left, to the right'],
  ['{ }', 'Camera down, up'],
  ['?', 'This list'],
];
const POINTER = [
  ['Drag', 'Turn (shift it in a planar scene)'],
  ['Right drag, two fingers', 'Shift'],
  ['Wheel, pinch', 'Nearer, farther'],
  ['Click', 'Choose a body'],
  ['Drag on a plot', 'To that time'],
];

function list(rows) {
  const items = rows.flatMap(([key, text]) => [element('dt', {}, element('kbd', {}, key)), element('dd', {}, text)]);
  return element('dl', {}, ...items);
}

export class Help {
  constructor(available) {
    const close = element('button', { type: 'button', class: 'close', onclick: () => this.dialog.close() }, 'Close');
    this.dialog = element(
      'dialog',
      { class: 'help', 'aria-label': 'Keys' },
      element('div', { class: 'help-columns' },
        element('div', {}, element('h2', {}, 'Keys'), list(GENERAL)),
        element('div', {}, element('h2', {}, 'Show and hide'), list(available.map(({ key, text }) => [key.toUpperCase(), text]))),
        element('div', {}, element('h2', {}, 'Mouse and touch'), list(POINTER)),
      ),
      close,
    );
    this.dialog.addEventListener('click', (event) => event.target === this.dialog && this.dialog.close());
  }

  toggle() {
    if (this.dialog.open) this.dialog.close();
    else this.dialog.showModal();
  }
}
