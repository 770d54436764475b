// What went wrong, as sentences in the page.

import { element } from './element.js';

export function complaint(sentences) {
  return element('div', { class: 'complaint', role: 'alert' }, ...sentences.map((sentence) => element('p', {}, sentence)));
}
