import { Group, Text } from '@mantine/core';
import { useId } from 'react';
import { BOX_WIDTH, type Coverage, type Layout } from './layout';
import classes from './states.module.css';

export const COVERAGE_LABELS: Record<Coverage, string> = {
  passed: 'executed, passed',
  failed: 'failed',
  missing: 'allowed, not executed',
  planned: 'allowed',
  forbidden: 'forbidden, made in invalid cases',
};

/** Explains the lines of a diagram. */
export function StatesLegend({ shown }: { shown: readonly Coverage[] }) {
  return (
    <Group gap="lg" aria-label="Legend" role="group">
      {shown.map((coverage) => (
        <Text key={coverage} size="sm">
          <svg width="34" height="10" aria-hidden>
            <line x1="0" x2="34" y1="5" y2="5" className={classes.arrow} data-coverage={coverage} />
          </svg>{' '}
          {COVERAGE_LABELS[coverage]}
        </Text>
      ))}
    </Group>
  );
}

interface StatesViewProps {
  layout: Layout;
  /** Index of the selected state. */
  shown: number;
  onState: (index: number) => void;
}

/** The abstract states of sequences, and the steps between them. */
export function StatesView({ layout, shown, onState }: StatesViewProps) {
  const { boxes, arrows, width, height } = layout;
  const marker = useId();
  // The arrows of the selected state and those that failed are on top.
  const rank = ({ from, coverage }: (typeof arrows)[number]) =>
    (from === shown ? 2 : 0) + (coverage === 'failed' ? 1 : 0);
  return (
    <div className={classes.frame} tabIndex={0} role="group" aria-label="Diagram of the states">
      <svg width={width} height={height} viewBox={`0 0 ${width} ${height}`}>
        <defs>
          <marker
            id={marker}
            viewBox="0 0 8 8"
            refX="7"
            refY="4"
            markerWidth="7"
            markerHeight="7"
            orient="auto-start-reverse"
          >
            <path d="M 0 0 L 8 4 L 0 8 z" fill="context-stroke" />
          </marker>
        </defs>
        {arrows
          .toSorted((a, b) => rank(a) - rank(b))
          .map(({ from, to, coverage, path, transitions }) => (
            <path
              key={`${from} ${to}`}
              d={path}
              className={classes.arrow}
              data-coverage={coverage}
              data-shown={from === shown || undefined}
              markerEnd={`url(#${marker})`}
            >
              <title>{transitions.map(({ step }) => step).join(', ')}</title>
            </path>
          ))}
        {boxes.map(({ index, lines, x, y, height: own, coverage }) => (
          <g
            key={index}
            className={classes.state}
            data-coverage={coverage}
            data-shown={index === shown || undefined}
            role="button"
            tabIndex={0}
            aria-description={COVERAGE_LABELS[coverage]}
            aria-pressed={index === shown}
            onClick={() => {
              onState(index);
            }}
            onKeyDown={({ key }) => {
              if (key === 'Enter' || key === ' ') onState(index);
            }}
          >
            <rect x={x - BOX_WIDTH / 2} y={y - own / 2} width={BOX_WIDTH} height={own} rx="8" />
            {lines.map((line, at) => (
              <text key={at} x={x} y={y - own / 2 + 20 + at * 16} textAnchor="middle">
                {line.length > 22 ? `${line.slice(0, 21)}…` : line}
                {at < lines.length - 1 && ', '}
              </text>
            ))}
          </g>
        ))}
      </svg>
    </div>
  );
}
