import type { StateDiagram } from '@/shared/api';

export type Transition = StateDiagram['transitions'][number];

/**
 * What the cases of a result show about a step between two states; in the plan of a model, whether
 * the step is allowed there.
 */
export type Coverage = 'failed' | 'passed' | 'missing' | 'planned' | 'forbidden';

/** Pixels. */
const COLUMN = 230;
const GAP = 34;
const LINE = 16;
export const BOX_WIDTH = 150;
const MARGIN = 60;

export interface Box {
  index: number;
  /** One line per state variable. */
  lines: string[];
  /** The centre. */
  x: number;
  y: number;
  height: number;
  coverage: Coverage;
}

/** All transitions from a state to a state. */
export interface Arrow {
  from: number;
  to: number;
  transitions: Transition[];
  coverage: Coverage;
  path: string;
}

export interface Layout {
  boxes: Box[];
  arrows: Arrow[];
  width: number;
  height: number;
}

export function coverageOf({ passed, failed }: Transition): Coverage {
  if (failed > 0) return 'failed';
  return passed > 0 ? 'passed' : 'missing';
}

/** The coverage of a step in the plan of a model. */
function planOf({ kind }: Transition): Coverage {
  return kind === 'FORBIDDEN' ? 'forbidden' : 'planned';
}

/** The worst: an arrow is covered if all of its transitions are. */
function worst(all: readonly Coverage[]): Coverage {
  const order: Coverage[] = ['failed', 'missing', 'planned', 'passed'];
  return order.find((coverage) => all.includes(coverage)) ?? 'forbidden';
}

/**
 * Columns by the number of steps from the initial state; arrows between the boxes.
 *
 * @param planned whether the diagram is the plan of a model, without a result
 */
export function layoutOf({ states, transitions }: StateDiagram, planned = false): Layout {
  const of = planned ? planOf : coverageOf;
  const depth = depthsOf(states.length, transitions);
  const columns: number[][] = [];
  depth.forEach((column, index) => {
    (columns[column] ??= []).push(index);
  });
  const lines = states.map(({ name }) => (name === '' ? ['no state variables'] : name.split(', ')));
  const heights = lines.map((own) => own.length * LINE + 14);
  const heightOf = (column: readonly number[]) =>
    column.reduce((sum, index) => sum + (heights[index] ?? 0) + GAP, -GAP);
  const height = Math.max(...columns.map(heightOf)) + 2 * MARGIN;
  const boxes: Box[] = [];
  columns.forEach((column, at) => {
    let y = (height - heightOf(column)) / 2;
    for (const index of column) {
      const own = heights[index] ?? 0;
      const left = transitions.filter(({ from }) => from === index).map(coverageOf);
      const steps = states[index]?.steps ?? 0;
      boxes[index] = {
        index,
        lines: lines[index] ?? [],
        x: MARGIN + BOX_WIDTH / 2 + at * COLUMN,
        y: y + own / 2,
        height: own,
        coverage: planned
          ? 'planned'
          : left.includes('failed')
            ? 'failed'
            : steps > 0
              ? 'passed'
              : 'missing',
      };
      y += own + GAP;
    }
  });
  const groups = new Map<string, Transition[]>();
  for (const transition of transitions) {
    const key = `${transition.from} ${transition.to}`;
    groups.set(key, [...(groups.get(key) ?? []), transition]);
  }
  const arrows = [...groups.values()].flatMap((group) => {
    const [first] = group;
    const from = first && boxes[first.from];
    const to = first && boxes[first.to];
    if (!from || !to) return [];
    return {
      from: from.index,
      to: to.index,
      transitions: group,
      coverage: worst(group.map(of)),
      path: pathOf(from, to),
    };
  });
  return { boxes, arrows, width: 2 * MARGIN + BOX_WIDTH + (columns.length - 1) * COLUMN, height };
}

/** The number of steps from the initial state. */
function depthsOf(count: number, transitions: readonly Transition[]): number[] {
  const depths: number[] = Array.from({ length: count }, (_, index) => (index === 0 ? 0 : -1));
  let frontier = [0];
  for (let depth = 1; frontier.length > 0; depth++) {
    const next = new Set<number>();
    for (const { from, to } of transitions) {
      if (frontier.includes(from) && depths[to] === -1) next.add(to);
    }
    for (const index of next) depths[index] = depth;
    frontier = [...next];
  }
  const last = Math.max(...depths);
  // Only an unknown state before a step leaves a state without a way to it.
  return depths.map((depth) => (depth === -1 ? last + 1 : depth));
}

function pathOf(from: Box, to: Box): string {
  const half = BOX_WIDTH / 2;
  if (from.index === to.index) {
    const top = from.y - from.height / 2;
    return `M ${from.x - 16} ${top} C ${from.x - 30} ${top - 30}, ${from.x + 30} ${top - 30}, ${from.x + 16} ${top}`;
  }
  if (to.x > from.x) {
    const [a, b] = [from.x + half, to.x - half];
    const bend = (b - a) / 2;
    return `M ${a} ${from.y - 6} C ${a + bend} ${from.y - 6}, ${b - bend} ${to.y - 6}, ${b} ${to.y - 6}`;
  }
  if (to.x < from.x) {
    const [a, b] = [from.x - half, to.x + half];
    const bend = (a - b) / 2;
    return `M ${a} ${from.y + 8} C ${a - bend} ${from.y + 8}, ${b + bend} ${to.y + 8}, ${b} ${to.y + 8}`;
  }
  // The same column: along its right side downwards, along its left side upwards.
  const side = to.y > from.y ? 1 : -1;
  const x = from.x + side * half;
  return `M ${x} ${from.y} C ${x + side * 45} ${from.y}, ${x + side * 45} ${to.y}, ${x} ${to.y}`;
}
