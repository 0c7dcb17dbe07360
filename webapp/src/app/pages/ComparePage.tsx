import { Stack, Text, Title } from '@mantine/core';
import { getRouteApi } from '@tanstack/react-router';
import { NotFound } from '@/app/NotFound';
import { useBuild } from '@/features/builds';
import { ResultComparison } from '@/features/history';
import { formatInstant } from '@/shared/lib/format';
import { RouteLink, UserText } from '@/shared/ui';

const route = getRouteApi('/builds/$buildId/compare');

/** Compares the results of two builds. */
export function ComparePage() {
  const { buildId } = route.useParams();
  const { with: other } = route.useSearch();
  if (!other) return <NotFound />;
  return (
    <Stack gap="lg">
      <title>Comparison · SITAF</title>
      <Title order={1} size="h2">
        Comparison of two builds
      </Title>
      <Text>
        <BuildName buildId={buildId} /> compared with <BuildName buildId={other} />
      </Text>
      <ResultComparison buildId={buildId} other={other} />
    </Stack>
  );
}

function BuildName({ buildId }: { buildId: string }) {
  const build = useBuild(buildId);
  return (
    <RouteLink to="/builds/$buildId" params={{ buildId }} underline="always">
      {build.data ? (
        <UserText>{`${build.data.model}, ${formatInstant(build.data.created)}`}</UserText>
      ) : (
        buildId
      )}
    </RouteLink>
  );
}
