import { Group } from 'three';
import { Line2 } from 'three/addons/lines/Line2.js';
import { LineGeometry } from 'three/addons/lines/LineGeometry.js';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import type { PathPoint } from './play';

const WIDTH_PX = 3;

/** The path of a body: the part up to the current time is opaque, the rest is faint. */
export interface Trail {
  root: Group;
  showUntil: (time: number) => void;
  /** Sets the size of the canvas in pixels, on which the width of the line depends. */
  setResolution: (width: number, height: number) => void;
  dispose: () => void;
}

export function createTrail(path: readonly PathPoint[], color: string): Trail {
  const root = new Group();
  const geometry = new LineGeometry();
  const past = new LineMaterial({ color, linewidth: WIDTH_PX, fog: false });
  const future = new LineMaterial({
    color,
    linewidth: WIDTH_PX,
    transparent: true,
    opacity: 0.3,
    fog: false,
  });
  const pastGeometry = new LineGeometry();
  if (path.length > 1) {
    const points = path.flatMap(({ point: { x, y, z } }) => [x, y, z]);
    geometry.setPositions(points);
    pastGeometry.setPositions(points);
    root.add(new Line2(geometry, future), new Line2(pastGeometry, past));
  }
  return {
    root,
    showUntil(time) {
      const next = path.findIndex((point) => point.time > time);
      // A segment connects two points.
      pastGeometry.instanceCount = Math.max(0, (next < 0 ? path.length : next) - 1);
    },
    setResolution(width, height) {
      past.resolution.set(width, height);
      future.resolution.set(width, height);
    },
    dispose() {
      geometry.dispose();
      pastGeometry.dispose();
      past.dispose();
      future.dispose();
    },
  };
}
