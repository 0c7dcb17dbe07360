import { Group, Stack, Table, Text } from '@mantine/core';
import { useMemo, useState, type ReactNode } from 'react';
import { formatCount, plural } from '@/shared/lib/format';
import { Loading, ProblemAlert, ScrollTable, UserText } from '@/shared/ui';
import {
  BOX_WIDTH,
  coverageOf,
  layoutOf,
  type Coverage,
  type Layout,
  type Transition,
} from './layout';
import { useStateDiagram } from './queries';
import classes from './states.module.css';

const LABELS: Record<Coverage, string> = {
  passed: 'executed, passed',
  failed: 'failed',
  missing: 'allowed, not executed',
};

interface StateDiagramViewProps {
  buildId: string;
  /** A link to a case. */
  caseLink: (no: number) => ReactNode;
}

/** The abstract states of the sequences: what was executed, what failed, and what was not executed. */
export function StateDiagramView({ buildId, caseLink }: StateDiagramViewProps) {
  const { data, error, isPending } = useStateDiagram(buildId);
  const layout = useMemo(() => data && data.states.length > 0 && layoutOf(data), [data]);
  const [chosen, setChosen] = useState<number | null>(null);
  if (isPending) return <Loading what="the states" />;
  if (!data) return <ProblemAlert title="The states could not be read" error={error} />;
  if (!layout) return <Text c="dimmed">The cases are not sequences of steps.</Text>;
  const shown = chosen ?? data.transitions.find(({ failed }) => failed > 0)?.from ?? 0;
  const executed = data.transitions.filter((transition) => coverageOf(transition) !== 'missing');
  return (
    <Stack gap="md">
      <Text size="sm">
        {plural(data.states.length, 'abstract state')},{' '}
        {plural(data.transitions.length, 'transition')}, {formatCount(executed.length)} executed.{' '}
        {!data.complete && 'The model has more; the diagram shows the first ones. '}
        Select a state to see its steps.
      </Text>
      <Group gap="lg" aria-label="Legend" role="group">
        {(Object.keys(LABELS) as Coverage[]).map((coverage) => (
          <Text key={coverage} size="sm">
            <svg width="34" height="10" aria-hidden>
              <line
                x1="0"
                x2="34"
                y1="5"
                y2="5"
                className={classes.arrow}
                data-coverage={coverage}
              />
            </svg>{' '}
            {LABELS[coverage]}
          </Text>
        ))}
      </Group>
      <Diagram layout={layout} shown={shown} onState={setChosen} />
      <Steps
        title={`Steps from ${data.states[shown]?.name ?? ''}`}
        transitions={data.transitions.filter(({ from }) => from === shown)}
        nameOf={(index) => data.states[index]?.name ?? ''}
        caseLink={caseLink}
      />
    </Stack>
  );
}

interface DiagramProps {
  layout: Layout;
  /** Index of the selected state. */
  shown: number;
  onState: (index: number) => void;
}

function Diagram({ layout: { boxes, arrows, width, height }, shown, onState }: DiagramProps) {
  // The arrows of the selected state and those that failed are on top.
  const rank = ({ from, coverage }: (typeof arrows)[number]) =>
    (from === shown ? 2 : 0) + (coverage === 'failed' ? 1 : 0);
  return (
    <div className={classes.frame} tabIndex={0} role="group" aria-label="Diagram of the states">
      <svg width={width} height={height} viewBox={`0 0 ${width} ${height}`}>
        <defs>
          <marker
            id="state-arrow"
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
              markerEnd="url(#state-arrow)"
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
            aria-description={LABELS[coverage]}
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

interface StepsProps {
  title: string;
  transitions: readonly Transition[];
  nameOf: (state: number) => string;
  caseLink: (no: number) => ReactNode;
}

function Steps({ title, transitions, nameOf, caseLink }: StepsProps) {
  return (
    <Stack gap={4}>
      <Text fw={600}>
        <UserText>{title}</UserText>
      </Text>
      <ScrollTable label={title} minWidth={520}>
        <Table.Thead>
          <Table.Tr>
            <Table.Th>Step</Table.Th>
            <Table.Th>Result</Table.Th>
            <Table.Th ta="right">Passed</Table.Th>
            <Table.Th ta="right">Failed</Table.Th>
            <Table.Th>State afterwards</Table.Th>
            <Table.Th>First failure</Table.Th>
          </Table.Tr>
        </Table.Thead>
        <Table.Tbody>
          {transitions.map((transition) => {
            const { step, kind, to, passed, failed, failedCase } = transition;
            return (
              <Table.Tr key={`${step} ${kind} ${to}`} data-coverage={coverageOf(transition)}>
                <Table.Td>
                  <UserText>{step}</UserText>
                  {kind === 'FORBIDDEN' && ' (forbidden)'}
                  {kind === 'INVALID' && ' (invalid value)'}
                </Table.Td>
                <Table.Td>{LABELS[coverageOf(transition)]}</Table.Td>
                <Table.Td ta="right">{formatCount(passed)}</Table.Td>
                <Table.Td ta="right">{formatCount(failed)}</Table.Td>
                <Table.Td>
                  <UserText>{nameOf(to)}</UserText>
                </Table.Td>
                <Table.Td>{failedCase !== undefined && caseLink(failedCase)}</Table.Td>
              </Table.Tr>
            );
          })}
        </Table.Tbody>
      </ScrollTable>
    </Stack>
  );
}
