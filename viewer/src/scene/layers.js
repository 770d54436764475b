// Everything that can be shown or hidden: its key, its name, and the channels it needs.

/**
 * Vector channels drawn as arrows. `axial`: in a planar scene they point along z and are drawn as arcs, at radius `arc`.
 * An arrow of ordinary size is `length` long, in units of the scene. ω is short and thick, L long and slender: where
 * they are parallel, both are seen.
 */
export const VECTORS = [
  { layer: 'omega', channel: 'angular_velocity', symbol: 'ω', color: '--omega', unit: 'rad/s', length: 1.55, weight: 1.9, axial: true, arc: 1.08 },
  { layer: 'momentum', channel: 'angular_momentum', symbol: 'L', color: '--momentum', unit: 'kg·m²/s', length: 1.9, weight: 1.1, axial: true, arc: 1.28 },
  { layer: 'velocity', channel: 'velocity', symbol: 'v', color: '--velocity', unit: 'm/s', length: 1.7 },
  { layer: 'force', channel: 'force', symbol: 'F', color: '--force', unit: 'N', length: 1.4 },
  { layer: 'torque', channel: 'torque', symbol: 'τ', color: '--torque', unit: 'N·m', length: 1.6, axial: true, arc: 1.48 },
];

export const LAYERS = [
  { name: 'axes', key: 'a', text: 'Body axes', color: '--x', needs: ['rotation'] },
  { name: 'omega', key: 'w', text: 'Angular velocity ω', color: '--omega', needs: ['angular_velocity'] },
  { name: 'momentum', key: 'l', text: 'Angular momentum L', color: '--momentum', needs: ['angular_momentum'] },
  { name: 'velocity', key: 'v', text: 'Velocity v', color: '--velocity', needs: ['velocity'] },
  { name: 'force', key: 'f', text: 'Force F', color: '--force', needs: ['force'] },
  { name: 'torque', key: 't', text: 'Torque τ', color: '--torque', needs: ['torque'] },
  { name: 'path', key: 'p', text: 'Path of the centre of mass', color: '--path', needs: ['position'] },
  { name: 'frenet', key: 'n', text: 'Frenet frame T N B', color: '--tangent', needs: ['tangent', 'normal'] },
  { name: 'parallel', key: 'b', text: 'Parallel frame T U V', color: '--parallel', needs: ['tangent', 'parallel'] },
  { name: 'trail', key: 's', text: 'Trails of the body axes', color: '--y', needs: ['rotation'] },
  { name: 'polhode', key: 'o', text: 'Polhode and ellipsoid', color: '--omega', needs: ['angular_velocity'], inertia: true, space: true },
  { name: 'herpolhode', key: 'h', text: 'Herpolhode and plane', color: '--herpolhode', needs: ['angular_velocity'], inertia: true, space: true },
  { name: 'follow', key: 'x', text: 'Camera goes with the body', color: '--ink-soft', needs: ['position'] },
  { name: 'grid', key: 'g', text: 'Ground grid', color: '--grid', needs: [] },
];

function moves(recording, body) {
  return recording.bodies[body].kind !== 'fixed';
}

/** Layers at least one of the recordings can show. */
export function availableLayers(recordings) {
  return LAYERS.filter((layer) =>
    recordings.some((recording) => {
      if (layer.space && recording.planar) return false;
      if (layer.inertia && !recording.bodies.some((body, k) => body.inertia && moves(recording, k))) return false;
      if (layer.name !== 'grid' && !recording.bodies.some((_, k) => moves(recording, k))) return false;
      const vector = VECTORS.find((one) => one.layer === layer.name);
      if (vector) return recording.largest(vector.channel) > 0;
      return layer.needs.every((channel) => recording.has(channel));
    }),
  );
}

/** What to show at first: what the recordings ask for (`show` in the header), else what this scene is about. */
export function defaultLayers(recordings, available, { travels, turns }) {
  const asked = recordings.map((recording) => recording.header.show).filter(Array.isArray);
  const names = available.map((layer) => layer.name);
  if (asked.length) return new Set(names.filter((name) => name === 'grid' || asked.some((list) => list.includes(name))));
  const on = new Set(['grid']);
  const few = recordings.every((recording) => recording.bodies.filter((_, k) => moves(recording, k)).length <= 4);
  if (turns && few) on.add('axes').add('omega').add('momentum');
  if (few) on.add('force').add('torque');
  if (travels && few) on.add('path');
  return new Set(names.filter((name) => on.has(name)));
}
