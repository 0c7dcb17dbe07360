import { Group, Stack, Text, Title } from '@mantine/core';
import { getRouteApi } from '@tanstack/react-router';
import { withoutAbsent, type FoundSearch } from '@/app/search';
import { AgentTable, Enrolments } from '@/features/agents';
import { useSession } from '@/features/session';
import { SearchField, Section } from '@/shared/ui';

const route = getRouteApi('/agents');

export function AgentsPage() {
  const { search } = route.useSearch();
  const navigate = route.useNavigate();
  const session = useSession();
  const administrator = session.data?.role === 'ADMINISTRATOR';
  return (
    <Stack gap="lg">
      <title>Agents · SITAF</title>
      <div>
        <Group justify="space-between">
          <Title order={1} size="h3">
            Agents
          </Title>
          <SearchField
            label="Search agents"
            value={search}
            onSearch={(text) =>
              void navigate({ search: withoutAbsent<FoundSearch>({ search: text }) })
            }
          />
        </Group>
        <Text c="dimmed" size="sm">
          Agents compile and execute test applications. The number of slots is the number of builds
          that an agent runs at the same time.
        </Text>
      </div>
      <AgentTable mayChange={administrator} search={search} />
      {administrator && (
        <Section title="Enroll an agent">
          <Enrolments />
        </Section>
      )}
    </Stack>
  );
}
