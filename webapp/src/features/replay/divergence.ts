import type { Recording } from './recording';

interface Accessor {
  bufferView?: number;
  byteOffset?: number;
  componentType?: number;
  count?: number;
  type?: string;
}

interface Animated {
  nodes?: { name?: string }[];
  accessors?: Accessor[];
  bufferViews?: { byteOffset?: number; byteLength: number }[];
  animations?: {
    channels?: { sampler?: number; target?: { node?: number; path?: string } }[];
    samplers?: { output?: number }[];
  }[];
}

/** One quantity over the frames of a recording, `width` numbers per frame. */
interface Track {
  width: number;
  values: Float32Array;
}

const JSON_START = 20;
const CHUNK_HEADER_BYTES = 8;
const FLOAT = 5126;
const WIDTHS: Record<string, number> = { SCALAR: 1, VEC3: 3, VEC4: 4 };

/** Numbers that are closer than this part of their size are equal: recordings hold 32-bit floats. */
const TOLERANCE = 1e-6;

export interface Divergence {
  /** The first frame that differs. */
  frame: number;
  /** Seconds since the begin of the recording. */
  seconds: number;
  /** A reading or a body that differs there. */
  what: string;
}

/**
 * The first frame in which two recordings differ: readings, positions or rotations that both have,
 * or the end of the shorter one. Undefined if there is none.
 */
export function divergenceOf(one: Recording, other: Recording): Divergence | undefined {
  const frames = Math.min(one.times.length, other.times.length);
  const ours = tracksOf(one);
  const theirs = tracksOf(other);
  let first: Divergence | undefined;
  for (const [what, track] of ours) {
    const counterpart = theirs.get(what);
    if (counterpart?.width !== track.width) continue;
    const frame = firstDifference(track, counterpart, first?.frame ?? frames);
    if (frame !== undefined) first = { frame, seconds: secondsOf(one, frame), what };
  }
  if (first === undefined && one.times.length !== other.times.length) {
    return {
      frame: frames - 1,
      seconds: secondsOf(one, frames - 1),
      what: 'the end of the shorter recording',
    };
  }
  return first;
}

function secondsOf({ times }: Recording, frame: number): number {
  return (times[frame] ?? 0) - (times[0] ?? 0);
}

/** The first frame before `limit` that differs. */
function firstDifference(one: Track, other: Track, limit: number): number | undefined {
  const { width } = one;
  const length = Math.min(limit * width, one.values.length, other.values.length);
  for (let index = 0; index < length; index++) {
    const a = one.values[index] ?? NaN;
    const b = other.values[index] ?? NaN;
    const same =
      Object.is(a, b) || Math.abs(a - b) <= TOLERANCE * Math.max(1, Math.abs(a), Math.abs(b));
    if (!same) return Math.floor(index / width);
  }
  return undefined;
}

function tracksOf(recording: Recording): Map<string, Track> {
  const tracks = new Map<string, Track>();
  const { columns, rows, times } = recording;
  columns.forEach((name, column) => {
    const values = new Float32Array(times.length);
    for (let frame = 0; frame < times.length; frame++) {
      values[frame] = rows[frame * columns.length + column] ?? NaN;
    }
    tracks.set(name, { width: 1, values });
  });
  const view = new DataView(recording.glb);
  const jsonBytes = view.getUint32(12, true);
  const gltf = JSON.parse(
    new TextDecoder().decode(new Uint8Array(recording.glb, JSON_START, jsonBytes)),
  ) as Animated;
  const binary = JSON_START + jsonBytes + CHUNK_HEADER_BYTES;
  for (const { channels = [], samplers = [] } of gltf.animations ?? []) {
    for (const { sampler, target } of channels) {
      const output = sampler === undefined ? undefined : samplers[sampler]?.output;
      const track = output === undefined ? undefined : floats(recording.glb, binary, gltf, output);
      const body = target?.node === undefined ? undefined : gltf.nodes?.[target.node]?.name;
      // Only one value per frame can be compared by frame.
      if (track && body !== undefined && track.values.length === times.length * track.width) {
        tracks.set(`the ${target?.path ?? 'motion'} of ${body}`, track);
      }
    }
  }
  return tracks;
}

function floats(
  glb: ArrayBuffer,
  binary: number,
  gltf: Animated,
  index: number,
): Track | undefined {
  const accessor = gltf.accessors?.[index];
  const view =
    accessor?.bufferView === undefined ? undefined : gltf.bufferViews?.[accessor.bufferView];
  const width = WIDTHS[accessor?.type ?? ''];
  if (!accessor || !view || !width || accessor.componentType !== FLOAT) return undefined;
  const from = binary + (view.byteOffset ?? 0) + (accessor.byteOffset ?? 0);
  const length = (accessor.count ?? 0) * width;
  if (from + length * 4 > glb.byteLength) return undefined;
  return { width, values: new Float32Array(glb.slice(from, from + length * 4)) };
}
