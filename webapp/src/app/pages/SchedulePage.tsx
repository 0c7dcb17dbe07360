import { Group, Stack, Text, Title } from '@mantine/core';
import { getRouteApi } from '@tanstack/react-router';
import { NotFound } from '@/app/NotFound';
import { fromIndex, toIndex, withoutAbsent, type ListSearch } from '@/app/search';
import { ScheduleDetails, titleOf, useSchedule } from '@/features/schedules';
import { ApiError } from '@/shared/api';
import { Loading, ProblemAlert, RouteLink, UserText } from '@/shared/ui';

const route = getRouteApi('/schedules/$scheduleId');

export function SchedulePage() {
  const { scheduleId } = route.useParams();
  const { page } = route.useSearch();
  const navigate = route.useNavigate();
  const schedule = useSchedule(scheduleId);
  if (schedule.isPending) return <Loading what="the schedule" />;
  if (!schedule.data) {
    return schedule.error instanceof ApiError && schedule.error.status === 404 ? (
      <NotFound />
    ) : (
      <ProblemAlert title="The schedule could not be read" error={schedule.error} />
    );
  }
  const { data } = schedule;
  return (
    <Stack gap="lg">
      <title>{`${titleOf(data)} · Schedules · SITAF`}</title>
      <div>
        <Text size="sm">
          <RouteLink to="/schedules">Schedules</RouteLink>
        </Text>
        <Title order={1} size="h2">
          <UserText>{titleOf(data)}</UserText>
        </Title>
        <Group gap="md">
          <RouteLink
            to="/activities/$activityId"
            params={{ activityId: data.activityId }}
            size="sm"
          >
            Activity
          </RouteLink>
          {data.suiteId ? (
            <RouteLink to="/suites/$suiteId" params={{ suiteId: data.suiteId }} size="sm">
              Test cases
            </RouteLink>
          ) : (
            <RouteLink
              to="/activities/$activityId/models/$model"
              params={{ activityId: data.activityId, model: data.model }}
              size="sm"
            >
              <UserText>{`Test model ${data.model}, generated for each build`}</UserText>
            </RouteLink>
          )}
        </Group>
      </div>
      <ScheduleDetails
        schedule={data}
        page={toIndex(page)}
        onPage={(index) =>
          void navigate({
            search: withoutAbsent<ListSearch>({ page: fromIndex(index) }),
            resetScroll: false,
          })
        }
        onDeleted={() => void navigate({ to: '/schedules' })}
      />
    </Stack>
  );
}
