// Writes recordings as FORMAT.md says, and puts them into the built page as the command line does.

import { readFileSync } from 'node:fs';
import { crc32 } from '../src/recording/crc32.js';
import { frameBytes } from '../src/recording/decode.js';

const PAGE = readFileSync(new URL('../dist/viewer.html', import.meta.url), 'utf8');
const MARKER = '<!-- recordings -->';

/**
 * @param {object} header as in FORMAT.md; `channels` and `series` may be left out when empty
 * @param {{t: number, series?: number[], bodies: object[]}[]} frames each body has a list a channel name
 */
export function encode(header, frames) {
  const full = {
    title: 'A test', explanation: '', look_for: '', label: '', integrator: 'pdmv6', dt: 0.01, frame_interval: 1 / 30,
    gravity: [0, 0, -9.81], planar: false, origin: [0, 0, 0], bodies: [], series: [], plots: [], links: [],
    channels: [{ name: 'position', size: 3 }, { name: 'rotation', size: 4 }],
    ...header,
  };
  let json = Buffer.from(JSON.stringify(full));
  json = Buffer.concat([json, Buffer.alloc((8 - (json.length % 8)) % 8, ' ')]);
  const size = frameBytes(full);
  const out = Buffer.alloc(16 + json.length + frames.length * size + 4);
  out.write('POLHODE1', 'latin1');
  out.writeUInt32LE(json.length, 8);
  out.writeUInt32LE(frames.length, 12);
  json.copy(out, 16);
  frames.forEach((frame, k) => {
    let at = 16 + json.length + k * size;
    at = out.writeDoubleLE(frame.t, at);
    for (const value of frame.series ?? []) at = out.writeDoubleLE(value, at);
    for (const body of frame.bodies) {
      for (const channel of full.channels) {
        for (let i = 0; i < channel.size; i++) at = out.writeFloatLE(body[channel.name][i], at);
      }
    }
  });
  out.writeUInt32LE(crc32(out.subarray(0, out.length - 4)), out.length - 4);
  return out;
}

/** The page with recordings and, if given, its own words. */
export function pageOf(recordings, words) {
  const scripts = recordings.map((bytes) => `<script type="application/x-polhode-recording">${Buffer.from(bytes).toString('base64')}</script>`);
  if (words) scripts.push(`<script type="application/json" id="polhode-page">${JSON.stringify(words).replaceAll('<', '\\u003c')}</script>`);
  return PAGE.replace(MARKER, () => scripts.join('\n'));
}
