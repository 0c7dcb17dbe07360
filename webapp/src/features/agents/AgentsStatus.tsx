import { Text } from '@mantine/core';
import { plural } from '@/shared/lib/format';
import { useAgents } from './queries';

/** The number of connected agents. Without any, the user learns why builds wait. */
export function AgentsStatus() {
  const agents = useAgents();
  if (!agents.data) return null;
  const online = agents.data.filter((agent) => agent.state === 'ONLINE');
  const slots = online.reduce((sum, agent) => sum + agent.slots, 0);
  const busy = online.reduce((sum, agent) => sum + agent.busy, 0);
  return (
    <Text size="sm" role="status">
      {online.length === 0
        ? 'No agent online: builds wait'
        : `${plural(online.length, 'agent')} online, ${busy} of ${plural(slots, 'slot')} busy`}
    </Text>
  );
}
