import { Group, Stack, Title } from '@mantine/core';
import { getRouteApi } from '@tanstack/react-router';
import { BuildNow, useStartBuild } from '@/app/building';
import { fromIndex, toIndex, withoutAbsent, type FoundSearch } from '@/app/search';
import { ActivityList, UploadActivity } from '@/features/activities';
import { ButtonLink, ProblemAlert, SearchField } from '@/shared/ui';

const route = getRouteApi('/activities');

/** All activities, with the two ways to create one. */
export function ActivitiesPage() {
  const { page, search } = route.useSearch();
  const navigate = route.useNavigate();
  const start = useStartBuild();
  return (
    <Stack gap="md">
      <title>Activities · SITAF</title>
      <Group justify="space-between">
        <Title order={1} size="h3">
          Activities
        </Title>
        <Group gap="sm">
          <SearchField
            label="Search activities"
            value={search}
            onSearch={(text) =>
              void navigate({ search: withoutAbsent<FoundSearch>({ search: text }) })
            }
          />
          <ButtonLink to="/activities/new">New activity</ButtonLink>
        </Group>
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
        search={search}
        onPage={(index) =>
          void navigate({
            search: withoutAbsent<FoundSearch>({ page: fromIndex(index), search }),
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
