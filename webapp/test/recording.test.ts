// @vitest-environment node
import { expect, test } from 'vitest';
import { frameAt, readingsIn, readRecording, spreadFrames } from '@/features/replay/recording';
import { recordingGlb } from './support/glb';

function read(change?: (gltf: Record<string, unknown>) => void) {
  return readRecording(recordingGlb(change).buffer as ArrayBuffer);
}

test('a recording has times, devices and readings', () => {
  const recording = read();
  expect(recording.world).toBe('test.world.yaml');
  expect([...recording.times]).toEqual([0, 0.5, 1]);
  expect(recording.columns).toEqual(['front.range']);
  expect([0, 1, 2].map((frame) => readingsIn(recording, frame))).toEqual([[2], [1.5], [1]]);
});

test.each([
  [-1, 0],
  [0, 0],
  [0.49, 0],
  [0.5, 1],
  [0.99, 1],
  [1, 2],
  [9, 2],
])('at %d s the frame is %d', (time, frame) => {
  expect(frameAt(read(), time)).toBe(frame);
});

test('frames are distributed from the first to the last', () => {
  const recording = { ...read(), times: new Float32Array(1001) };
  expect(spreadFrames(recording, 5)).toEqual([0, 250, 500, 750, 1000]);
  expect(spreadFrames(read(), 5)).toEqual([0, 1, 2]);
  expect(spreadFrames(read(), 1)).toEqual([0]);
});

test.each<[string, (gltf: Record<string, unknown>) => void]>([
  ['an image', (gltf) => (gltf['images'] = [{ uri: 'https://elsewhere.example/x.png' }])],
  ['an external buffer', (gltf) => (gltf['buffers'] = [{ byteLength: 96, uri: '/api/v1/users' }])],
  ['an extension', (gltf) => (gltf['extensionsUsed'] = ['X_anything'])],
])('%s is refused', (_, change) => {
  expect(() => read(change)).toThrow('refers to other files');
});

test('other files are refused', () => {
  const glb = recordingGlb();
  expect(() => readRecording(glb.buffer.slice(0, 100) as ArrayBuffer)).toThrow('not a binary glTF');
  expect(() => readRecording(new ArrayBuffer(0))).toThrow('not a binary glTF');
  expect(() => read((gltf) => delete gltf['scenes'])).toThrow('not a recording');
  expect(() => read((gltf) => (gltf['bufferViews'] = []))).toThrow('do not match');
});
