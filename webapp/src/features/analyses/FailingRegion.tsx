import type { CellState, Region } from './region';
import classes from './analyses.module.css';

const CELL = 22;
const LEFT = 110;
const BOTTOM = 78;
const MAX_LABEL = 12;

const WORDS: Record<CellState, string> = {
  fails: 'fails',
  passes: 'passes',
  both: 'fails and passes, depending on the other inputs',
  unknown: 'not executed',
};

/** What the executed cases did over the two inputs that tell most of a cause. */
export function FailingRegion({ region }: { region: Region }) {
  const { x, y, columns, rows, cells } = region;
  const width = LEFT + columns.length * CELL + 12;
  const height = rows.length * CELL + BOTTOM;
  return (
    <figure className={classes.region}>
      <svg
        width={width}
        height={height}
        viewBox={`0 0 ${width} ${height}`}
        role="img"
        aria-label={`Failing cases over ${x} and ${y}`}
      >
        {rows.map((row, r) => {
          // The smallest number is at the bottom, as in a plot.
          const top = (rows.length - 1 - r) * CELL;
          return (
            <g key={row}>
              <text className={classes.tick} x={LEFT - 6} y={top + CELL / 2 + 4} textAnchor="end">
                {shortened(row)}
              </text>
              {columns.map((column, c) => {
                const state = cells[r]?.[c] ?? 'unknown';
                return (
                  <rect
                    key={column}
                    className={classes[state]}
                    x={LEFT + c * CELL + 1}
                    y={top + 1}
                    width={CELL - 2}
                    height={CELL - 2}
                  >
                    <title>{`${x} = ${column}, ${y} = ${row}: ${WORDS[state]}`}</title>
                  </rect>
                );
              })}
            </g>
          );
        })}
        {columns.map((column, c) => {
          const left = LEFT + c * CELL + CELL / 2;
          const top = rows.length * CELL + 12;
          return (
            <text
              key={column}
              className={classes.tick}
              x={left}
              y={top}
              textAnchor="end"
              transform={`rotate(-50 ${left} ${top})`}
            >
              {shortened(column)}
            </text>
          );
        })}
        <text className={classes.name} x={LEFT} y={height - 4}>
          {`→ ${x}   ↑ ${y}`}
        </text>
      </svg>
      <figcaption className={classes.legend}>
        {(['fails', 'both', 'passes', 'unknown'] as const).map((state) => (
          <span key={state}>
            <svg width={12} height={12} aria-hidden>
              <rect className={classes[state]} x={1} y={1} width={10} height={10} />
            </svg>{' '}
            {state === 'both' ? 'both' : WORDS[state]}
          </span>
        ))}
      </figcaption>
    </figure>
  );
}

function shortened(literal: string): string {
  if (literal === '') return '""';
  return literal.length > MAX_LABEL ? `${literal.slice(0, MAX_LABEL - 1)}…` : literal;
}
