// @vitest-environment node
import { expect, test } from 'vitest';
import {
  callTime,
  conditionsOf,
  isBinary,
  lanesOf,
  timeRange,
  valueAt,
} from '@/features/signals/lanes';
import { plotOption } from '@/features/signals/option';
import { caseSignals, TRAJECTORIES } from './support/samples';

/** A recording from 0 to 1.5 s; the call is at 0.5 s. */
const READINGS = {
  times: new Float32Array([0, 0.75, 1.5]),
  columns: ['front.range', 'bumped'],
  rows: new Float32Array([2, 0, 1.5, 1, Infinity, 0]),
};

function lanes() {
  const conditions = conditionsOf(caseSignals(), TRAJECTORIES);
  return lanesOf(caseSignals(), conditions, READINGS);
}

test('the call is where the ends of recording and signals agree', () => {
  expect(callTime(caseSignals(), READINGS)).toBe(0.5);
  expect(callTime(null, READINGS)).toBe(0);
});

test('violated conditions are first, and their signals', () => {
  const conditions = conditionsOf(caseSignals(), TRAJECTORIES);
  expect(conditions.map(({ name, result }) => [name, result?.verdict])).toEqual([
    ['never touches', 'FAIL'],
    ['stops', 'PASS'],
  ]);
  expect(lanes().map(({ name }) => name)).toEqual([
    'bumped',
    'base.linear.command',
    'lidar.range',
    'front.range',
  ]);
});

test('readings of the recording are on the same time axis', () => {
  const lane = lanes()[3];
  expect(lane?.times).toEqual([-0.5, 0.25, 1]);
  expect(lane?.values).toEqual([2, 1.5, null]);
  expect(timeRange(lanes())).toEqual([-0.5, 1]);
});

test('without stored signals the readings of the recording remain', () => {
  const recorded = lanesOf(null, [], READINGS);
  expect(recorded.map(({ name }) => name)).toEqual(['front.range', 'bumped']);
  expect(timeRange(recorded)).toEqual([0, 1.5]);
});

test.each([
  [-1, undefined],
  [-0.5, 0],
  [0.499, 0],
  [0.5, 1],
  [0.7, 1],
  [9, 0],
])('a signal holds its last value: at %d s it is %s', (time, value) => {
  const [bumped] = lanes();
  expect(bumped && valueAt(bumped, time)).toBe(value);
});

test('booleans and commands are steps, other signals are lines', () => {
  expect(lanes().map(isBinary)).toEqual([true, false, false, false]);
  const { series } = plotOption(lanes(), [-0.5, 1]) as {
    series: { step?: string; data: unknown[][] }[];
  };
  expect(series.map(({ step }) => step)).toEqual(['end', 'end', undefined, undefined]);
  expect(series[2]?.data[2]).toEqual([0.4, '-']);
});
