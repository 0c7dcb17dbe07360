import { Button, Stack, Title } from '@mantine/core';
import { ActivityList, UploadActivity } from '@/features/activities';
import { BuildList } from '@/features/builds';
import { ProblemAlert, Section } from '@/shared/ui';
import { fromIndex, homeSearch, toIndex, type HomeSearch } from './search';
import { useStartBuild } from './useStartBuild';

interface HomePageProps {
  shown: HomeSearch;
  onShow: (search: HomeSearch) => void;
}

/** Activities and builds at a glance, and the way from one to the other. */
export function HomePage({ shown, onShow }: HomePageProps) {
  const start = useStartBuild();
  return (
    <Stack gap="xl">
      <title>SITAF</title>
      <Title order={1} size="h2">
        Interface tests
      </Title>
      <Section title="Activities">
        <UploadActivity />
        {start.isError && (
          <ProblemAlert
            title={`${start.variables.model} was not built`}
            error={start.error}
            onClose={start.reset}
          />
        )}
        <ActivityList
          page={toIndex(shown.activities)}
          onPage={(page) => {
            onShow(homeSearch({ ...shown, activities: fromIndex(page) }));
          }}
          modelAction={(activity, model) => (
            <Button
              size="xs"
              aria-label={`Build now: ${activity.name} ${model.name}`}
              disabled={start.isPending}
              loading={
                start.isPending &&
                start.variables.activityId === activity.id &&
                start.variables.model === model.name
              }
              onClick={() => {
                start.mutate({ activityId: activity.id, model: model.name });
              }}
            >
              Build now
            </Button>
          )}
        />
      </Section>
      <Section title="Builds">
        <BuildList
          page={toIndex(shown.builds)}
          onPage={(page) => {
            onShow(homeSearch({ ...shown, builds: fromIndex(page) }));
          }}
        />
      </Section>
    </Stack>
  );
}
