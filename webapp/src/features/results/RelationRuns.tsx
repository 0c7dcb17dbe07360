import { Stack, Table, Text } from '@mantine/core';
import type { ResultCase, ResultParameter } from '@/shared/api';
import { ScrollTable, UserText } from '@/shared/ui';

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

function BothRuns({ item, relation, parameters }: RelationRunsProps & { relation: Relation }) {
  const outputs = [...new Set([...Object.keys(item.actual), ...Object.keys(relation.actual)])];
  const runs = [
    { label: 'First run', values: item.values, actual: item.actual },
    { label: 'Second run', values: relation.values, actual: relation.actual },
  ];
  return (
    <ScrollTable label={`Runs of the relation ${relation.name}`} minWidth={320}>
      <Table.Thead>
        <Table.Tr>
          <Table.Th>Run</Table.Th>
          {parameters.map(({ name }) => (
            <Table.Th key={`i ${name}`}>
              <UserText>{name}</UserText>
            </Table.Th>
          ))}
          {outputs.map((name) => (
            <Table.Th key={`o ${name}`}>
              <UserText>{`Actual ${name}`}</UserText>
            </Table.Th>
          ))}
        </Table.Tr>
      </Table.Thead>
      <Table.Tbody>
        {runs.map(({ label, values, actual }) => (
          <Table.Tr key={label}>
            <Table.Th scope="row">{label}</Table.Th>
            {parameters.map(({ name }, index) => (
              <Table.Td key={`i ${name}`}>
                <UserText>{values[index] ?? ''}</UserText>
              </Table.Td>
            ))}
            {outputs.map((name) => (
              <Table.Td key={`o ${name}`}>
                <UserText>{actual[name] ?? '–'}</UserText>
              </Table.Td>
            ))}
          </Table.Tr>
        ))}
      </Table.Tbody>
    </ScrollTable>
  );
}
