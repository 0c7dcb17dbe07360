import { List, Text } from '@mantine/core';
import type { Build } from '@/shared/api';
import { Age, Loading, ProblemAlert, RouteLink, UserText } from '@/shared/ui';
import { BuildStatus } from './BuildStatus';
import { useBuilds } from './queries';
import { isFinished, isSuspect } from './state';

/** The number of recent builds that are searched. */
const LOOK_BACK = 200;

/** Test models whose latest finished build of all cases failed or could not run. */
export function FailingActivities() {
  const builds = useBuilds(0, {}, LOOK_BACK);
  if (builds.isPending) return <Loading what="failing activities" />;
  if (!builds.data) {
    return <ProblemAlert title="The builds could not be read" error={builds.error} />;
  }
  if (builds.data.total === 0) return <Text c="dimmed">No builds yet.</Text>;
  const failing = latestOfEach(builds.data.items).filter(isFailing);
  if (failing.length === 0) {
    return <Text c="dimmed">None: the latest build of each test model passed.</Text>;
  }
  return (
    <List listStyleType="none" spacing={4}>
      {failing.map((build) => (
        <List.Item key={build.id}>
          <RouteLink to="/builds/$buildId" params={{ buildId: build.id }} fw={600} size="sm">
            <UserText>{`${build.activityName} / ${build.model}`}</UserText>
          </RouteLink>{' '}
          <BuildStatus build={build} />{' '}
          <Text span size="sm" c="dimmed">
            {build.summary &&
              `${build.summary.fail + build.summary.error} of ${build.summary.total} cases, `}
            <Age at={build.finished ?? build.created} />
          </Text>
        </List.Item>
      ))}
    </List>
  );
}

function latestOfEach(builds: readonly Build[]): Build[] {
  const latest = new Map<string, Build>();
  for (const build of builds) {
    const key = JSON.stringify([build.activityId, build.model]);
    if (build.cases === undefined && isFinished(build) && !latest.has(key)) latest.set(key, build);
  }
  return [...latest.values()];
}

function isFailing(build: Build): boolean {
  const { state, summary } = build;
  return (
    isSuspect(build) || state === 'FAILED' || (summary ? summary.fail + summary.error > 0 : false)
  );
}
