import {
  BufferGeometry,
  Float32BufferAttribute,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
} from 'three';
import type { Frame } from './play';

const PLANE = { light: '#dde3e8', dark: '#1f252b' } as const;
const LINE = { light: '#aab4bd', dark: '#3d4852' } as const;
const CELLS = 60;

/** A floor with a grid, which replaces the floor planes of a world. */
export interface Floor {
  root: Group;
  /** Puts the floor at a height in metres and selects the size of a cell. */
  fit: (height: number, frame: Frame) => void;
  setDark: (dark: boolean) => void;
  dispose: () => void;
}

export function createFloor(): Floor {
  const root = new Group();
  // The plane and the grid are drawn first, in this order, so that neither hides the other.
  const planeMaterial = new MeshBasicMaterial({ depthWrite: false });
  const plane = new Mesh(new PlaneGeometry(CELLS, CELLS), planeMaterial);
  plane.rotation.x = -Math.PI / 2;
  plane.renderOrder = -2;
  const lineMaterial = new LineBasicMaterial({ depthWrite: false });
  const grid = new LineSegments(gridGeometry(), lineMaterial);
  grid.renderOrder = -1;
  root.add(plane, grid);
  return {
    root,
    fit(height, { center, radius }) {
      const cell = cellSize(radius);
      root.scale.set(cell, 1, cell);
      // On multiples of a cell, so that lines are at round coordinates.
      root.position.set(
        Math.round(center.x / cell) * cell,
        height,
        Math.round(center.z / cell) * cell,
      );
    },
    setDark(dark) {
      const scheme = dark ? 'dark' : 'light';
      planeMaterial.color.set(PLANE[scheme]);
      lineMaterial.color.set(LINE[scheme]);
    },
    dispose() {
      plane.geometry.dispose();
      planeMaterial.dispose();
      grid.geometry.dispose();
      lineMaterial.dispose();
    },
  };
}

/** The size of a cell in metres, a power of ten or half of it, such as 0.1, 0.5 or 1. */
export function cellSize(radius: number): number {
  const power = 10 ** Math.floor(Math.log10(radius));
  return radius / power >= 5 ? power : power / 2;
}

function gridGeometry(): BufferGeometry {
  const half = CELLS / 2;
  const points: number[] = [];
  // A segment for each cell: drivers may clip long lines that begin behind the camera.
  for (let i = -half; i <= half; i++) {
    for (let j = -half; j < half; j++) {
      points.push(i, 0, j, i, 0, j + 1, j, 0, i, j + 1, 0, i);
    }
  }
  return new BufferGeometry().setAttribute('position', new Float32BufferAttribute(points, 3));
}
