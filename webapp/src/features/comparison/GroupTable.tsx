import { Button, Table, Text } from '@mantine/core';
import type { DifferenceGroup } from '@/shared/api';
import { ScrollTable, UserText } from '@/shared/ui';
import { KIND_LABELS } from './kinds';

interface GroupTableProps {
  groups: readonly DifferenceGroup[];
  /** Index of the group whose cases are shown. */
  selected: number | undefined;
  onSelect: (group: number | undefined) => void;
}

/** The groups of differences, the largest last. */
export function GroupTable({ groups, selected, onSelect }: GroupTableProps) {
  if (groups.length === 0) return <Text c="dimmed">No differences.</Text>;
  return (
    <ScrollTable label="Groups of differences" minWidth={720}>
      <Table.Thead>
        <Table.Tr>
          <Table.Th>What differs</Table.Th>
          <Table.Th>Kind</Table.Th>
          <Table.Th ta="right">Cases</Table.Th>
          <Table.Th ta="right">Valid</Table.Th>
          <Table.Th aria-label="Cases of the group" />
        </Table.Tr>
      </Table.Thead>
      <Table.Tbody>
        {groups.map(({ index, text, kind, size, valid }) => {
          const shown = index === selected;
          return (
            <Table.Tr key={index}>
              <Table.Td>
                <UserText>{text}</UserText>
              </Table.Td>
              <Table.Td>{KIND_LABELS[kind]}</Table.Td>
              <Table.Td ta="right">{size}</Table.Td>
              <Table.Td ta="right">{valid}</Table.Td>
              <Table.Td ta="right">
                <Button
                  size="compact-xs"
                  variant="default"
                  aria-expanded={shown}
                  aria-label={`${shown ? 'Hide' : 'Show'} cases: ${text}`}
                  onClick={() => {
                    onSelect(shown ? undefined : index);
                  }}
                >
                  {shown ? 'Hide cases' : 'Show cases'}
                </Button>
              </Table.Td>
            </Table.Tr>
          );
        })}
      </Table.Tbody>
    </ScrollTable>
  );
}
