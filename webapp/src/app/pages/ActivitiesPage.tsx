import { Group, Stack, Title } from '@mantine/core';
import { getRouteApi } from '@tanstack/react-router';
import { BuildNow, useStartBuild } from '@/app/building';
import { fromIndex, toIndex, withoutAbsent, type ListSearch } from '@/app/search';
import { ActivityList, UploadActivity } from '@/features/activities';
import { ProblemAlert, ButtonLink } from '@/shared/ui';

const route = getRouteApi('/activities');

/** All activities, with the two ways to create one. */
export function ActivitiesPage() {
  const { page } = route.useSearch();
  const navigate = route.useNavigate();
  const start = useStartBuild();
  return (
    <Stack gap="lg">
      <title>Activities · SITAF</title>
      <Group justify="space-between">
        <Title order={1} size="h2">
          Activities
        </Title>
        <ButtonLink to="/activities/new">New activity</ButtonLink>
      </Group>
      <UploadActivity />
      {start.isError && (
        <ProblemAlert
          title={`The build of ${start.variables.model} was not started`}
          error={start.error}
          onClose={start.reset}
        />
      )}
      <ActivityList
        page={toIndex(page)}
        onPage={(index) =>
          void navigate({
            search: withoutAbsent<ListSearch>({ page: fromIndex(index) }),
            resetScroll: false,
          })
        }
        modelAction={(activity, model) => (
          <BuildNow activity={activity} model={model} start={start} />
        )}
      />
    </Stack>
  );
}
