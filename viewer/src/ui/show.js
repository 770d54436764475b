// What is drawn: one switch a layer, which is also the legend of its colour.

import { element } from './element.js';

export class Show {
  constructor(available, layers, toggle) {
    this.switches = new Map();
    const items = available.map((layer) => {
      const button = element(
        'button',
        { type: 'button', class: 'layer', 'aria-keyshortcuts': layer.key, onclick: () => toggle(layer.name) },
        element('span', { class: 'layer-mark', style: `--mark:var(${layer.color})`, 'aria-hidden': 'true' }),
        element('span', { class: 'layer-text' }, layer.text),
        element('kbd', { 'aria-hidden': 'true' }, layer.key.toUpperCase()),
      );
      this.switches.set(layer.name, button);
      return element('li', {}, button);
    });
    this.element = element(
      'section',
      { class: 'panel show', 'aria-label': 'What is drawn' },
      element('h2', {}, 'Show'),
      element('ul', { class: 'layers' }, ...items),
    );
    this.update(layers);
  }

  update(layers) {
    for (const [name, button] of this.switches) button.setAttribute('aria-pressed', String(layers.has(name)));
  }
}
