import { SimpleGrid, Stack, Title } from '@mantine/core';
import { FavouriteList } from '@/features/activities';
import { AgentTable } from '@/features/agents';
import { BuildList, FailingActivities } from '@/features/builds';
import { ScheduleList } from '@/features/schedules';
import { RouteLink, Section } from '@/shared/ui';

/** An overview of builds, agents and schedules. */
export function HomePage() {
  return (
    <Stack gap="lg">
      <title>SITAF</title>
      <Title order={1} size="h3">
        Interface tests
      </Title>
      <FavouriteList />
      <Section
        title="Recent builds"
        actions={
          <RouteLink to="/builds" size="sm">
            All builds
          </RouteLink>
        }
      >
        <BuildList page={0} size={6} />
      </Section>
      <Section
        title="Failing activities"
        actions={
          <RouteLink to="/activities" size="sm">
            All activities
          </RouteLink>
        }
      >
        <FailingActivities />
      </Section>
      <SimpleGrid cols={{ base: 1, md: 2 }} spacing="xl">
        <Section
          title="Agents"
          actions={
            <RouteLink to="/agents" size="sm">
              All agents
            </RouteLink>
          }
        >
          <AgentTable brief />
        </Section>
        <Section
          title="Upcoming schedules"
          actions={
            <RouteLink to="/schedules" size="sm">
              All schedules
            </RouteLink>
          }
        >
          <ScheduleList page={0} upcoming />
        </Section>
      </SimpleGrid>
    </Stack>
  );
}
