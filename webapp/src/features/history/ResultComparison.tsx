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
          <Cases
            comparison={data}
            items={data.items.filter((item) => item.change === change)}
            label={title}
          />
        </Section>
      ))}
    </Stack>
  );
}

function Cases({
  comparison,
  items,
  label,
}: {
  comparison: Comparison;
  items: readonly ComparedCase[];
  label: string;
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
          <Table.Th ta="right">Time before (µs)</Table.Th>
          <Table.Th ta="right">Time now (µs)</Table.Th>
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
            <Table.Td>{item.message && <UserText>{item.message}</UserText>}</Table.Td>
          </Table.Tr>
        ))}
      </Table.Tbody>
    </ScrollTable>
  );
}
