import { Stack, Text, Title } from '@mantine/core';
import { AgentTable, Enrolments } from '@/features/agents';
import { useSession } from '@/features/session';
import { Section } from '@/shared/ui';

export function AgentsPage() {
  const session = useSession();
  const administrator = session.data?.role === 'ADMINISTRATOR';
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
      <AgentTable mayChange={administrator} />
      {administrator && (
        <Section title="Let an agent in">
          <Enrolments />
        </Section>
      )}
    </Stack>
  );
}
