import { Button, Code, NumberInput, Stack, Table, Text, TextInput } from '@mantine/core';
import { useState } from 'react';
import { formatInstant } from '@/shared/lib/format';
import { SecretForm, Loading, ProblemAlert, ScrollTable, UserText } from '@/shared/ui';
import { useDeleteEnrolment, useEnrol, useEnrolments } from './queries';

/** Enrolment tokens for new agents, for administrators. */
export function Enrolments() {
  const enrolments = useEnrolments();
  const enrol = useEnrol();
  const remove = useDeleteEnrolment();
  const [agent, setAgent] = useState('');
  const [uses, setUses] = useState('1');
  const [hours, setHours] = useState('24');
  if (enrolments.isPending) return <Loading what="the enrolments" />;
  if (!enrolments.data) {
    return <ProblemAlert title="The enrolments could not be read" error={enrolments.error} />;
  }

  return (
    <Stack gap="sm">
      <SecretForm
        issue={enrol}
        variables={{
          uses: Number(uses),
          hours: Number(hours),
          ...(agent.trim() !== '' && { agent: agent.trim() }),
        }}
        action="Create token"
        failed="The token was not created"
        secretOf={({ secret }) => ({
          title: 'Enrolment token',
          secret,
          instructions: (
            <>
              <Text size="sm" mt="sm">
                Run this on the agent’s machine. Replace SERVER:9090 by the address of the server
                for agents:
              </Text>
              <Code
                block
              >{`SITAF_ENROLMENT_TOKEN=${secret} ./sitaf agent --server SERVER:9090`}</Code>
            </>
          ),
        })}
      >
        <TextInput
          label="Agent name"
          placeholder="Any new name"
          value={agent}
          onChange={(event) => {
            setAgent(event.currentTarget.value);
          }}
        />
        <NumberInput
          label="Number of agents"
          min={1}
          max={10_000}
          required
          w={180}
          value={uses}
          onChange={(value) => {
            setUses(String(value));
          }}
        />
        <NumberInput
          label="Valid for (hours)"
          min={1}
          max={720}
          required
          w={180}
          value={hours}
          onChange={(value) => {
            setHours(String(value));
          }}
        />
      </SecretForm>
      {remove.isError && (
        <ProblemAlert
          title="The token was not deleted"
          error={remove.error}
          onClose={remove.reset}
        />
      )}
      {enrolments.data.items.length > 0 && (
        <ScrollTable label="Enrolments" minWidth={560}>
          <Table.Thead>
            <Table.Tr>
              <Table.Th>Agent</Table.Th>
              <Table.Th ta="right">Remaining uses</Table.Th>
              <Table.Th>Expires</Table.Th>
              <Table.Th>Created by</Table.Th>
              <Table.Th aria-label="Actions" />
            </Table.Tr>
          </Table.Thead>
          <Table.Tbody>
            {enrolments.data.items.map((item) => (
              <Table.Tr key={item.id}>
                <Table.Td>
                  {item.agent ? <UserText>{item.agent}</UserText> : 'Any new agent'}
                </Table.Td>
                <Table.Td ta="right">{item.usesLeft}</Table.Td>
                <Table.Td>{formatInstant(item.expires)}</Table.Td>
                <Table.Td>
                  <UserText>{item.createdBy}</UserText>
                </Table.Td>
                <Table.Td ta="right">
                  <Button
                    size="compact-xs"
                    variant="default"
                    aria-label={`Delete the token for ${item.agent ?? 'any new agent'} created ${formatInstant(item.created)}`}
                    onClick={() => {
                      remove.mutate(item.id);
                    }}
                  >
                    Delete
                  </Button>
                </Table.Td>
              </Table.Tr>
            ))}
          </Table.Tbody>
        </ScrollTable>
      )}
    </Stack>
  );
}
