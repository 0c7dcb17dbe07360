import { Table, Text } from '@mantine/core';
import { Age, Loading, ProblemAlert, ScrollTable, UserText } from '@/shared/ui';
import { useAgents } from './queries';

/** The agents that are or once were connected; brief: without what only an administrator asks for. */
export function AgentTable({ brief = false }: { brief?: boolean }) {
  const agents = useAgents();
  if (agents.isPending) return <Loading what="agents" />;
  if (!agents.data) {
    return <ProblemAlert title="The agents could not be read" error={agents.error} />;
  }
  if (agents.data.length === 0) {
    return (
      <Text c="dimmed">
        No agent has ever connected: builds wait. “sitaf agent” starts one on any machine.
      </Text>
    );
  }
  return (
    <ScrollTable label="Agents" minWidth={brief ? 320 : 720}>
      <Table.Thead>
        <Table.Tr>
          <Table.Th>Agent</Table.Th>
          <Table.Th>State</Table.Th>
          <Table.Th ta="right">Busy</Table.Th>
          {!brief && (
            <>
              <Table.Th>Toolchains</Table.Th>
              <Table.Th>Version</Table.Th>
              <Table.Th>Last heard of</Table.Th>
            </>
          )}
        </Table.Tr>
      </Table.Thead>
      <Table.Tbody>
        {agents.data.map((agent) => (
          <Table.Tr key={agent.name}>
            <Table.Td>
              <UserText>{agent.name}</UserText>
            </Table.Td>
            <Table.Td>
              <span aria-hidden>{agent.state === 'ONLINE' ? '●' : '○'}</span>{' '}
              {agent.state === 'ONLINE' ? 'Online' : 'Offline'}
            </Table.Td>
            <Table.Td ta="right">
              {agent.busy} of {agent.slots}
            </Table.Td>
            {!brief && (
              <>
                <Table.Td>
                  <UserText>
                    {agent.toolchains
                      .map(({ language, version }) => `${language} ${version}`)
                      .join(', ')}
                  </UserText>
                </Table.Td>
                <Table.Td>
                  <UserText>{agent.version}</UserText>
                </Table.Td>
                <Table.Td>
                  <Age at={agent.lastSeen} />
                </Table.Td>
              </>
            )}
          </Table.Tr>
        ))}
      </Table.Tbody>
    </ScrollTable>
  );
}
