// The one camera of the page, for all its views: it looks at a target from an angle, z up. A planar scene is
// looked at face on, without perspective.

import { MathUtils, OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';

const FIELD = 32;
const HALF = Math.tan(MathUtils.degToRad(FIELD / 2));
const STEEPEST = MathUtils.degToRad(89);
const AZIMUTH = MathUtils.degToRad(-58);
const ELEVATION = MathUtils.degToRad(20);
/** Free space around what is shown. */
const MARGIN = 1.07;

export class Rig {
  /** `spheres`, a list of {point, radius}, are what the camera shows at first. */
  constructor({ planar, center, spheres }) {
    this.planar = planar;
    this.setHome({ center, spheres });
    this.camera = planar ? new OrthographicCamera() : new PerspectiveCamera(FIELD);
    this.camera.up.set(0, planar ? 1 : 0, planar ? 0 : 1);
    this.reset();
  }

  setHome({ center, spheres }) {
    this.home = { center: new Vector3(...center), spheres, fits: new Map() };
  }

  reset() {
    this.azimuth = AZIMUTH;
    this.elevation = ELEVATION;
    this.zoom = 1;
    this.pan = new Vector3();
  }

  orbit(right, up) {
    this.azimuth -= right;
    this.elevation = Math.min(STEEPEST, Math.max(-STEEPEST, this.elevation + up));
  }

  /** `factor` > 1 goes nearer. */
  zoomBy(factor) {
    this.zoom = Math.min(400, Math.max(0.02, this.zoom * factor));
  }

  /** Shifts what is looked at by pixels of a view `height` pixels high. */
  panBy(right, up, height, aspect) {
    const metres = (2 * HALF * this.distance(aspect)) / height;
    const across = new Vector3(1, 0, 0).applyQuaternion(this.camera.quaternion);
    const upward = new Vector3(0, 1, 0).applyQuaternion(this.camera.quaternion);
    this.pan.addScaledVector(across, -right * metres).addScaledVector(upward, -up * metres);
    if (this.planar) this.pan.z = 0;
  }

  /** From the eye to what is looked at [m]; `growth` moves back from a body that outgrew its size. */
  distance(aspect, growth = 1) {
    return (this.fit(aspect) * growth) / this.zoom;
  }

  /** The distance at which all spheres are inside a view of this shape, from the first direction. */
  fit(aspect) {
    const { center, spheres, fits } = this.home;
    const key = aspect.toFixed(3);
    if (fits.has(key)) return fits.get(key);
    const [right, up, back] = this.planar
      ? [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)]
      : axes(AZIMUTH, ELEVATION);
    const slant = Math.cos(Math.atan(HALF));
    const slantWide = Math.cos(Math.atan(HALF * aspect));
    let distance = 0;
    for (const { point, radius } of spheres) {
      const p = new Vector3(...point).sub(center);
      const [x, y] = [Math.abs(p.dot(right)), Math.abs(p.dot(up))];
      const near = this.planar ? 0 : p.dot(back);
      // A sphere touches the edge of the view along a slanted line, so it needs a little more than its radius.
      const wide = (x + radius / (this.planar ? 1 : slantWide)) / (HALF * aspect) + near;
      const high = (y + radius / (this.planar ? 1 : slant)) / HALF + near;
      distance = Math.max(distance, wide, high);
    }
    fits.set(key, MARGIN * distance);
    return MARGIN * distance;
  }

  /** Aims the camera for one view. Returns metres per pixel at the target. */
  aim({ aspect, height, growth, follow }) {
    const target = (follow ?? this.home.center).clone().add(this.pan);
    const distance = this.distance(aspect, growth);
    const { camera } = this;
    this.target = target;
    if (this.planar) {
      const half = HALF * distance;
      Object.assign(camera, { left: -half * aspect, right: half * aspect, top: half, bottom: -half });
      Object.assign(camera, { near: 0.01 * distance, far: 4 * distance });
      camera.position.set(target.x, target.y, target.z + 2 * distance);
    } else {
      camera.aspect = aspect;
      camera.near = distance * 0.01;
      camera.far = distance * 60;
      const flat = Math.cos(this.elevation);
      camera.position.set(
        target.x + distance * flat * Math.cos(this.azimuth),
        target.y + distance * flat * Math.sin(this.azimuth),
        target.z + distance * Math.sin(this.elevation),
      );
    }
    camera.lookAt(target);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
    return { distance, metresPerPixel: (2 * HALF * distance) / height };
  }

  /** Size a thing at `point` must have to be `pixels` high. */
  sizeOf(pixels, point, height) {
    const away = this.planar
      ? this.camera.top / HALF
      : Math.max(this.camera.near, this.camera.worldToLocal(point.clone()).z * -1);
    return (pixels * 2 * HALF * away) / height;
  }
}

/** Right, up and towards the eye, for a camera at these angles around z. */
function axes(azimuth, elevation) {
  const back = new Vector3(
    Math.cos(elevation) * Math.cos(azimuth),
    Math.cos(elevation) * Math.sin(azimuth),
    Math.sin(elevation),
  );
  const right = new Vector3(-Math.sin(azimuth), Math.cos(azimuth), 0);
  return [right, back.clone().cross(right), back];
}
