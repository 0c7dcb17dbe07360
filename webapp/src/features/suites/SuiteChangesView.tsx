import { Stack, Table, Text } from '@mantine/core';
import type { CaseChange, Suite } from '@/shared/api';
import { Loading, ProblemAlert, RouteLink, ScrollTable, UserText } from '@/shared/ui';
import { useSuiteChanges } from './queries';

const CHANGES = {
  added: 'Added',
  removed: 'Removed',
  expected: 'Expected value changed',
} as const;

/** The changes since the previous suite of the same model. */
export function SuiteChangesView({ suite }: { suite: Suite }) {
  const changes = useSuiteChanges(suite.id, suite.version);
  if (changes.isPending) return <Loading what="the changes" />;
  if (!changes.data) {
    return <ProblemAlert title="The changes could not be read" error={changes.error} />;
  }
  const { previousId, otherParameters, kept, added, removed, expectedChanged, items } =
    changes.data;
  if (!previousId) {
    return <Text c="dimmed">This is the first suite of this test model.</Text>;
  }
  return (
    <Stack gap="md">
      <Text>
        Since{' '}
        <RouteLink to="/suites/$suiteId" params={{ suiteId: previousId }} underline="always">
          the previous suite
        </RouteLink>
        :{' '}
        {otherParameters
          ? 'the parameters have changed, so cases cannot be compared.'
          : `${added} added, ${removed} removed, ${expectedChanged} with changed expected values, ${kept} unchanged.`}
      </Text>
      {items.length > 0 && (
        <ScrollTable label="Changed cases" minWidth={640}>
          <Table.Thead>
            <Table.Tr>
              <Table.Th>Change</Table.Th>
              <Table.Th>No</Table.Th>
              {suite.parameters.map(({ name }) => (
                <Table.Th key={name} ta="right">
                  <UserText>{name}</UserText>
                </Table.Th>
              ))}
              <Table.Th ta="right">Expected before</Table.Th>
              <Table.Th ta="right">Expected now</Table.Th>
            </Table.Tr>
          </Table.Thead>
          <Table.Tbody>
            {items.map((item) => (
              <ChangeRow key={`${item.change} ${(item.now ?? item.before)?.no ?? 0}`} item={item} />
            ))}
          </Table.Tbody>
        </ScrollTable>
      )}
    </Stack>
  );
}

function ChangeRow({ item }: { item: CaseChange }) {
  const shown = item.now ?? item.before;
  return (
    <Table.Tr>
      <Table.Td>{CHANGES[item.change]}</Table.Td>
      <Table.Td>{shown?.no}</Table.Td>
      {shown?.values.map((value, index) => (
        <Table.Td key={index} ta="right">
          <UserText>{value}</UserText>
        </Table.Td>
      ))}
      <Table.Td ta="right">
        <UserText>{textOf(item.before?.expected)}</UserText>
      </Table.Td>
      <Table.Td ta="right">
        <UserText>{textOf(item.now?.expected)}</UserText>
      </Table.Td>
    </Table.Tr>
  );
}

function textOf(expected: Record<string, string> | undefined): string {
  const entries = Object.entries(expected ?? {});
  if (entries.length === 0) return '–';
  return entries
    .map(([name, value]) => (entries.length === 1 ? value : `${name} = ${value}`))
    .join(', ');
}
