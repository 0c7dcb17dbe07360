import { Button, Group, NumberInput, Stack, Table, Text } from '@mantine/core';
import { useState, type ReactNode } from 'react';
import type { Build, FlakyCase, Repetition } from '@/shared/api';
import { ProblemAlert, ScrollTable, Section, UserText } from '@/shared/ui';
import { AnalysisProgress } from './AnalysisProgress';
import { isEnded, useAnalysis, useRepeatCases } from './queries';
import classes from './analyses.module.css';

interface FlakyPanelProps {
  build: Build;
  caseLink: (no: number) => ReactNode;
}

/** The cases of a build that are not reproducible, and the button that repeats all cases. */
export function FlakyPanel({ build, caseLink }: FlakyPanelProps) {
  const analysis = useAnalysis(build.id, 'repetition');
  const latest = analysis.data ?? undefined;
  return (
    <Section title="Flaky cases">
      {analysis.isError && (
        <ProblemAlert title="The flaky cases could not be read" error={analysis.error} />
      )}
      <Text size="sm" c="dimmed">
        An agent runs all cases of the build again, each time in new processes, and compares
        verdicts, values and signals. A case never passes because another run passed.
      </Text>
      {analysis.isSuccess && (!latest || isEnded(latest)) && <RepeatForm buildId={build.id} />}
      {latest && <AnalysisProgress buildId={build.id} kind="repetition" analysis={latest} />}
      {latest?.repetition && <FlakyCases repetition={latest.repetition} caseLink={caseLink} />}
    </Section>
  );
}

const DEFAULT_RUNS = 10;
const MIN_RUNS = 1;
const MAX_RUNS = 100;

function RepeatForm({ buildId }: { buildId: string }) {
  const [runs, setRuns] = useState<number | string>(DEFAULT_RUNS);
  const repeat = useRepeatCases(buildId);
  return (
    <form
      onSubmit={(event) => {
        event.preventDefault();
        repeat.mutate(Number(runs));
      }}
    >
      <Group gap="sm" align="end">
        <NumberInput
          label="Further runs"
          size="xs"
          w={120}
          required
          allowDecimal={false}
          min={MIN_RUNS}
          max={MAX_RUNS}
          value={runs}
          onChange={setRuns}
        />
        <Button type="submit" variant="default" size="xs" loading={repeat.isPending}>
          Run repeatedly
        </Button>
      </Group>
      {repeat.isError && (
        <ProblemAlert
          title="The further runs were not requested"
          error={repeat.error}
          onClose={repeat.reset}
        />
      )}
    </form>
  );
}

function FlakyCases({
  repetition,
  caseLink,
}: {
  repetition: Repetition;
  caseLink: FlakyPanelProps['caseLink'];
}) {
  const { runs, count, cases } = repetition;
  if (count === 0) {
    return (
      <Text>{`In ${runs === 1 ? '1 further run' : `${runs} further runs`} each case had the same verdict and the same values.`}</Text>
    );
  }
  return (
    <Stack gap="sm">
      <Text>
        {`${count === 1 ? '1 case is' : `${count} cases are`} not reproducible in ${runs === 1 ? '1 further run' : `${runs} further runs`}.`}
        {count > cases.length && ` The first ${cases.length} are shown.`}
      </Text>
      <ScrollTable label="Flaky cases" minWidth={640}>
        <Table.Thead>
          <Table.Tr>
            <Table.Th>Case</Table.Th>
            <Table.Th>Build, then further runs</Table.Th>
            <Table.Th>Cause</Table.Th>
            <Table.Th>Difference</Table.Th>
          </Table.Tr>
        </Table.Thead>
        <Table.Tbody>
          {cases.map((flaky) => (
            <Table.Tr key={flaky.no}>
              <Table.Th scope="row">{caseLink(flaky.no)}</Table.Th>
              <Table.Td>
                <Flips verdicts={flaky.verdicts} />
              </Table.Td>
              <Table.Td>{CAUSES[flaky.cause]}</Table.Td>
              <Table.Td>
                <UserText>{flaky.reason}</UserText>
              </Table.Td>
            </Table.Tr>
          ))}
        </Table.Tbody>
      </ScrollTable>
    </Stack>
  );
}

const CAUSES: Readonly<Record<FlakyCase['cause'], string>> = {
  COMPONENT: 'Component',
  SIMULATOR: 'Simulator',
  MACHINE: 'Machine',
  UNKNOWN: 'Not known',
};

/** The verdicts of the runs, one letter each. */
function Flips({ verdicts }: { verdicts: FlakyCase['verdicts'] }) {
  return (
    <span className={classes.flips} role="img" aria-label={verdicts.join(', ')}>
      {verdicts.map((verdict, run) => (
        <span
          // The runs have no other identity than their order.
          key={run}
          className={classes.run}
          data-verdict={verdict}
          title={`${run === 0 ? 'Build' : `Run ${run}`}: ${verdict}`}
        >
          {verdict.charAt(0)}
        </span>
      ))}
    </span>
  );
}
