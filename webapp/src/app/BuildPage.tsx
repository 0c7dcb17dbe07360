import { Anchor, Group, Stack, Text, Title } from '@mantine/core';
import { BuildOverview, useBuild } from '@/features/builds';
import { ResultView } from '@/features/results';
import { ApiError } from '@/shared/api';
import { Loading, ProblemAlert, RouteLink, UserText } from '@/shared/ui';
import { NotFound } from './NotFound';
import { buildSearch, fromIndex, toIndex, type BuildSearch } from './search';

interface BuildPageProps {
  buildId: string;
  shown: BuildSearch;
  onShow: (search: BuildSearch) => void;
}

export function BuildPage({ buildId, shown, onShow }: BuildPageProps) {
  const build = useBuild(buildId);
  if (build.isPending) return <Loading what="the build" />;
  if (!build.data) {
    return build.error instanceof ApiError && build.error.status === 404 ? (
      <NotFound />
    ) : (
      <ProblemAlert title="The build could not be read" error={build.error} />
    );
  }
  const { activityId, activityName, model, state } = build.data;
  return (
    <Stack gap="lg">
      <title>{`${model} · ${activityName} · SITAF`}</title>
      <Group justify="space-between" align="start">
        <div>
          <Text size="sm">
            <RouteLink to="/activities/$activityId" params={{ activityId }}>
              <UserText>{activityName}</UserText>
            </RouteLink>
          </Text>
          <Title order={1} size="h2">
            <UserText>{model}</UserText>
          </Title>
        </div>
        <Anchor size="sm" href={`/api/v1/builds/${encodeURIComponent(buildId)}/log`}>
          Log
        </Anchor>
      </Group>
      <BuildOverview build={build.data} />
      {state === 'DONE' && (
        <ResultView
          buildId={buildId}
          page={toIndex(shown.page)}
          verdict={shown.verdict}
          onShow={({ page, verdict }) => {
            onShow(buildSearch({ page: fromIndex(page), verdict }));
          }}
        />
      )}
    </Stack>
  );
}
