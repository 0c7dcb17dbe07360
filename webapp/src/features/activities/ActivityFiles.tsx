import { Table } from '@mantine/core';
import type { Activity } from '@/shared/api';
import { formatCount } from '@/shared/lib/format';
import { ScrollTable, UserText } from '@/shared/ui';

export function ActivityFiles({ activity }: { activity: Activity }) {
  return (
    <ScrollTable label="Files" minWidth={480}>
      <Table.Thead>
        <Table.Tr>
          <Table.Th>File</Table.Th>
          <Table.Th ta="right">Bytes</Table.Th>
        </Table.Tr>
      </Table.Thead>
      <Table.Tbody>
        {activity.files.map((file) => (
          <Table.Tr key={file.path}>
            <Table.Td>
              <UserText>{file.path}</UserText>
            </Table.Td>
            <Table.Td ta="right">{formatCount(file.size)}</Table.Td>
          </Table.Tr>
        ))}
      </Table.Tbody>
    </ScrollTable>
  );
}
