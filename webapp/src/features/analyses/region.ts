import type { Cause, Explanation } from '@/shared/api';

/** An executed case: literals in the order of the inputs. */
export interface ExecutedCase {
  values: readonly string[];
  failed: boolean;
}

export type CellState = 'fails' | 'passes' | 'both' | 'unknown';

/** What the executed cases did, over two inputs. */
export interface Region {
  x: string;
  y: string;
  columns: readonly string[];
  rows: readonly string[];
  /** By row, then by column. */
  cells: readonly (readonly CellState[])[];
}

const MAX_LEVELS = 24;

/** The causes that are one sentence: same boundary, same other values. Positions count from 1. */
export interface CauseGroup {
  first: Cause;
  position: number;
  cases: readonly number[];
}

export function groupsOf(causes: readonly Cause[]): CauseGroup[] {
  const groups = new Map<string, CauseGroup>();
  for (const [index, cause] of causes.entries()) {
    const key = cause.boundary ? cause.sentence : `${index}`;
    const known = groups.get(key);
    groups.set(
      key,
      known
        ? { ...known, cases: merged(known.cases, cause.cases) }
        : { first: cause, position: index + 1, cases: cause.cases },
    );
  }
  return [...groups.values()];
}

function merged(one: readonly number[], other: readonly number[]): number[] {
  return [...new Set([...one, ...other])].sort((a, b) => a - b);
}

/** The two inputs that tell most of a cause, and what failed over them; null if there are none. */
export function regionOf(
  cause: Cause,
  { inputs, further }: Explanation,
  cases: readonly ExecutedCase[],
): Region | null {
  const varying = inputs.filter(({ values }) => values.length > 1);
  const own = varying.filter(({ name }) => concerns(cause, name));
  const others = varying
    .filter((input) => !own.includes(input))
    .sort((a, b) => Number(b.numeric) - Number(a.numeric) || b.values.length - a.values.length);
  const [x, y] = [...own, ...others];
  if (cause.steps.length > 0 || own.length === 0 || !x || !y) return null;
  const columns = levelsOf(x, cause);
  const rows = levelsOf(y, cause);
  const at = (name: string) => inputs.findIndex((input) => input.name === name);
  const [column, row] = [at(x.name), at(y.name)];
  // Of a hundred thousand cases, most are outside of the shown values.
  const columnOf = new Map(columns.map((literal, index) => [literal, index]));
  const rowOf = new Map(rows.map((literal, index) => [literal, index]));
  const cells = rows.map(() => columns.map((): CellState => 'unknown'));
  for (const { values, failed } of [...cases, ...further]) {
    const c = columnOf.get(values[column] ?? '');
    const line = cells[rowOf.get(values[row] ?? '') ?? -1];
    if (c === undefined || !line) continue;
    const state = failed ? 'fails' : 'passes';
    line[c] = line[c] === 'unknown' || line[c] === state ? state : 'both';
  }
  return { x: x.name, y: y.name, columns, rows, cells };
}

function concerns(cause: Cause, name: string): boolean {
  if (cause.parameters.some((parameter) => parameter.name === name)) return true;
  return (cause.relation ?? '').split(/[^\w.[\]]+/).includes(name);
}

/** Numbers ascend; other literals keep their order. Of many, those around the value of the cause. */
function levelsOf(
  { name, numeric, values }: Explanation['inputs'][number],
  cause: Cause,
): string[] {
  const levels = [...values];
  if (numeric) levels.sort((a, b) => Number(a) - Number(b));
  const own = cause.parameters.find((parameter) => parameter.name === name)?.literal;
  const middle = own === undefined ? 0 : levels.indexOf(own);
  const last = Math.max(0, levels.length - MAX_LEVELS);
  const first = Math.max(0, Math.min(middle - MAX_LEVELS / 2, last));
  return levels.slice(first, first + MAX_LEVELS);
}
