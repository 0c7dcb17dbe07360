import { Stack, Table, Text } from '@mantine/core';
import { useMemo, useState, type ReactNode } from 'react';
import { formatCount, plural } from '@/shared/lib/format';
import {
  COVERAGE_LABELS,
  coverageOf,
  layoutOf,
  Loading,
  ProblemAlert,
  ScrollTable,
  StatesLegend,
  StatesView,
  UserText,
  type Transition,
} from '@/shared/ui';
import { useStateDiagram } from './queries';

const SHOWN = ['passed', 'failed', 'missing'] as const;

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
      <StatesLegend shown={SHOWN} />
      <StatesView layout={layout} shown={shown} onState={setChosen} />
      <Steps
        title={`Steps from ${data.states[shown]?.name ?? ''}`}
        transitions={data.transitions.filter(({ from }) => from === shown)}
        nameOf={(index) => data.states[index]?.name ?? ''}
        caseLink={caseLink}
      />
    </Stack>
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
                <Table.Td>{COVERAGE_LABELS[coverageOf(transition)]}</Table.Td>
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
