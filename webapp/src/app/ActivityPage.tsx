import { Stack, Text, Title } from '@mantine/core';
import { ActivityFiles, useActivity } from '@/features/activities';
import { BuildList } from '@/features/builds';
import { ApiError } from '@/shared/api';
import { Loading, ProblemAlert, Section, UserText } from '@/shared/ui';
import { BuildForm } from './BuildForm';
import { NotFound } from './NotFound';
import { activitySearch, fromIndex, toIndex, type ActivitySearch } from './search';

interface ActivityPageProps {
  activityId: string;
  shown: ActivitySearch;
  onShow: (search: ActivitySearch) => void;
}

export function ActivityPage({ activityId, shown, onShow }: ActivityPageProps) {
  const activity = useActivity(activityId);
  if (activity.isPending) return <Loading what="the activity" />;
  if (!activity.data) {
    return activity.error instanceof ApiError && activity.error.status === 404 ? (
      <NotFound />
    ) : (
      <ProblemAlert title="The activity could not be read" error={activity.error} />
    );
  }
  const { name, description, language, componentClass } = activity.data;
  return (
    <Stack gap="xl">
      <title>{`${name} · SITAF`}</title>
      <div>
        <Title order={1} size="h2">
          <UserText>{name}</UserText>
        </Title>
        {description && (
          <Text>
            <UserText>{description}</UserText>
          </Text>
        )}
        <Text size="sm" c="dimmed">
          <UserText>{[language, componentClass].filter(Boolean).join(' · ')}</UserText>
        </Text>
      </div>
      <Section title="Test models">
        <BuildForm activity={activity.data} />
      </Section>
      <Section title="Builds">
        <BuildList
          activityId={activityId}
          page={toIndex(shown.builds)}
          onPage={(page) => {
            onShow(activitySearch({ builds: fromIndex(page) }));
          }}
        />
      </Section>
      <Section title="Files">
        <ActivityFiles activity={activity.data} />
      </Section>
    </Stack>
  );
}
