// What bodies move above: a grid at a round height, or the half-spaces of the scene; and the shadows on it.

import {
  DoubleSide,
  Group,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  ShaderMaterial,
  EqualStencilFunc,
  IncrementStencilOp,
  KeepStencilOp,
  Vector3,
} from 'three';
import { Outline } from './outline.js';
import { segments } from './strokes.js';

const Z = new Vector3(0, 0, 1);

const VERTEX = `
  varying vec2 vPlane;
  uniform float reach;
  void main() {
    vPlane = position.xy * reach;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position.xy * reach, 0.0, 1.0);
  }`;

// Lines are one pixel wide at any distance (screen-space derivatives), every tenth is stronger, and all fade out.
const FRAGMENT = `
  varying vec2 vPlane;
  uniform float reach, spacing, fill;
  uniform vec2 center;
  uniform vec3 lineColor, fillColor;
  float lines(float step, float width) {
    vec2 cell = vPlane / step;
    vec2 slope = fwidth(cell);
    vec2 near = abs(fract(cell - 0.5) - 0.5) / max(slope, vec2(1e-6));
    float line = 1.0 - min(min(near.x, near.y) / width, 1.0);
    return line * (1.0 - smoothstep(0.25, 0.6, max(slope.x, slope.y)));
  }
  void main() {
    float far = length(vPlane - center) / reach;
    float fade = 1.0 - smoothstep(0.25, 0.95, far);
    float line = max(0.3 * lines(spacing, 1.0), 0.75 * lines(10.0 * spacing, 1.3));
    float cover = gl_FrontFacing ? fill : 0.35 * fill;
    float alpha = fade * mix(cover, 1.0, line);
    if (alpha < 0.004) discard;
    gl_FragColor = vec4(mix(fillColor, lineColor, line / max(mix(cover, 1.0, line), 1e-3)), alpha);
    #include <colorspace_fragment>
  }`;

/** 1, 2 or 5 times a power of ten, at most `x`. */
export function roundBelow(x) {
  const power = 10 ** Math.floor(Math.log10(x));
  const step = [5, 2, 1].find((k) => k * power <= x * (1 + 1e-9)) ?? 1;
  return step * power;
}

/** A plane through a point: a grid when `fill` is 0, a floor otherwise. */
class Plane {
  constructor(point, normal, { fill, theme, reach }) {
    this.group = new Group();
    this.point = new Vector3(...point);
    this.normal = new Vector3(...normal).normalize();
    this.material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: {
        reach: { value: reach },
        spacing: { value: 1 },
        fill: { value: fill },
        center: { value: [0, 0] },
        lineColor: { value: theme.color('--grid') },
        fillColor: { value: theme.color('--floor') },
      },
      transparent: true,
      depthWrite: fill > 0,
      side: DoubleSide,
    });
    const mesh = new Mesh(new PlaneGeometry(2, 2), this.material);
    mesh.frustumCulled = false;
    mesh.renderOrder = -10;
    this.group.add(mesh);
    this.group.position.copy(this.point);
    this.group.quaternion.setFromUnitVectors(Z, this.normal);
  }

  setView(spacing, reach, target) {
    const { uniforms } = this.material;
    uniforms.spacing.value = spacing;
    uniforms.reach.value = reach;
    const local = target.clone().sub(this.point).applyQuaternion(this.group.quaternion.clone().invert());
    uniforms.center.value = [local.x, local.y];
    // The plane follows the eye in whole squares, so that lines stay where they are in the world.
    const square = 10 * spacing;
    const shift = new Vector3(Math.round(local.x / square) * square, Math.round(local.y / square) * square, 0);
    uniforms.center.value = [local.x - shift.x, local.y - shift.y];
    this.group.position.copy(shift.applyQuaternion(this.group.quaternion).add(this.point));
  }
}

/** In a planar scene a half-space is the filled side of a line. */
function planarHalfSpace(point, normal, { reach, theme }) {
  const group = new Group();
  const [nx, ny] = normal;
  const length = Math.hypot(nx, ny) || 1;
  const fill = new MeshBasicMaterial({ color: theme.color('--floor'), side: DoubleSide });
  const mesh = new Mesh(new PlaneGeometry(2, 1).translate(0, -0.5, 0), fill);
  mesh.scale.set(reach, reach, 1);
  const line = segments(new Outline().segment([-reach, 0, 0], [reach, 0, 0]).toArray(), {
    color: theme.color('--link'),
    width: 2,
  });
  group.add(mesh, line);
  group.position.set(point[0], point[1], -0.001 * reach);
  group.quaternion.setFromAxisAngle(Z, Math.atan2(ny / length, nx / length) - Math.PI / 2);
  return group;
}

export class Ground {
  /**
   * @param {{point: number[], normal: number[]}[]} halfSpaces
   * @param {{planar: boolean, level: number, reach: number}} stage where to put a grid when there is no floor
   */
  constructor(halfSpaces, { planar, level, reach, theme }) {
    this.group = new Group();
    this.grid = new Group();
    this.planes = [];
    this.group.add(this.grid);
    const solid = planar ? [] : halfSpaces;
    if (planar) {
      for (const { point, normal } of halfSpaces) this.group.add(planarHalfSpace(point, normal, { reach, theme }));
    }
    for (const { point, normal } of solid) {
      const plane = new Plane(point, normal, { fill: 1, theme, reach });
      this.planes.push(plane);
      this.group.add(plane.group);
    }
    if (solid.length === 0) {
      const plane = new Plane(planar ? [0, 0, -0.01 * reach] : [0, 0, level], [0, 0, 1], { fill: 0, theme, reach });
      this.planes.push(plane);
      this.grid.add(plane.group);
    }
  }

  setView(spacing, reach, target) {
    for (const plane of this.planes) plane.setView(spacing, reach, target);
  }

  /** The plane that takes the shadows: the first floor, or the grid. */
  get shadowPlane() {
    return this.planes[0];
  }
}

/** Flattens everything onto a plane along the light, for shadows that need no shadow map. */
export function flatten(plane, light, lift) {
  const n = plane.normal;
  const d = -n.dot(plane.point) - lift;
  const dot = n.dot(light);
  const m = new Matrix4();
  m.set(
    dot - light.x * n.x, -light.x * n.y, -light.x * n.z, -light.x * d,
    -light.y * n.x, dot - light.y * n.y, -light.y * n.z, -light.y * d,
    -light.z * n.x, -light.z * n.y, dot - light.z * n.z, -light.z * d,
    0, 0, 0, dot,
  );
  return m;
}

/** Darkens each pixel once, however many flattened surfaces cover it. */
export function shadowMaterial(theme) {
  return new MeshBasicMaterial({
    color: theme.color('--shadow'),
    transparent: true,
    opacity: theme.dark ? 0.42 : 0.13,
    depthWrite: false,
    side: DoubleSide,
    stencilWrite: true,
    stencilFunc: EqualStencilFunc,
    stencilRef: 0,
    stencilZPass: IncrementStencilOp,
    stencilFail: KeepStencilOp,
    stencilZFail: KeepStencilOp,
  });
}
