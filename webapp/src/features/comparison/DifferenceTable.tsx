import { Button, Table } from '@mantine/core';
import type { Difference } from '@/shared/api';
import { ScrollTable, UserText } from '@/shared/ui';

/** A case whose replays are shown. */
export interface ShownCase {
  no: number;
  baseNo: number;
  /** Seconds after the call of the first divergent step. */
  at: number | undefined;
}

interface DifferenceTableProps {
  label: string;
  items: readonly Difference[];
  parameters: readonly string[];
  onReplays: (shown: ShownCase) => void;
}

/** Differences with their inputs and both values. */
export function DifferenceTable({ label, items, parameters, onReplays }: DifferenceTableProps) {
  return (
    <ScrollTable label={label} minWidth={720}>
      <Table.Thead>
        <Table.Tr>
          <Table.Th>No</Table.Th>
          {parameters.map((name) => (
            <Table.Th key={name} ta="right">
              <UserText>{name}</UserText>
            </Table.Th>
          ))}
          <Table.Th>Output</Table.Th>
          <Table.Th>Before</Table.Th>
          <Table.Th>Now</Table.Th>
          <Table.Th ta="right">At (s)</Table.Th>
          <Table.Th aria-label="Replays" />
        </Table.Tr>
      </Table.Thead>
      <Table.Tbody>
        {items.map((item, index) => (
          <Table.Tr key={index}>
            <Table.Td>
              {item.no === 0 ? 'all' : item.no}
              {!item.valid && ' (invalid)'}
            </Table.Td>
            {parameters.map((name) => (
              <Table.Td key={name} ta="right">
                <UserText>{item.inputs[name] ?? ''}</UserText>
              </Table.Td>
            ))}
            <Table.Td>
              <UserText>{outputOf(item)}</UserText>
            </Table.Td>
            <Table.Td>
              <UserText>{item.base}</UserText>
            </Table.Td>
            <Table.Td>
              <UserText>{item.now}</UserText>
            </Table.Td>
            <Table.Td ta="right">{item.at ?? '–'}</Table.Td>
            <Table.Td ta="right">
              {item.no > 0 && (
                <Button
                  size="compact-xs"
                  variant="default"
                  aria-label={`Replays of case ${item.no}`}
                  onClick={() => {
                    onReplays({ no: item.no, baseNo: item.baseNo, at: item.at });
                  }}
                >
                  Replays
                </Button>
              )}
            </Table.Td>
          </Table.Tr>
        ))}
      </Table.Tbody>
    </ScrollTable>
  );
}

/** The output, and the first step of a sequence that differs. */
function outputOf({ output, step, call }: Difference): string {
  const place = step === undefined ? '' : `step ${step}, ${call ?? ''}`;
  return [output, place].filter(Boolean).join(': ') || '–';
}
