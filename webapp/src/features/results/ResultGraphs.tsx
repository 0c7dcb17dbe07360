import { SimpleGrid, Stack, Text, Title } from '@mantine/core';
import { useMemo, type ReactNode } from 'react';
import type { ResultStatistics, ResultSummary as Summary } from '@/shared/api';
import { formatTime, plural } from '@/shared/lib/format';
import { Chart, Loading, ProblemAlert, Section, UserText } from '@/shared/ui';
import {
  failingPairs,
  faultyValues,
  timeHistogram,
  timesOverCases,
  verdictMap,
  verdictPie,
  verdictsByValue,
  type TellingPair,
} from './graphs';
import { useResult, useStatistics, type CaseFilter } from './queries';
import classes from './results.module.css';

interface ResultGraphsProps {
  buildId: string;
  onFilter: (filter: CaseFilter) => void;
}

/** The charts of a result, as in the paper's Fig. 17(b), and the verdicts by parameter value. */
export function ResultGraphs({ buildId, onFilter }: ResultGraphsProps) {
  const result = useResult(buildId);
  const statistics = useStatistics(buildId);
  if (result.isPending || statistics.isPending) return <Loading what="the graphs" />;
  if (!result.data || !statistics.data) {
    return (
      <ProblemAlert
        title="The graphs could not be read"
        error={result.error ?? statistics.error ?? new Error('The server did not answer.')}
      />
    );
  }
  const { times, parameters, tellingPair } = statistics.data;
  const varying = parameters.filter(({ values, leftOut }) => values.length + leftOut > 1);
  const constant = parameters.filter(({ values, leftOut }) => values.length + leftOut === 1);
  return (
    <Stack gap="xl">
      <SimpleGrid cols={{ base: 1, md: 2 }} spacing="xl">
        <Section title="Verdicts">
          <Verdicts summary={result.data.summary} />
        </Section>
        {times && (
          <Section title="Processing time">
            <Histogram times={times} />
          </Section>
        )}
      </SimpleGrid>
      {tellingPair && <VerdictMap pair={tellingPair} />}
      {times ? (
        <Section title="Processing time over the cases">
          <OverCases times={times} />
        </Section>
      ) : (
        <Text c="dimmed">No times were measured.</Text>
      )}
      <Section title="Verdicts by parameter value">
        {constant.length > 0 && (
          <Text size="sm" c="dimmed">
            Same in all cases:{' '}
            <UserText>
              {constant.map(({ name, values }) => `${name} = ${values[0]?.value ?? ''}`).join(', ')}
            </UserText>
          </Text>
        )}
        <SimpleGrid cols={{ base: 1, md: 2 }} spacing="xl">
          {varying.map((parameter) => (
            <ByParameter
              key={parameter.name}
              parameter={parameter}
              onPick={(value) => {
                onFilter({ parameter: parameter.name, value });
              }}
            />
          ))}
        </SimpleGrid>
      </Section>
    </Stack>
  );
}

/** The two parameters that tell most about the failures. */
function VerdictMap({ pair }: { pair: TellingPair }) {
  const option = useMemo(() => verdictMap(pair), [pair]);
  const failing = failingPairs(pair, 3);
  return (
    <Section title="Where cases fail">
      <Text size="sm" c="dimmed">
        The two parameters that tell most about the verdict.{' '}
        <UserText>{`${failing.join('; ')}.`}</UserText>
      </Text>
      <Chart
        label={`Failing cases by ${pair.first} and ${pair.second}. ${failing.join('; ')}`}
        option={option}
        height={Math.min(640, 110 + 26 * pair.secondValues.length)}
      />
    </Section>
  );
}

type Times = NonNullable<ResultStatistics['times']>;

function Verdicts({ summary }: { summary: Summary }) {
  const option = useMemo(() => verdictPie(summary), [summary]);
  return (
    <Chart
      label={`Of ${plural(summary.total, 'case')} ${summary.pass} passed, ${summary.fail} failed, ${summary.error} with errors, ${summary.dont} not executed`}
      option={option}
    />
  );
}

function Histogram({ times }: { times: Times }) {
  const option = useMemo(() => timeHistogram(times), [times]);
  return (
    <Chart
      label={`Histogram of the processing times of ${plural(times.count, 'case')}, from ${formatTime(times.min)} to ${formatTime(times.max)}`}
      option={option}
    />
  );
}

function OverCases({ times }: { times: Times }) {
  const option = useMemo(() => timesOverCases(times), [times]);
  const facts: [string, ReactNode][] = [
    ['Min', formatTime(times.min)],
    ['Average', formatTime(times.average)],
    ['Std dev.', formatTime(times.standardDeviation)],
    ['50th percentile', formatTime(times.p50)],
    ['90th percentile', formatTime(times.p90)],
    ['95th percentile', formatTime(times.p95)],
    ['99th percentile', formatTime(times.p99)],
    ['Max', formatTime(times.max)],
  ];
  return (
    <Stack gap="sm">
      <dl className={classes.summary} aria-label="Processing time of the component">
        {facts.map(([name, value]) => (
          <div key={name}>
            <dt>{name}</dt>
            <dd>{value}</dd>
          </div>
        ))}
      </dl>
      <Chart
        label={`Processing time by case number; average ${formatTime(times.average)}`}
        option={option}
      />
    </Stack>
  );
}

function ByParameter({
  parameter,
  onPick,
}: {
  parameter: ResultStatistics['parameters'][number];
  onPick: (value: string) => void;
}) {
  const option = useMemo(() => verdictsByValue(parameter), [parameter]);
  return (
    <div>
      <Title order={3} size="h5">
        <UserText>{parameter.name}</UserText>
      </Title>
      <Chart
        label={`Verdicts by value of ${faultyValues(parameter)}`}
        option={option}
        height={240}
        onPick={onPick}
      />
      <Text size="sm" c="dimmed">
        <UserText>{faultyValues(parameter)}</UserText>
        {parameter.leftOut > 0 && `; ${plural(parameter.leftOut, 'other value')} not shown`}
      </Text>
    </div>
  );
}
