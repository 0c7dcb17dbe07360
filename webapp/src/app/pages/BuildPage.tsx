import { Group, Stack, Text, Title } from '@mantine/core';
import { getRouteApi } from '@tanstack/react-router';
import { NotFound } from '@/app/NotFound';
import { PageTabs, type PageTab } from '@/app/PageTabs';
import { withoutAbsent, type BuildSearch, type BuildTab } from '@/app/search';
import { BuildLog, BuildOverview, isFinished, useBuild } from '@/features/builds';
import { ResultGraphs, ResultHistory, ResultView, type CaseFilter } from '@/features/results';
import { ApiError } from '@/shared/api';
import { Loading, ProblemAlert, RouteLink, UserText } from '@/shared/ui';

const route = getRouteApi('/builds/$buildId');

export function BuildPage() {
  const { buildId } = route.useParams();
  const shown = route.useSearch();
  const navigate = route.useNavigate();
  const build = useBuild(buildId);
  if (build.isPending) return <Loading what="the build" />;
  if (!build.data) {
    return build.error instanceof ApiError && build.error.status === 404 ? (
      <NotFound />
    ) : (
      <ProblemAlert title="The build could not be read" error={build.error} />
    );
  }
  const { activityId, activityName, model, state, suiteId } = build.data;
  const done = state === 'DONE';
  const show = (search: BuildSearch) => void navigate({ search, resetScroll: false });
  const filter = (wanted: CaseFilter) => {
    show(withoutAbsent<BuildSearch>({ ...wanted }));
  };
  const tabs: PageTab<BuildTab>[] = [
    ...(done
      ? [
          {
            value: 'table' as const,
            label: 'Table',
            content: () => (
              <ResultView
                buildId={buildId}
                filter={withoutAbsent<CaseFilter>({
                  verdict: shown.verdict,
                  parameter: shown.parameter,
                  value: shown.value,
                })}
                onFilter={filter}
              />
            ),
          },
          {
            value: 'graphs' as const,
            label: 'Graphs',
            content: () => <ResultGraphs buildId={buildId} onFilter={filter} />,
          },
        ]
      : []),
    {
      value: 'log',
      label: 'Log',
      content: () => <BuildLog buildId={buildId} live={!isFinished(build.data)} />,
    },
    {
      value: 'history',
      label: 'History',
      content: () => <ResultHistory activityId={activityId} model={model} />,
    },
  ];
  const wanted = shown.tab ?? (done ? 'table' : 'log');
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
        <RouteLink to="/suites/$suiteId" params={{ suiteId }} size="sm">
          Test cases
        </RouteLink>
      </Group>
      <BuildOverview build={build.data} />
      <PageTabs
        label="Parts of the build"
        tabs={tabs}
        value={tabs.some(({ value }) => value === wanted) ? wanted : 'log'}
        onTab={(tab) => {
          show(withoutAbsent<BuildSearch>({ tab: tab === 'table' ? undefined : tab }));
        }}
      />
    </Stack>
  );
}
