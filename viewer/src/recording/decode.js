// Bytes of a recording (FORMAT.md) → a Recording. Every complaint is one plain sentence for the page.

import { crc32 } from './crc32.js';
import { Recording } from './recording.js';

const MAGIC = 'POLHODE1';
const PREFIX = 16;

/** What is wrong with a file, in a sentence a reader can act on. */
export class DamagedRecording extends Error {}

function refuse(condition, sentence) {
  if (condition) throw new DamagedRecording(sentence);
}

/** Size of one frame in bytes: time and series in f64, channels in f32, padded to 8. */
export function frameBytes(header) {
  const floats = header.channels.reduce((sum, channel) => sum + channel.size, 0) * header.bodies.length;
  return Math.ceil((8 * (1 + header.series.length) + 4 * floats) / 8) * 8;
}

/** @param {Uint8Array} bytes the whole file */
export function decode(bytes) {
  const magic = String.fromCharCode(...bytes.subarray(0, 8));
  if (magic !== MAGIC) {
    refuse(/^POLHODE\d$/.test(magic), `This is a recording of version ${magic.slice(7)}; the page reads version 1.`);
    throw new DamagedRecording('This is not a polhode recording: it does not begin with “POLHODE1”.');
  }
  refuse(bytes.length < PREFIX, 'The recording is cut short: it ends inside its first 16 bytes.');

  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const headerLength = view.getUint32(8, true);
  const nFrames = view.getUint32(12, true);
  const start = PREFIX + headerLength;
  refuse(start > bytes.length, 'The recording is cut short: it ends inside its header.');
  refuse(start % 8 !== 0, 'The recording is damaged: its frames do not start at a multiple of 8 bytes.');

  const header = readHeader(bytes.subarray(PREFIX, start));
  const size = frameBytes(header);
  const end = start + nFrames * size;
  if (bytes.length < end + 4) {
    const whole = Math.max(0, Math.floor((bytes.length - start) / size));
    throw new DamagedRecording(
      `The recording is cut short: it holds ${Math.min(whole, nFrames)} of its ${nFrames} frames.`,
    );
  }
  refuse(bytes.length > end + 4, `The recording is damaged: ${bytes.length - end - 4} bytes follow its end.`);
  refuse(
    crc32(bytes.subarray(0, end)) !== view.getUint32(end, true),
    'The recording is damaged: its checksum does not match its contents.',
  );
  return new Recording(header, nFrames, new Uint8Array(bytes.subarray(start, end)).buffer, size);
}

function readHeader(bytes) {
  let header;
  try {
    header = JSON.parse(new TextDecoder('utf-8', { fatal: true }).decode(bytes));
  } catch {
    throw new DamagedRecording('The recording is damaged: its header is not valid JSON.');
  }
  for (const key of ['bodies', 'channels', 'series']) {
    refuse(!Array.isArray(header?.[key]), `The recording is damaged: its header has no list “${key}”.`);
  }
  for (const [name, size] of [['position', 3], ['rotation', 4]]) {
    const found = header.channels.find((channel) => channel.name === name);
    refuse(found?.size !== size, `The recording is damaged: channel “${name}” with ${size} numbers is missing.`);
  }
  return header;
}
