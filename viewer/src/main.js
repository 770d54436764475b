// Opens what the page carries, or asks for a file.

import { decodeAll, embeddedSources, pageWords } from './recording/embedded.js';
import { publish } from './interface.js';
import { Page } from './page.js';
import { complaint } from './ui/message.js';
import { DropZone } from './ui/drop.js';

const root = document.getElementById('app');

function start(sources) {
  const { recordings, complaints } = decodeAll(sources);
  if (recordings.length) publish(new Page(root, recordings, pageWords(document), complaints));
  else askForFiles(complaints);
}

function askForFiles(complaints) {
  const zone = new DropZone(start);
  root.replaceChildren(...(complaints.length ? [complaint(complaints)] : []), zone.element);
  document.documentElement.dataset.ready = '1';
}

// After a click the keys belong to the page again, not to the button that was clicked.
document.addEventListener('click', (event) => event.detail > 0 && event.target.closest?.('button')?.blur());

const sources = embeddedSources(document);
if (sources.length) start(sources);
else askForFiles([]);
