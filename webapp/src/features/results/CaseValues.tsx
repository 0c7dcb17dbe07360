import { Table } from '@mantine/core';
import type { ResultCase, ResultParameter } from '@/shared/api';
import { ScrollTable, UserText } from '@/shared/ui';
import { differenceOf } from './difference';
import classes from './results.module.css';
import { shortNumber } from './shortNumber';

interface CaseValuesProps {
  item: ResultCase;
  parameters: readonly ResultParameter[];
}

/** The inputs of a case and its outputs, expected and actual with their difference. */
export function CaseValues({ item, parameters }: CaseValuesProps) {
  const expected = item.expected ?? {};
  const actual = item.actual ?? {};
  const failed = item.verdict !== 'PASS';
  const outputs = [...new Set([...Object.keys(expected), ...Object.keys(actual)])];
  return (
    <ScrollTable
      label={`Values of case ${item.no}`}
      minWidth={260}
      className={classes.values ?? ''}
      verticalSpacing={2}
      horizontalSpacing={6}
    >
      {parameters.length > 0 && (
        <Table.Tbody>
          {parameters.map(({ name, type }, index) => (
            <Table.Tr key={name}>
              <Table.Th scope="row">
                <UserText>{name}</UserText> <span className={classes.kind}>{type}</span>
              </Table.Th>
              <Table.Td colSpan={3}>
                <UserText>{item.values[index] ?? ''}</UserText>
              </Table.Td>
            </Table.Tr>
          ))}
        </Table.Tbody>
      )}
      {outputs.length > 0 && (
        <Table.Tbody>
          <Table.Tr className={classes.outputs ?? ''}>
            <Table.Th scope="col">Output</Table.Th>
            <Table.Th scope="col">Expected</Table.Th>
            <Table.Th scope="col">Actual</Table.Th>
            <Table.Th scope="col">Difference</Table.Th>
          </Table.Tr>
          {outputs.map((name) => (
            <Table.Tr key={name}>
              <Table.Th scope="row">
                <UserText>{name}</UserText>
              </Table.Th>
              <Table.Td title={expected[name]}>
                <UserText>{shortNumber(expected[name])}</UserText>
              </Table.Td>
              <Table.Td
                title={actual[name]}
                data-differs={(failed && expected[name] !== actual[name]) || undefined}
              >
                <UserText>{shortNumber(actual[name])}</UserText>
              </Table.Td>
              <Table.Td>{differenceOf(expected[name], actual[name]) ?? ''}</Table.Td>
            </Table.Tr>
          ))}
        </Table.Tbody>
      )}
    </ScrollTable>
  );
}
