import { Text } from '@mantine/core';
import type { ModelPreview } from '@/shared/api';
import { UserText } from '@/shared/ui';
import classes from './values.module.css';

type Values = ModelPreview['inputs'][number]['values'];

const WIDTH = 640;
const EDGE = 28;
/** Minimum distance of two labels; closer labels would overlap. */
const LABEL_GAP = 34;

/** The valid and invalid values of an input on a number line and as two lists. */
export function NumberLine({ values }: { values: Values }) {
  if (values.length === 0) return <Text c="dimmed">No values.</Text>;
  const numbers = values.map(({ literal }) => Number(literal));
  const numeric = values.every(({ literal }, at) => literal !== '' && Number.isFinite(numbers[at]));
  return (
    <div>
      {numeric && <Line values={values} numbers={numbers} />}
      <Listed label="Valid" values={values.filter(({ valid }) => valid)} />
      <Listed label="Invalid" values={values.filter(({ valid }) => !valid)} />
    </div>
  );
}

function Line({ values, numbers }: { values: Values; numbers: readonly number[] }) {
  const low = Math.min(...numbers);
  const span = Math.max(...numbers) - low || 1;
  const at = (number: number) => EDGE + ((number - low) / span) * (WIDTH - 2 * EDGE);
  const valid = numbers.filter((_, index) => values[index]?.valid);
  const labelled = labelledOf(numbers.map(at));
  return (
    <svg
      className={classes.line}
      viewBox={`0 0 ${WIDTH} 64`}
      role="img"
      aria-label={`${values.length} values from ${low} to ${low + span} on a number line`}
    >
      <line className={classes.axis} x1={0} x2={WIDTH} y1={28} y2={28} />
      {valid.length > 0 && (
        <line
          className={classes.range}
          x1={at(Math.min(...valid))}
          x2={at(Math.max(...valid))}
          y1={28}
          y2={28}
        />
      )}
      {values.map(({ literal, valid: isValid }, index) => {
        const x = at(numbers[index] ?? 0);
        return (
          <g key={literal}>
            {isValid ? (
              <circle className={classes.valid} cx={x} cy={28} r={7} />
            ) : (
              <path
                className={classes.invalid}
                d={`M ${x} 20 L ${x + 8} 28 L ${x} 36 L ${x - 8} 28 Z`}
              />
            )}
            {labelled.has(index) && (
              <text className={classes.label} x={x} y={56} textAnchor="middle">
                {literal.length > 9 ? `${literal.slice(0, 8)}…` : literal}
              </text>
            )}
          </g>
        );
      })}
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

const LISTED = 60;

function Listed({ label, values }: { label: string; values: Values }) {
  if (values.length === 0) return null;
  const shown = values.slice(0, LISTED).map(({ literal }) => (literal === '' ? '""' : literal));
  return (
    <Text size="sm">
      <strong>
        {label} ({values.length}):
      </strong>{' '}
      <UserText>{shown.join(', ')}</UserText>
      {values.length > LISTED && ' …'}
    </Text>
  );
}
