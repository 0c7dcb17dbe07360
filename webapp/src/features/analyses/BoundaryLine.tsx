import type { Explanation, FailureBoundary } from '@/shared/api';
import classes from './analyses.module.css';

const WIDTH = 640;
const EDGE = 28;
const AXIS = 28;
const LABEL_GAP = 60;

interface BoundaryLineProps {
  boundary: FailureBoundary;
  input: Explanation['inputs'][number];
}

/** The boundary of a cause among the values of its input, on a number line. */
export function BoundaryLine({ boundary, input }: BoundaryLineProps) {
  const invalid = new Set(input.invalid);
  const values = input.values
    .map((literal) => ({ number: Number(literal), valid: !invalid.has(literal) }))
    .filter(({ number }) => Number.isFinite(number))
    .sort((a, b) => a.number - b.number);
  const passes = Number(boundary.passes);
  const fails = Number(boundary.fails);
  const all = [...values.map(({ number }) => number), passes, fails];
  const low = Math.min(...all);
  const span = Math.max(...all) - low || 1;
  const at = (number: number) => EDGE + ((number - low) / span) * (WIDTH - 2 * EDGE);
  const valid = values.filter((value) => value.valid).map(({ number }) => number);
  const end = fails > passes ? Math.max(...valid, fails) : Math.min(...valid, fails);
  const labelled = labelledOf(values.map(({ number }) => at(number)));
  return (
    <svg
      className={classes.line}
      viewBox={`0 0 ${WIDTH} 84`}
      role="img"
      aria-label={`${boundary.parameter} passes with ${boundary.passes} and fails with ${boundary.fails}`}
    >
      <line className={classes.axis} x1={0} x2={WIDTH} y1={AXIS} y2={AXIS} />
      {valid.length > 0 && (
        <line
          className={classes.valid}
          x1={at(Math.min(...valid))}
          x2={at(Math.max(...valid))}
          y1={AXIS}
          y2={AXIS}
        />
      )}
      <line className={classes.failing} x1={at(fails)} x2={at(end)} y1={AXIS} y2={AXIS} />
      {values.map(({ number, valid: isValid }, index) => {
        const x = at(number);
        return (
          <g key={number}>
            <circle className={isValid ? classes.value : classes.invalid} cx={x} cy={AXIS} r={5} />
            {labelled.has(index) && (
              <text className={classes.tick} x={x} y={54} textAnchor="middle">
                {String(number).slice(0, 9)}
              </text>
            )}
          </g>
        );
      })}
      <line className={classes.mark} x1={at(passes)} x2={at(passes)} y1={6} y2={66} />
      <text
        className={classes.name}
        x={Math.min(Math.max(at(passes), 90), WIDTH - 90)}
        y={80}
        textAnchor="middle"
      >
        {boundary.passes}
      </text>
    </svg>
  );
}

/** The positions that have room for a label, from the left. */
function labelledOf(positions: readonly number[]): Set<number> {
  const labelled = new Set<number>();
  let free = -Infinity;
  for (const [index, position] of positions.entries()) {
    if (position - free >= LABEL_GAP) {
      labelled.add(index);
      free = position;
    }
  }
  return labelled;
}
