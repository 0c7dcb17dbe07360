const HEADER_BYTES = 12;
const CHUNK_HEADER_BYTES = 8;

/**
 * A recording of a body that moves one metre in one second, and of a range sensor. `change` edits
 * the glTF, `rows` are the readings, and `middle` is the position after half a second.
 */
export function recordingGlb(
  change: (gltf: Record<string, unknown>) => void = () => {},
  rows: readonly number[] = [2, 1.5, 1],
  middle = 0.5,
): Uint8Array {
  const times = [0, 0.5, 1];
  const positions = [0, 0, 0, middle, 0, 0, 1, 0, 0];
  const corners = [0, 0, 0, 1, 0, 0, 0, 1, 0];
  const binary = new Float32Array([...times, ...positions, ...corners, ...rows]);
  const gltf = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [
      {
        nodes: [0],
        extras: {
          world: 'test.world.yaml',
          devices: [{ name: 'front', kind: 'range', body: 'robot' }],
          readings: { columns: ['front.range'], times: 0, rows: 3 },
        },
      },
    ],
    nodes: [
      { name: 'world', children: [1] },
      { name: 'robot', mesh: 0 },
    ],
    meshes: [{ primitives: [{ attributes: { POSITION: 2 } }] }],
    animations: [
      {
        name: 'case',
        samplers: [{ input: 0, output: 1, interpolation: 'LINEAR' }],
        channels: [{ sampler: 0, target: { node: 1, path: 'translation' } }],
      },
    ],
    buffers: [{ byteLength: binary.byteLength }],
    bufferViews: [
      { buffer: 0, byteOffset: 0, byteLength: 12 },
      { buffer: 0, byteOffset: 12, byteLength: 36 },
      { buffer: 0, byteOffset: 48, byteLength: 36 },
      { buffer: 0, byteOffset: 84, byteLength: 12 },
    ],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 3, type: 'SCALAR', min: [0], max: [1] },
      { bufferView: 1, componentType: 5126, count: 3, type: 'VEC3' },
      { bufferView: 2, componentType: 5126, count: 3, type: 'VEC3' },
    ],
  };
  change(gltf);
  const text = JSON.stringify(gltf);
  const json = new TextEncoder().encode(text.padEnd(Math.ceil(text.length / 4) * 4));
  const size = HEADER_BYTES + 2 * CHUNK_HEADER_BYTES + json.byteLength + binary.byteLength;
  const glb = new Uint8Array(size);
  const view = new DataView(glb.buffer);
  const words = [0x46546c67, 2, size, json.byteLength, 0x4e4f534a];
  words.forEach((word, index) => {
    view.setUint32(4 * index, word, true);
  });
  glb.set(json, 20);
  view.setUint32(20 + json.byteLength, binary.byteLength, true);
  view.setUint32(24 + json.byteLength, 0x004e4942, true);
  glb.set(new Uint8Array(binary.buffer), 28 + json.byteLength);
  return glb;
}
