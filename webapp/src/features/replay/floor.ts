import {
  CanvasTexture,
  Mesh,
  MeshLambertMaterial,
  PlaneGeometry,
  RepeatWrapping,
  SRGBColorSpace,
} from 'three';
import type { Frame } from './play';

const TILES = {
  light: { even: '#d3dbe3', odd: '#c6d0d9', line: '#9aa7b3', strong: '#7c8b99' },
  dark: { even: '#2a323a', odd: '#242b32', line: '#43505c', strong: '#5a6976' },
} as const;
/** Cells of the texture along a side; its border is a strong line. */
const CELLS = 10;
const TEXTURE_PX = 1024;
/** The floor ends beyond the haze. */
export const FLOOR_RADII = 220;

/** A floor with a grid, which replaces the floor planes of a world. */
export interface Floor {
  root: Mesh;
  /** Puts the floor at a height in metres and selects the size of a cell. */
  fit: (height: number, frame: Frame) => void;
  setDark: (dark: boolean) => void;
  dispose: () => void;
}

/** One textured plane: the graphics card filters a texture, but not thousands of lines at the horizon. */
export function createFloor(anisotropy: number): Floor {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = TEXTURE_PX;
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.anisotropy = anisotropy;
  // Drawn first and without depth, so that it hides no geometry that lies on the floor.
  const material = new MeshLambertMaterial({ map: texture, depthWrite: false });
  const plane = new Mesh(new PlaneGeometry(1, 1), material);
  plane.rotation.x = -Math.PI / 2;
  plane.renderOrder = -1;
  plane.receiveShadow = true;
  return {
    root: plane,
    fit(height, { center, radius }) {
      const tile = cellSize(2 * radius) * CELLS;
      const tiles = 2 * Math.ceil((radius * FLOOR_RADII) / tile);
      plane.scale.set(tiles * tile, tiles * tile, 1);
      texture.repeat.set(tiles, tiles);
      // On multiples of a tile, so that lines are at round coordinates.
      plane.position.set(
        Math.round(center.x / tile) * tile,
        height,
        Math.round(center.z / tile) * tile,
      );
    },
    setDark(dark) {
      paint(canvas, TILES[dark ? 'dark' : 'light']);
      texture.needsUpdate = true;
    },
    dispose() {
      plane.geometry.dispose();
      material.dispose();
      texture.dispose();
    },
  };
}

/** The size of a cell in metres, a power of ten or half of it, such as 0.1, 0.5 or 1. */
export function cellSize(radius: number): number {
  const power = 10 ** Math.floor(Math.log10(radius));
  return radius / power >= 5 ? power : power / 2;
}

function paint(canvas: HTMLCanvasElement, colours: (typeof TILES)['light' | 'dark']): void {
  const context = canvas.getContext('2d');
  if (!context) return;
  const size = TEXTURE_PX / CELLS;
  for (let row = 0; row < CELLS; row++) {
    for (let column = 0; column < CELLS; column++) {
      context.fillStyle = (row + column) % 2 === 0 ? colours.even : colours.odd;
      context.fillRect(column * size, row * size, Math.ceil(size), Math.ceil(size));
    }
  }
  for (let i = 0; i <= CELLS; i++) {
    const strong = i % CELLS === 0;
    const width = strong ? 5 : 2;
    context.fillStyle = strong ? colours.strong : colours.line;
    context.fillRect(i * size - width / 2, 0, width, TEXTURE_PX);
    context.fillRect(0, i * size - width / 2, TEXTURE_PX, width);
  }
}
