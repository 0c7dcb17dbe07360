import { Stack, Table, Text } from '@mantine/core';
import type { ComparedCase, ResultComparison as Comparison } from '@/shared/api';
import { formatTime, plural } from '@/shared/lib/format';
import { VERDICT_LABELS } from '@/shared/lib/verdicts';
import { Loading, ProblemAlert, ScrollTable, Section, UserText } from '@/shared/ui';
import { useComparison } from './queries';

const CHANGES = [
  { change: 'newlyFailing', title: 'Newly failing' },
  { change: 'fixed', title: 'Fixed' },
  { change: 'slower', title: 'Slower' },
] as const;

/** Compares a result with an earlier one, by cases with the same values. */
export function ResultComparison({ buildId, other }: { buildId: string; other: string }) {
  const comparison = useComparison(buildId, other);
  if (comparison.isPending) return <Loading what="the comparison" />;
  if (!comparison.data) {
    return <ProblemAlert title="The results could not be compared" error={comparison.error} />;
  }
  const { data } = comparison;
  return (
    <Stack gap="xl">
      <Text>
        {plural(data.common, 'case')} in both results
        {data.onlyNow > 0 && `, ${data.onlyNow} only in this result`}
        {data.onlyBefore > 0 && `, ${data.onlyBefore} only in the other result`}.
      </Text>
      {CHANGES.map(({ change, title }) => (
        <Section key={change} title={`${title}: ${data[change]}`}>
          {change === 'slower' && <TimesNote comparison={data} />}
          {(change !== 'slower' || data.timed > 0) && (
            <Cases
              comparison={data}
              items={data.items.filter((item) => item.change === change)}
              label={title}
              withTimes={change === 'slower'}
            />
          )}
        </Section>
      ))}
    </Stack>
  );
}

/** How slower cases are found, or why there are none. */
function TimesNote({ comparison: { timed, notTimed } }: { comparison: Comparison }) {
  return (
    <Text size="sm" c="dimmed">
      {notTimed ??
        `${plural(timed, 'case')} with repeated calls in both results. A case is slower if its median grew by at least 10 % with p ≤ 0.05 (Mann-Whitney U test, adjusted for the number of cases).`}
    </Text>
  );
}

function Cases({
  comparison,
  items,
  label,
  withTimes,
}: {
  comparison: Comparison;
  items: readonly ComparedCase[];
  label: string;
  withTimes: boolean;
}) {
  if (items.length === 0) return <Text c="dimmed">None.</Text>;
  return (
    <ScrollTable label={label} minWidth={720}>
      <Table.Thead>
        <Table.Tr>
          <Table.Th>No</Table.Th>
          {comparison.parameters.map(({ name }) => (
            <Table.Th key={name} ta="right">
              <UserText>{name}</UserText>
            </Table.Th>
          ))}
          <Table.Th>Before</Table.Th>
          <Table.Th>Now</Table.Th>
          <Table.Th ta="right">Time before</Table.Th>
          <Table.Th ta="right">Time now</Table.Th>
          {withTimes && <Table.Th ta="right">Ratio</Table.Th>}
          {withTimes && <Table.Th ta="right">p</Table.Th>}
          <Table.Th>Message</Table.Th>
        </Table.Tr>
      </Table.Thead>
      <Table.Tbody>
        {items.map((item) => (
          <Table.Tr key={item.no}>
            <Table.Td>{item.no}</Table.Td>
            {item.values.map((value, index) => (
              <Table.Td key={index} ta="right">
                <UserText>{value}</UserText>
              </Table.Td>
            ))}
            <Table.Td>{VERDICT_LABELS[item.before].label}</Table.Td>
            <Table.Td>{VERDICT_LABELS[item.now].label}</Table.Td>
            <Table.Td ta="right">{formatTime(item.timeBeforeUs)}</Table.Td>
            <Table.Td ta="right">{formatTime(item.timeNowUs)}</Table.Td>
            {withTimes && <Table.Td ta="right">{item.ratio?.toFixed(2)}</Table.Td>}
            {withTimes && <Table.Td ta="right">{item.p?.toPrecision(2)}</Table.Td>}
            <Table.Td>{item.message && <UserText>{item.message}</UserText>}</Table.Td>
          </Table.Tr>
        ))}
      </Table.Tbody>
    </ScrollTable>
  );
}
