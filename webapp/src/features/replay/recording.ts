/** A device of the world and the body that it is attached to, if any. */
export interface Device {
  name: string;
  kind: string;
  body?: string;
}

/** The motion of a case and the readings of its devices. Frame `i` is at `times[i]`. */
export interface Recording {
  /** The binary glTF file. */
  glb: ArrayBuffer;
  /** File of the world's description. */
  world: string;
  devices: readonly Device[];
  /** Seconds of simulation time, ascending; at least one. */
  times: Float32Array;
  /** `DEVICE.FIELD`, and the names of observations. */
  columns: readonly string[];
  /** `columns.length` readings per frame. */
  rows: Float32Array;
}

interface BufferView {
  byteOffset?: number;
  byteLength: number;
}

interface Gltf {
  buffers?: { uri?: string }[];
  images?: unknown[];
  extensionsUsed?: unknown[];
  bufferViews?: BufferView[];
  scenes?: {
    extras?: {
      world?: string;
      devices?: Device[];
      readings?: { columns: string[]; times: number; rows: number };
    };
  }[];
}

const MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;
const HEADER_BYTES = 12;
const CHUNK_HEADER_BYTES = 8;

/**
 * Reads a recording. It is untrusted, because the component under test could have changed it: files
 * with external references are rejected.
 *
 * @throws Error if the file is not a recording
 */
export function readRecording(glb: ArrayBuffer): Recording {
  const view = new DataView(glb);
  const start = HEADER_BYTES + CHUNK_HEADER_BYTES;
  if (
    glb.byteLength < start ||
    view.getUint32(0, true) !== MAGIC ||
    view.getUint32(8, true) !== glb.byteLength ||
    view.getUint32(16, true) !== JSON_CHUNK
  ) {
    throw new Error('The file is not a binary glTF file.');
  }
  const jsonBytes = view.getUint32(HEADER_BYTES, true);
  const gltf = JSON.parse(new TextDecoder().decode(new Uint8Array(glb, start, jsonBytes))) as Gltf;
  if (
    gltf.images !== undefined ||
    gltf.extensionsUsed !== undefined ||
    gltf.buffers?.some(({ uri }) => uri !== undefined)
  ) {
    throw new Error('The file refers to other files.');
  }
  const extras = gltf.scenes?.[0]?.extras;
  const readings = extras?.readings;
  if (!extras || !readings) throw new Error('The file is not a recording of a case.');
  const binary = start + jsonBytes + CHUNK_HEADER_BYTES;
  const times = floats(glb, binary, gltf.bufferViews?.[readings.times]);
  const rows = floats(glb, binary, gltf.bufferViews?.[readings.rows]);
  if (times.length === 0 || rows.length !== times.length * readings.columns.length) {
    throw new Error('The readings do not match the frames of the recording.');
  }
  return {
    glb,
    world: extras.world ?? '',
    devices: extras.devices ?? [],
    times,
    columns: readings.columns,
    rows,
  };
}

/** The last frame at or before a time. */
export function frameAt({ times }: Recording, time: number): number {
  let low = 0;
  let high = times.length - 1;
  while (low < high) {
    const middle = Math.ceil((low + high) / 2);
    if ((times[middle] ?? Infinity) <= time) low = middle;
    else high = middle - 1;
  }
  return low;
}

/** The readings of a frame, by column. */
export function readingsIn({ columns, rows }: Recording, frame: number): number[] {
  return [...rows.subarray(frame * columns.length, (frame + 1) * columns.length)];
}

/** At max `max` frames, evenly distributed, including the first and the last. */
export function spreadFrames({ times }: Recording, max: number): number[] {
  const count = Math.min(max, times.length);
  const step = count > 1 ? (times.length - 1) / (count - 1) : 0;
  return Array.from({ length: count }, (_, index) => Math.round(index * step));
}

function floats(glb: ArrayBuffer, binary: number, view: BufferView | undefined): Float32Array {
  if (!view) return new Float32Array();
  const from = binary + (view.byteOffset ?? 0);
  // A copy, because the offset need not be a multiple of four.
  return new Float32Array(glb.slice(from, from + view.byteLength));
}
