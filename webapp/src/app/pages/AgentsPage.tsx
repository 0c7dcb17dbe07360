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
          Agents compile and execute test applications. The number of slots is the number of builds
          that an agent runs at the same time.
        </Text>
      </div>
      <AgentTable mayChange={administrator} />
      {administrator && (
        <Section title="Enroll an agent">
          <Enrolments />
        </Section>
      )}
    </Stack>
  );
}
