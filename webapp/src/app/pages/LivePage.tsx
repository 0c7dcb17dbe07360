import { Stack, Text, Title } from '@mantine/core';
import { getRouteApi } from '@tanstack/react-router';
import { NotFound } from '@/app/NotFound';
import { BuildOverview, isFinished, useBuild } from '@/features/builds';
import { LiveReplay } from '@/features/replay';
import { ApiError } from '@/shared/api';
import { Loading, ProblemAlert, RouteLink, UserText } from '@/shared/ui';

const route = getRouteApi('/builds/$buildId/live');

/** Shows the cases of a running build in 3D. */
export function LivePage() {
  const { buildId } = route.useParams();
  const build = useBuild(buildId);
  if (build.isPending) return <Loading what="the build" />;
  if (!build.data) {
    return build.error instanceof ApiError && build.error.status === 404 ? (
      <NotFound />
    ) : (
      <ProblemAlert title="The build could not be read" error={build.error} />
    );
  }
  const { model, activityName } = build.data;
  return (
    <Stack gap="lg">
      <title>{`Live · ${model} · SITAF`}</title>
      <div>
        <Text size="sm">
          <RouteLink to="/builds/$buildId" params={{ buildId }}>
            <UserText>{`${activityName}, ${model}`}</UserText>
          </RouteLink>
        </Text>
        <Title order={1} size="h2">
          Live view
        </Title>
        <Text size="sm" c="dimmed">
          Plays the recording of the case that ended last.
        </Text>
      </div>
      <BuildOverview build={build.data} />
      <LiveReplay
        build={build.data}
        running={!isFinished(build.data)}
        caseLink={(no) => (
          <RouteLink
            to="/builds/$buildId/cases/$caseNo"
            params={{ buildId, caseNo: String(no) }}
            underline="always"
          >
            {no}
          </RouteLink>
        )}
      />
    </Stack>
  );
}
