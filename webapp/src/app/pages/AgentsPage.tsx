import { Stack, Text, Title } from '@mantine/core';
import { AgentTable } from '@/features/agents';

export function AgentsPage() {
  return (
    <Stack gap="lg">
      <title>Agents · SITAF</title>
      <div>
        <Title order={1} size="h2">
          Agents
        </Title>
        <Text c="dimmed" size="sm">
          Programs that compile and execute test applications; each runs as many builds at a time as
          it has slots.
        </Text>
      </div>
      <AgentTable />
    </Stack>
  );
}
