import { Stack, Text, Title } from '@mantine/core';
import { getRouteApi } from '@tanstack/react-router';
import { fromIndex, toIndex, withoutAbsent, type ListSearch } from '@/app/search';
import { ScheduleList } from '@/features/schedules';

const route = getRouteApi('/schedules');

export function SchedulesPage() {
  const { page } = route.useSearch();
  const navigate = route.useNavigate();
  return (
    <Stack gap="lg">
      <title>Schedules · SITAF</title>
      <div>
        <Title order={1} size="h2">
          Schedules
        </Title>
        <Text c="dimmed" size="sm">
          Builds at a time to come. A new one is made where its activity is: “Build later”.
        </Text>
      </div>
      <ScheduleList
        page={toIndex(page)}
        onPage={(index) =>
          void navigate({
            search: withoutAbsent<ListSearch>({ page: fromIndex(index) }),
            resetScroll: false,
          })
        }
      />
    </Stack>
  );
}
