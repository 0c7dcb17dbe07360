import { Group, Stack, Title } from '@mantine/core';
import { getRouteApi } from '@tanstack/react-router';
import { BuildNow, useStartBuild } from '@/app/building';
import { fromIndex, toIndex, withoutAbsent, type ActivitiesSearch } from '@/app/search';
import { ActivityList, TagFilter, UploadActivity } from '@/features/activities';
import { ButtonLink, ProblemAlert, SearchField } from '@/shared/ui';

const route = getRouteApi('/activities');

/** All activities, with the two ways to create one. */
export function ActivitiesPage() {
  const { page, search, tag } = route.useSearch();
  const navigate = route.useNavigate();
  const show = (wanted: {
    page?: number | undefined;
    search?: string | undefined;
    tag?: string | undefined;
  }) => void navigate({ search: withoutAbsent<ActivitiesSearch>(wanted), resetScroll: false });
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
            onSearch={(text) => {
              show({ search: text, tag });
            }}
          />
          <TagFilter
            tag={tag}
            onTag={(chosen) => {
              show({ search, tag: chosen });
            }}
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
        tag={tag}
        onPage={(index) => {
          show({ page: fromIndex(index), search, tag });
        }}
        modelAction={(activity, model) => (
          <BuildNow activity={activity} model={model} start={start} />
        )}
      />
    </Stack>
  );
}
