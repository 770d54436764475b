// What the command line wrote into this page: recordings in base64, and the page's own words.

import { decode, DamagedRecording } from './decode.js';

function fromBase64(text) {
  let binary;
  try {
    binary = atob(text.trim());
  } catch {
    throw new DamagedRecording('The recording in this page is damaged: it is not base64.');
  }
  const bytes = new Uint8Array(binary.length);
  for (let k = 0; k < binary.length; k++) bytes[k] = binary.charCodeAt(k);
  return bytes;
}

/** Decodes several sources, keeping the sentences of those that fail. */
export function decodeAll(sources) {
  const recordings = [];
  const complaints = [];
  for (const { name, bytes } of sources) {
    try {
      recordings.push(decode(bytes()));
    } catch (error) {
      if (!(error instanceof DamagedRecording)) throw error;
      complaints.push(sources.length > 1 ? `${name}: ${error.message}` : error.message);
    }
  }
  return { recordings, complaints };
}

export function embeddedSources(document) {
  const scripts = document.querySelectorAll('script[type="application/x-polhode-recording"]');
  return [...scripts].map((script, k) => ({
    name: `Recording ${k + 1}`,
    bytes: () => fromBase64(script.textContent),
  }));
}

/** `{title, explanation, look_for, row, links}` of the page, or `{}`. */
export function pageWords(document) {
  const script = document.getElementById('polhode-page');
  if (!script) return {};
  try {
    return JSON.parse(script.textContent) ?? {};
  } catch {
    return {};
  }
}
