// A short symbol beside an arrow, always facing the eye and always the same size on the screen.

import { CanvasTexture, LinearFilter, Sprite, SpriteMaterial } from 'three';

const SIZE = 96;
/** Height of a label on the screen [CSS pixels]. */
export const LABEL_PIXELS = 26;

const known = new Map();

function texture(text, color, halo) {
  const key = `${text} ${color} ${halo}`;
  if (known.has(key)) return known.get(key);
  const canvas = document.createElement('canvas');
  canvas.width = SIZE;
  canvas.height = SIZE;
  const pen = canvas.getContext('2d');
  pen.font = `italic 600 ${SIZE * 0.6}px "STIX Two Math", "Cambria Math", Cambria, Georgia, "DejaVu Serif", serif`;
  pen.textAlign = 'center';
  pen.textBaseline = 'middle';
  pen.lineJoin = 'round';
  pen.lineWidth = SIZE * 0.13;
  pen.strokeStyle = halo;
  pen.strokeText(text, SIZE / 2, SIZE / 2);
  pen.fillStyle = color;
  pen.fillText(text, SIZE / 2, SIZE / 2);
  const made = new CanvasTexture(canvas);
  made.minFilter = LinearFilter;
  made.generateMipmaps = false;
  made.colorSpace = 'srgb';
  known.set(key, made);
  return made;
}

export function label(text, color, halo) {
  const map = texture(text, `#${color.getHexString()}`, halo);
  const sprite = new Sprite(new SpriteMaterial({ map, depthTest: false, transparent: true, toneMapped: false }));
  sprite.renderOrder = 20;
  sprite.userData.label = true;
  return sprite;
}
