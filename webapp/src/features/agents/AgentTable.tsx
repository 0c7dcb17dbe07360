import { Badge, Group, Stack, Table, Text } from '@mantine/core';
import type { Agent } from '@/shared/api';
import { formatCount, plural } from '@/shared/lib/format';
import { Age, Loading, ProblemAlert, ScrollTable, UserText } from '@/shared/ui';
import { AgentActions } from './AgentActions';
import { useAgents } from './queries';

interface AgentTableProps {
  /** Shows the name, the state and the slots only. */
  brief?: boolean;
  /** Shows the actions of administrators. */
  mayChange?: boolean;
  /** A part of a name, a label, a device or a capability; without it, all agents are listed. */
  search?: string | undefined;
}

/** Rows of the brief table and of the whole one. */
const MAX_BRIEF = 8;
const MAX_ROWS = 100;

const REMARKS: Record<Agent['standing'], string> = {
  ACTIVE: '',
  DRAINING: 'draining: accepts no new builds',
  DISABLED: 'disabled',
};

/** All agents that have connected, with their capabilities. */
export function AgentTable({ brief = false, mayChange = false, search }: AgentTableProps) {
  const agents = useAgents();
  if (agents.isPending) return <Loading what="agents" />;
  if (!agents.data) {
    return <ProblemAlert title="The agents could not be read" error={agents.error} />;
  }
  if (agents.data.length === 0) {
    return (
      <Text c="dimmed">
        No agents yet. Start one with “./sitaf agent”; until then, builds wait in the queue.
      </Text>
    );
  }
  const matching = agents.data.filter((agent) => matches(agent, search));
  if (matching.length === 0) return <Text c="dimmed">No agent matches.</Text>;
  const rows = matching
    .toSorted((a, b) => Number(b.state === 'ONLINE') - Number(a.state === 'ONLINE'))
    .slice(0, brief ? MAX_BRIEF : MAX_ROWS);
  return (
    <>
      <ScrollTable label="Agents" minWidth={brief ? 320 : 860}>
        <Table.Thead>
          <Table.Tr>
            <Table.Th>Agent</Table.Th>
            <Table.Th>State</Table.Th>
            <Table.Th ta="right">Busy</Table.Th>
            {!brief && (
              <>
                <Table.Th>Capabilities</Table.Th>
                <Table.Th>Labels</Table.Th>
                <Table.Th>Version</Table.Th>
                <Table.Th>Last seen</Table.Th>
                {mayChange && <Table.Th aria-label="Actions" />}
              </>
            )}
          </Table.Tr>
        </Table.Thead>
        <Table.Tbody>
          {rows.map((agent) => (
            <Table.Tr key={agent.name}>
              <Table.Td>
                <UserText>{agent.name}</UserText>
              </Table.Td>
              <Table.Td>
                <State agent={agent} />
              </Table.Td>
              <Table.Td ta="right">
                {agent.busy} of {agent.slots}
              </Table.Td>
              {!brief && (
                <>
                  <Table.Td>
                    <Capabilities agent={agent} />
                  </Table.Td>
                  <Table.Td>
                    {agent.labels.length === 0 ? (
                      '–'
                    ) : (
                      <Group gap={4}>
                        {agent.labels.map((label) => (
                          <Badge key={label} variant="default" tt="none" fw={500}>
                            {label}
                          </Badge>
                        ))}
                      </Group>
                    )}
                  </Table.Td>
                  <Table.Td>
                    <UserText>{agent.version}</UserText>
                  </Table.Td>
                  <Table.Td>
                    <Age at={agent.lastSeen} />
                  </Table.Td>
                  {mayChange && (
                    <Table.Td>
                      <AgentActions agent={agent} />
                    </Table.Td>
                  )}
                </>
              )}
            </Table.Tr>
          ))}
        </Table.Tbody>
      </ScrollTable>
      {rows.length < matching.length && (
        <Text size="sm" c="dimmed">
          {formatCount(rows.length)} of {plural(matching.length, 'agent')}, those online first.
          {!brief && ' Search to find the others.'}
        </Text>
      )}
    </>
  );
}

/** Every word of the searched text occurs in the agent's name, labels, state or capabilities. */
function matches(agent: Agent, search: string | undefined): boolean {
  const text = [
    agent.name,
    agent.state,
    agent.standing,
    agent.version,
    ...agent.labels,
    ...agent.devices,
    ...agent.toolchains.map(({ language, version }) => `${language} ${version}`),
  ]
    .join(' ')
    .toLowerCase();
  return (search ?? '')
    .toLowerCase()
    .split(/\s+/)
    .every((word) => text.includes(word));
}

function State({ agent }: { agent: Agent }) {
  const online = agent.state === 'ONLINE';
  const remark = agent.refuses ? `accepts no builds: ${agent.refuses}` : REMARKS[agent.standing];
  return (
    <>
      <span aria-hidden>{online ? '●' : '○'}</span> {online ? 'Online' : 'Offline'}
      {remark && (
        <Text size="xs" c="dimmed">
          <UserText>{remark}</UserText>
        </Text>
      )}
    </>
  );
}

function Capabilities({ agent: { toolchains, simulation, devices } }: { agent: Agent }) {
  return (
    <Stack gap={0}>
      {toolchains.map(({ language, version }) => (
        <Text key={language + version} size="sm">
          <UserText>{`${language} ${version}`}</UserText>
        </Text>
      ))}
      <Text size="sm" {...(!simulation && { c: 'dimmed' })}>
        {simulation ? 'simulation' : 'no simulation'}
      </Text>
      {devices.length > 0 && (
        <Text size="sm">
          <UserText>{`${devices.length === 1 ? 'device' : 'devices'} ${devices.join(', ')}`}</UserText>
        </Text>
      )}
    </Stack>
  );
}
