import { Stack, Table, Text } from '@mantine/core';
import type { ResultCase, ResultParameter } from '@/shared/api';
import { ScrollTable, UserText } from '@/shared/ui';
import classes from './results.module.css';
import { shortNumber } from './shortNumber';

type Relation = ResultCase['relations'][number];

const VERDICTS = {
  PASS: 'holds',
  FAIL: 'is broken',
  ERROR: 'could not be checked',
  SKIPPED: 'does not apply',
} as const;

interface RelationRunsProps {
  item: ResultCase;
  parameters: readonly ResultParameter[];
}

/** The relations of a case, with the inputs and outputs of both runs. */
export function RelationRuns({ item, parameters }: RelationRunsProps) {
  return item.relations.map((relation) => (
    <Stack key={relation.name} gap={4}>
      <Text size="sm" fw={600}>
        <UserText>{`Relation “${relation.name}” ${VERDICTS[relation.verdict]}`}</UserText>
      </Text>
      {relation.values.length > 0 ? (
        <BothRuns item={item} relation={relation} parameters={parameters} />
      ) : (
        <Text size="sm" c="dimmed">
          <UserText>{relation.message ?? ''}</UserText>
        </Text>
      )}
    </Stack>
  ));
}

/** A value a row, because a case with many inputs would be wider than its page. */
function BothRuns({ item, relation, parameters }: RelationRunsProps & { relation: Relation }) {
  const outputs = [...new Set([...Object.keys(item.actual), ...Object.keys(relation.actual)])];
  const rows = [
    ...parameters.map(({ name }, index) => ({
      key: `i ${name}`,
      label: name,
      first: item.values[index],
      second: relation.values[index],
    })),
    ...outputs.map((name) => ({
      key: `o ${name}`,
      label: `Actual ${name}`,
      first: item.actual[name],
      second: relation.actual[name],
    })),
  ];
  return (
    <ScrollTable
      label={`Runs of the relation ${relation.name}`}
      minWidth={260}
      className={classes.values ?? ''}
      verticalSpacing={2}
      horizontalSpacing={6}
    >
      <Table.Thead>
        <Table.Tr>
          <Table.Th>Value</Table.Th>
          <Table.Th>First run</Table.Th>
          <Table.Th>Second run</Table.Th>
        </Table.Tr>
      </Table.Thead>
      <Table.Tbody>
        {rows.map(({ key, label, first, second }) => (
          <Table.Tr key={key}>
            <Table.Th scope="row">
              <UserText>{label}</UserText>
            </Table.Th>
            <Table.Td title={first}>
              <UserText>{shortNumber(first)}</UserText>
            </Table.Td>
            <Table.Td title={second} fw={first === second ? undefined : 600}>
              <UserText>{shortNumber(second)}</UserText>
            </Table.Td>
          </Table.Tr>
        ))}
      </Table.Tbody>
    </ScrollTable>
  );
}
