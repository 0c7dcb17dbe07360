import type { CaseSignals, ResultCase } from '@/shared/api';

export type Trajectory = ResultCase['trajectories'][number];

/** What a recording knows about the devices: `columns.length` readings at each time. */
export interface RecordedReadings {
  /** Seconds of simulation time. */
  times: Float32Array;
  columns: readonly string[];
  rows: Float32Array;
}

/** A signal over time. */
export interface Lane {
  name: string;
  /** Empty if it is not known. */
  unit: string;
  /** Seconds after the call, ascending. */
  times: readonly number[];
  /** Null for a value that is not finite. */
  values: readonly (number | null)[];
}

/** A trajectory condition of the case. */
export interface Condition {
  name: string;
  /** The interval of its outermost operators, in seconds after the call. */
  from: number;
  to: number;
  signals: readonly string[];
  /** Its result; absent while the build runs. */
  result?: Trajectory | undefined;
}

/**
 * The simulation time of the call, at which the signals have the time 0. Recording and signals both
 * end with the state at the end of the case.
 */
export function callTime(signals: CaseSignals | null, readings: RecordedReadings): number {
  const end = readings.times.at(-1) ?? 0;
  const last = signals?.times.at(-1);
  return last === undefined ? (readings.times[0] ?? 0) : end - last;
}

/** The conditions, those that are violated first. */
export function conditionsOf(
  signals: CaseSignals | null,
  results: readonly Trajectory[],
): Condition[] {
  const all = (signals?.conditions ?? []).map((condition) => ({
    ...condition,
    result: results.find(({ name }) => name === condition.name),
  }));
  return [...all.filter(isViolated), ...all.filter((condition) => !isViolated(condition))];
}

export function isViolated({ result }: Condition): boolean {
  return result?.verdict === 'FAIL';
}

/**
 * All signals: first those of the conditions, in their order, then the readings of the recording,
 * which are sampled less often.
 */
export function lanesOf(
  signals: CaseSignals | null,
  conditions: readonly Condition[],
  readings: RecordedReadings | null,
): Lane[] {
  const used = [...new Set(conditions.flatMap((condition) => condition.signals))];
  const rank = ({ name }: Lane) => (used.includes(name) ? used.indexOf(name) : used.length);
  const sampled: Lane[] = (signals?.signals ?? []).map((signal) => ({
    ...signal,
    times: signals?.times ?? [],
  }));
  const lanes = sampled.toSorted((a, b) => rank(a) - rank(b));
  if (!readings) return lanes;
  const begin = callTime(signals, readings);
  const times = Array.from(readings.times, (time) => time - begin);
  const recorded = readings.columns
    .map((name, column) => ({
      name,
      unit: '',
      times,
      values: times.map((_, frame) =>
        finite(readings.rows[frame * readings.columns.length + column]),
      ),
    }))
    .filter(({ name }) => !lanes.some((lane) => lane.name === name));
  return [...lanes, ...recorded];
}

function finite(value: number | undefined): number | null {
  return value !== undefined && Number.isFinite(value) ? value : null;
}

/** The common time axis, in seconds after the call. */
export function timeRange(lanes: readonly Lane[]): [from: number, to: number] {
  const from = Math.min(...lanes.map(({ times }) => times[0] ?? 0));
  const to = Math.max(...lanes.map(({ times }) => times.at(-1) ?? 0));
  return [from, to > from ? to : from + 1];
}

/** The last value at or before a time; undefined before the first sample. */
export function valueAt({ times, values }: Lane, time: number): number | null | undefined {
  let low = 0;
  let high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    // Times of a recording are 32-bit floats.
    if ((times[middle] ?? Infinity) <= time + 1e-6) low = middle + 1;
    else high = middle;
  }
  return values[low - 1];
}

/** Whether all values are 0 or 1, as of a boolean signal. */
export function isBinary({ values }: Lane): boolean {
  return values.every((value) => value === 0 || value === 1);
}
