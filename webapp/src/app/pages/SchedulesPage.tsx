import { Group, Stack, Text, Title } from '@mantine/core';
import { getRouteApi } from '@tanstack/react-router';
import { fromIndex, toIndex, withoutAbsent, type ListSearch } from '@/app/search';
import { Calendars, ScheduleList } from '@/features/schedules';
import { ButtonLink, Section } from '@/shared/ui';

const route = getRouteApi('/schedules');

export function SchedulesPage() {
  const { page } = route.useSearch();
  const navigate = route.useNavigate();
  return (
    <Stack gap="lg">
      <title>Schedules · SITAF</title>
      <Group justify="space-between" align="start">
        <div>
          <Title order={1} size="h2">
            Schedules
          </Title>
          <Text c="dimmed" size="sm">
            Schedules start builds at set times, once or repeatedly.
          </Text>
        </div>
        <ButtonLink to="/schedules/new">New schedule</ButtonLink>
      </Group>
      <ScheduleList
        page={toIndex(page)}
        onPage={(index) =>
          void navigate({
            search: withoutAbsent<ListSearch>({ page: fromIndex(index) }),
            resetScroll: false,
          })
        }
      />
      <Section title="Calendars">
        <Calendars />
      </Section>
    </Stack>
  );
}
