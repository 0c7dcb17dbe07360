import { Table, Text } from '@mantine/core';
import { formatCount } from '@/shared/lib/format';
import { Age, Loading, ProblemAlert, RouteLink, ScrollTable, UserText } from '@/shared/ui';
import { useSuites } from './queries';

/** The suites of an activity, newest first. */
export function SuiteList({ activityId }: { activityId: string }) {
  const suites = useSuites(activityId);
  if (suites.isPending) return <Loading what="the suites" />;
  if (!suites.data) {
    return <ProblemAlert title="The suites could not be read" error={suites.error} />;
  }
  const { items } = suites.data;
  if (items.length === 0) {
    return <Text c="dimmed">No suites yet. Open a test model to generate test cases.</Text>;
  }
  return (
    <ScrollTable label="Suites" minWidth={560}>
      <Table.Thead>
        <Table.Tr>
          <Table.Th>Suite</Table.Th>
          <Table.Th>Test model</Table.Th>
          <Table.Th ta="right">Cases</Table.Th>
          <Table.Th ta="right">Valid</Table.Th>
          <Table.Th ta="right">Seed</Table.Th>
          <Table.Th>Generated</Table.Th>
        </Table.Tr>
      </Table.Thead>
      <Table.Tbody>
        {items.map((suite) => (
          <Table.Tr key={suite.id}>
            <Table.Td>
              <RouteLink to="/suites/$suiteId" params={{ suiteId: suite.id }} size="sm" fw={600}>
                <UserText>{suite.name}</UserText>
              </RouteLink>
            </Table.Td>
            <Table.Td>
              <UserText>{suite.model}</UserText>
            </Table.Td>
            <Table.Td ta="right">{formatCount(suite.total)}</Table.Td>
            <Table.Td ta="right">{formatCount(suite.valid)}</Table.Td>
            <Table.Td ta="right">{suite.seed}</Table.Td>
            <Table.Td>
              <Age at={suite.created} />
            </Table.Td>
          </Table.Tr>
        ))}
      </Table.Tbody>
    </ScrollTable>
  );
}
