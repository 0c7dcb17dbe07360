import { Table } from '@mantine/core';
import { ScrollTable, UserText } from '@/shared/ui';
import type { Parameter } from '../parameters';

/** The parameters of a model and the numbers of their values. */
export function ParameterTable({ parameters }: { parameters: readonly Parameter[] }) {
  const hasCalls = parameters.some(({ call }) => call !== '');
  return (
    <ScrollTable label="Parameters" minWidth={480}>
      <Table.Thead>
        <Table.Tr>
          {hasCalls && <Table.Th>Call</Table.Th>}
          <Table.Th>Parameter</Table.Th>
          <Table.Th>Kind</Table.Th>
          <Table.Th>Type</Table.Th>
          <Table.Th>Scheme</Table.Th>
          <Table.Th ta="right">Valid</Table.Th>
          <Table.Th ta="right">Invalid</Table.Th>
        </Table.Tr>
      </Table.Thead>
      <Table.Tbody>
        {parameters.map(({ call, input, values }) => {
          const all = values?.values ?? [];
          const valid = all.filter((value) => value.valid).length;
          return (
            <Table.Tr key={`${call} ${input.name}`}>
              {hasCalls && (
                <Table.Td>
                  <UserText>{call}</UserText>
                </Table.Td>
              )}
              <Table.Td>
                <UserText>{input.name}</UserText>
              </Table.Td>
              <Table.Td>{input.kind}</Table.Td>
              <Table.Td>
                <UserText>{input.realType}</UserText>
              </Table.Td>
              <Table.Td>
                {[input.spec, ...input.furtherSpecs].map((spec) => spec?.type ?? '–').join(', ')}
              </Table.Td>
              <Table.Td ta="right">{valid}</Table.Td>
              <Table.Td ta="right">{all.length - valid}</Table.Td>
            </Table.Tr>
          );
        })}
      </Table.Tbody>
    </ScrollTable>
  );
}
