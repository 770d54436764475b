// Four line icons, drawn with the text colour.

import { svg } from './element.js';

const PATHS = {
  play: 'M7 4.5v15l12-7.5z',
  pause: 'M7 4.5h3.5v15H7zM13.5 4.5H17v15h-3.5z',
  back: 'M6 5h2.5v14H6zM18.5 5v14l-9-7z',
  forward: 'M15.5 5H18v14h-2.5zM5.5 5l9 7-9 7z',
  loop: 'M17 3.5l4 3.5-4 3.5V8H8a3.5 3.5 0 0 0-3.5 3.5V13h-2v-1.5A5.5 5.5 0 0 1 8 6h9zM7 20.5L3 17l4-3.5V16h9a3.5 3.5 0 0 0 3.5-3.5V11h2v1.5A5.5 5.5 0 0 1 16 18H7z',
};

export function icon(name) {
  return svg('svg', { viewBox: '0 0 24 24', width: 20, height: 20, fill: 'currentColor', 'aria-hidden': 'true' }, svg('path', { d: PATHS[name] }));
}
