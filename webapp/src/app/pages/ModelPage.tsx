import { Stack, Text, Title } from '@mantine/core';
import { getRouteApi, useNavigate } from '@tanstack/react-router';
import { useMemo } from 'react';
import { NotFound } from '@/app/NotFound';
import { useActivity, useDescription } from '@/features/activities';
import { ModelEditor, readModel, useModelDocument } from '@/features/models';
import { useGenerateSuite } from '@/features/suites';
import { ApiError } from '@/shared/api';
import { Loading, ProblemAlert, RouteLink, UserText } from '@/shared/ui';

const route = getRouteApi('/activities/$activityId/models/$model');
const newRoute = getRouteApi('/activities/$activityId/new-model');

export function ModelPage() {
  const { activityId, model } = route.useParams();
  const document = useModelDocument(activityId, model);
  const existing = useMemo(
    () =>
      document.data && {
        name: model,
        draft: readModel(document.data.document),
        version: document.data.version,
      },
    [document.data, model],
  );
  if (document.isPending) return <Loading what="the test model" />;
  if (!existing) {
    return document.error instanceof ApiError && document.error.status === 404 ? (
      <NotFound />
    ) : (
      <ProblemAlert
        title="The test model could not be read"
        error={document.error ?? new Error('The server did not answer.')}
      />
    );
  }
  return <Editor activityId={activityId} existing={existing} />;
}

export function NewModelPage() {
  const { activityId } = newRoute.useParams();
  return <Editor activityId={activityId} />;
}

interface EditorProps {
  activityId: string;
  existing?: { name: string; draft: ReturnType<typeof readModel>; version: number };
}

function Editor({ activityId, existing }: EditorProps) {
  const activity = useActivity(activityId);
  const description = useDescription(activityId);
  const generate = useGenerateSuite();
  const navigate = useNavigate();
  if (activity.isPending || description.isPending) return <Loading what="the activity" />;
  if (!activity.data || !description.data) {
    return activity.error instanceof ApiError && activity.error.status === 404 ? (
      <NotFound />
    ) : (
      <ProblemAlert
        title="The activity could not be read"
        error={activity.error ?? description.error ?? new Error('The server did not answer.')}
      />
    );
  }
  const title = existing?.name ?? 'New test model';
  return (
    <Stack gap="lg">
      <title>{`${title} · ${activity.data.name} · SITAF`}</title>
      <div>
        <Text size="sm">
          <RouteLink to="/activities/$activityId" params={{ activityId }}>
            <UserText>{activity.data.name}</UserText>
          </RouteLink>
        </Text>
        <Title order={1} size="h2">
          <UserText>{title}</UserText>
        </Title>
      </div>
      {generate.isError && (
        <ProblemAlert
          title="The test cases were not generated"
          error={generate.error}
          onClose={generate.reset}
        />
      )}
      <ModelEditor
        activity={activity.data}
        description={description.data}
        {...(existing && { existing })}
        generating={generate.isPending}
        onSaved={(model) => {
          if (!existing) {
            void navigate({
              to: '/activities/$activityId/models/$model',
              params: { activityId, model },
              replace: true,
            });
          }
        }}
        onGenerate={(model) => {
          generate.mutate(
            { activityId, model },
            {
              onSuccess: ({ id }) =>
                void navigate({ to: '/suites/$suiteId', params: { suiteId: id } }),
            },
          );
        }}
      />
    </Stack>
  );
}
