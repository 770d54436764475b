// One body: its surfaces and the lines on them, moved as the recording says.

import {
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Group,
  Matrix4,
  Mesh,
  MeshStandardMaterial,
  Points,
  PointsMaterial,
} from 'three';
import { buildShape } from './shapes.js';
import { segments } from './strokes.js';

// Beyond this many bodies lines cost more than they tell.
const MOST_OUTLINED = 600;
/** Columns of a matrix longer than this (a rotation has 1) are no longer drawn. */
export const MOST_GROWN = 1e6;

const ORIGIN = new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(3), 3));
/** Diameter of the dot that stands for a body too small to be seen [CSS pixels]. */
const DOT = 7;

/** How a body looks by its kind: fixed is grey, kinematic is translucent with dashed edges. */
function look(body, index, theme) {
  const color = body.color ? theme.color('--ink').set(body.color) : theme.body(index);
  if (body.kind === 'fixed') {
    if (body.color) color.lerp(theme.color('--fixed'), 0.7);
    else color.copy(theme.color('--fixed'));
  }
  return { color, opacity: body.kind === 'kinematic' ? 0.55 : 1, dashed: body.kind === 'kinematic' };
}

/** Radius about the origin of the body frame; 0 for a half-space or a body without shapes. */
export function bodyRadius(body) {
  let radius = 0;
  for (const shape of body.shapes ?? []) {
    const built = buildShape(shape);
    if (built) radius = Math.max(radius, built.radius + Math.hypot(...(shape.position ?? [0, 0, 0])));
  }
  return radius;
}

export class BodyView {
  constructor(body, index, count, theme) {
    this.group = new Group();
    this.group.matrixAutoUpdate = false;
    this.meshes = [];
    this.outlines = [];
    this.look = look(body, index, theme);
    const { color, opacity, dashed } = this.look;
    this.edgeColor = color.clone().lerp(theme.color('--edge'), 0.72);
    this.selectedColor = theme.color('--accent');
    this.material = new MeshStandardMaterial({
      color,
      roughness: 0.82,
      metalness: 0,
      side: DoubleSide,
      polygonOffset: true,
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 1,
    });
    this.fade(opacity);
    for (const shape of body.shapes ?? []) {
      const built = buildShape(shape);
      if (!built) continue;
      const place = new Group();
      place.position.set(...(shape.position ?? [0, 0, 0]));
      const [w, x, y, z] = shape.rotation ?? [1, 0, 0, 0];
      place.quaternion.set(x, y, z, w);
      const mesh = new Mesh(built.geometry, this.material);
      mesh.userData.body = index;
      place.add(mesh);
      this.meshes.push(mesh);
      if (built.lines.length && count <= MOST_OUTLINED) {
        const dash = dashed ? built.radius / 12 : 0;
        const outline = segments(built.lines, { color: this.edgeColor, width: 1.4, dashed: dash });
        outline.userData.body = index;
        place.add(outline);
        this.outlines.push(outline);
      }
      this.group.add(place);
    }
    this.radius = bodyRadius(body);
    this.endless = (body.shapes ?? []).some((shape) => shape.type === 'half_space');
    this.dot = new Points(ORIGIN, new PointsMaterial({ color: this.edgeColor, size: DOT, sizeAttenuation: false }));
    this.dot.frustumCulled = false;
    this.group.add(this.dot);
  }

  /** On a screen of this many metres a pixel, a body may be too small to be seen; a particle has no shape at all. */
  setScale(metresPerPixel) {
    this.dot.visible = !this.endless && 2 * this.radius < (DOT - 2) * metresPerPixel;
  }

  /** Opacity of the surfaces; edges stay. */
  fade(opacity) {
    if (this.material.opacity === opacity && this.opacitySet) return;
    this.opacitySet = true;
    this.material.opacity = opacity;
    this.material.transparent = opacity < 1;
    this.material.depthWrite = opacity >= 1;
    this.material.needsUpdate = true;
  }

  select(selected) {
    for (const outline of this.outlines) {
      outline.material.color.copy(selected ? this.selectedColor : this.edgeColor);
      outline.material.linewidth = selected ? 2.4 : 1.4;
    }
  }

  /**
   * @param {number[]} columns nine numbers: the images of the body's x, y and z axes
   * @param {number} farthest a body beyond this distance is not drawn: the screen's arithmetic is that of f32
   * @returns what is wrong with the place, or ''
   */
  place(columns, position, layer, farthest) {
    const [a, b, c, d, e, f, g, h, i] = columns;
    const [x, y, z] = position;
    const finite = columns.every(Number.isFinite) && position.every(Number.isFinite);
    const drawable = columns.every((c) => Math.abs(c) < MOST_GROWN) && position.every((p) => Math.abs(p) < farthest);
    this.group.visible = finite && drawable;
    if (!finite) return 'no longer a finite number';
    if (!drawable) return 'too far or too large to be drawn';
    this.group.matrix.copy(new Matrix4(a, d, g, x, b, e, h, y, c, f, i, z + layer, 0, 0, 0, 1));
    this.group.matrixWorldNeedsUpdate = true;
    return '';
  }
}
