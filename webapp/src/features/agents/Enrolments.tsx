import { Button, Code, NumberInput, Stack, Table, Text, TextInput } from '@mantine/core';
import { useState } from 'react';
import { formatInstant } from '@/shared/lib/format';
import { IssueForm, Loading, ProblemAlert, ScrollTable, UserText } from '@/shared/ui';
import { useDeleteEnrolment, useEnrol, useEnrolments } from './queries';

/** Tokens that let new agents in, for administrators. */
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
      <IssueForm
        issue={enrol}
        wish={{
          uses: Number(uses),
          hours: Number(hours),
          ...(agent.trim() !== '' && { agent: agent.trim() }),
        }}
        action="Make a token"
        refused="No token was made"
        secretOf={({ secret }) => ({
          title: 'Token for a new agent',
          secret,
          use: (
            <>
              <Text size="sm" mt="sm">
                On the machine of the agent, with the server’s address for agents in the place of
                SERVER:9090:
              </Text>
              <Code
                block
              >{`SITAF_ENROLMENT_TOKEN=${secret} ./sitaf agent --server SERVER:9090`}</Code>
            </>
          ),
        })}
      >
        <TextInput
          label="Name of the agent"
          placeholder="any that is new"
          value={agent}
          onChange={(event) => {
            setAgent(event.currentTarget.value);
          }}
        />
        <NumberInput
          label="Agents"
          min={1}
          max={10_000}
          required
          w={100}
          value={uses}
          onChange={(value) => {
            setUses(String(value));
          }}
        />
        <NumberInput
          label="Hours"
          min={1}
          max={720}
          required
          w={100}
          value={hours}
          onChange={(value) => {
            setHours(String(value));
          }}
        />
      </IssueForm>
      {remove.isError && (
        <ProblemAlert title="It was not deleted" error={remove.error} onClose={remove.reset} />
      )}
      {enrolments.data.items.length > 0 && (
        <ScrollTable label="Enrolments" minWidth={560}>
          <Table.Thead>
            <Table.Tr>
              <Table.Th>For</Table.Th>
              <Table.Th ta="right">Agents left</Table.Th>
              <Table.Th>Ends</Table.Th>
              <Table.Th>Made by</Table.Th>
              <Table.Th aria-label="Actions" />
            </Table.Tr>
          </Table.Thead>
          <Table.Tbody>
            {enrolments.data.items.map((item) => (
              <Table.Tr key={item.id}>
                <Table.Td>
                  {item.agent ? <UserText>{item.agent}</UserText> : 'any new agent'}
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
                    aria-label={`Delete the token for ${item.agent ?? 'any new agent'} made ${formatInstant(item.created)}`}
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
