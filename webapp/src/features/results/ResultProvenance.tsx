import { Code, Table, Text } from '@mantine/core';
import type { Provenance } from '@/shared/api';
import { ScrollTable, Section, UserText } from '@/shared/ui';

/** What was executed with which tools and packages. */
export function ResultProvenance({ provenance }: { provenance: Provenance }) {
  const { agent, bridge, compiler, component, harness, packages, suite } = provenance;
  const facts = [
    { name: 'Component', value: component, digest: true },
    { name: 'Test suite', value: suite, digest: true },
    { name: 'Test application', value: harness, digest: true },
    { name: 'Compiler', value: compiler },
    { name: 'Simulator', value: bridge },
    { name: 'Agent', value: agent },
  ].filter(({ value }) => value !== '');
  return (
    <Section title="What was executed">
      <ScrollTable label="What was executed" minWidth={480}>
        <Table.Tbody>
          {facts.map(({ name, value, digest }) => (
            <Table.Tr key={name}>
              <Table.Th scope="row">{name}</Table.Th>
              <Table.Td>{digest ? <Code>{value}</Code> : <UserText>{value}</UserText>}</Table.Td>
            </Table.Tr>
          ))}
          {packages.map(({ name, version, sha256 }) => (
            <Table.Tr key={`${name} ${version} ${sha256}`}>
              <Table.Th scope="row">Package</Table.Th>
              <Table.Td>
                <UserText>{`${name} ${version}`}</UserText> <Code>{sha256}</Code>
              </Table.Td>
            </Table.Tr>
          ))}
        </Table.Tbody>
      </ScrollTable>
      <Text size="sm" c="dimmed">
        Long values are SHA-256 digests. ./sitaf lock keeps the packages of an activity.
      </Text>
    </Section>
  );
}
