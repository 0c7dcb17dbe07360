import { Stack, Table, Text } from '@mantine/core';
import type { CaseChange, Suite, SuiteCase } from '@/shared/api';
import { Loading, ProblemAlert, RouteLink, ScrollTable, UserText } from '@/shared/ui';
import { useSuiteChanges } from './queries';
import { callText } from './steps';

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
  const sequences = items.some(({ before, now }) => ((now ?? before)?.steps.length ?? 0) > 0);
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
              {sequences && <Table.Th>Steps</Table.Th>}
              <Table.Th ta="right">Expected before</Table.Th>
              <Table.Th ta="right">Expected now</Table.Th>
            </Table.Tr>
          </Table.Thead>
          <Table.Tbody>
            {items.map((item) => (
              <ChangeRow
                key={`${item.change} ${(item.now ?? item.before)?.no ?? 0}`}
                item={item}
                sequences={sequences}
              />
            ))}
          </Table.Tbody>
        </ScrollTable>
      )}
    </Stack>
  );
}

function ChangeRow({ item, sequences }: { item: CaseChange; sequences: boolean }) {
  const { before, now } = item;
  const shown = now ?? before;
  return (
    <Table.Tr>
      <Table.Td>{CHANGES[item.change]}</Table.Td>
      <Table.Td>{shown?.no}</Table.Td>
      {shown?.values.map((value, index) => (
        <Table.Td key={index} ta="right">
          <UserText>{value}</UserText>
        </Table.Td>
      ))}
      {sequences && (
        <Table.Td>
          <UserText>{(shown?.steps ?? []).map(callText).join(' → ')}</UserText>
        </Table.Td>
      )}
      <Table.Td ta="right">
        <UserText>{sequences ? stepTexts(before, now) : textOf(before?.expected)}</UserText>
      </Table.Td>
      <Table.Td ta="right">
        <UserText>{sequences ? stepTexts(now, before) : textOf(now?.expected)}</UserText>
      </Table.Td>
    </Table.Tr>
  );
}

/** The expected values of the steps that differ from those of another case. */
function stepTexts(shown: SuiteCase | undefined, other: SuiteCase | undefined): string {
  const texts = (shown?.steps ?? []).flatMap(({ expected }, index) => {
    const text = textOf(expected);
    const same = text === textOf(other?.steps[index]?.expected);
    return same || text === '–' ? [] : [`step ${index + 1}: ${text}`];
  });
  return texts.length > 0 ? texts.join(', ') : '–';
}

function textOf(expected: Record<string, string> | undefined): string {
  const entries = Object.entries(expected ?? {});
  if (entries.length === 0) return '–';
  return entries
    .map(([name, value]) => (entries.length === 1 ? value : `${name} = ${value}`))
    .join(', ');
}
