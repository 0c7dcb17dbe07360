import { Table } from '@mantine/core';
import type { Result } from '@/shared/api';
import { formatCount } from '@/shared/lib/format';
import { ScrollTable, UserText } from '@/shared/ui';

/** In how many cases each relation was checked; nothing if there are no relations. */
export function RelationCounts({ relations }: { relations: Result['relations'] }) {
  if (relations.length === 0) return null;
  return (
    <ScrollTable label="Relations between two runs" minWidth={420}>
      <Table.Thead>
        <Table.Tr>
          <Table.Th>Relation between two runs</Table.Th>
          <Table.Th ta="right">Checked</Table.Th>
          <Table.Th ta="right">Broken</Table.Th>
          <Table.Th ta="right">Skipped</Table.Th>
          <Table.Th ta="right">Errors</Table.Th>
        </Table.Tr>
      </Table.Thead>
      <Table.Tbody>
        {relations.map(({ name, checked, broken, skipped, errors }) => (
          <Table.Tr key={name}>
            <Table.Th scope="row">
              <UserText>{name}</UserText>
            </Table.Th>
            {[checked, broken, skipped, errors].map((count, index) => (
              <Table.Td key={index} ta="right">
                {formatCount(count)}
              </Table.Td>
            ))}
          </Table.Tr>
        ))}
      </Table.Tbody>
    </ScrollTable>
  );
}
