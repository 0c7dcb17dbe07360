import { Group, Stack, Title } from '@mantine/core';
import { getRouteApi, useNavigate } from '@tanstack/react-router';
import type { ReactNode } from 'react';
import { BuildAgain, RunCaseAgain } from '@/app/building';
import { NotFound } from '@/app/NotFound';
import { PageTabs, type PageTab } from '@/app/PageTabs';
import { withoutAbsent, type BuildSearch, type BuildTab } from '@/app/search';
import { CausePanel, FlakyPanel, ScorePanel } from '@/features/analyses';
import {
  BuildLog,
  BuildOverview,
  CaseLog,
  isFinished,
  statusOf,
  useBuild,
} from '@/features/builds';
import {
  CoverageView,
  LiveCases,
  ResultGraphs,
  ResultView,
  useFirstCases,
  type CaseFilter,
} from '@/features/results';
import { ResultHistory } from '@/features/history';
import { CasePreview } from '@/features/replay';
import { StateDiagramView } from '@/features/states';
import { useSuite } from '@/features/suites';
import { ApiError, type Build, type ResultCase } from '@/shared/api';
import { Breadcrumb, Loading, ProblemAlert, RouteLink, TabIcon, UserText } from '@/shared/ui';

const route = getRouteApi('/builds/$buildId');

export function BuildPage() {
  const { buildId } = route.useParams();
  const shown = route.useSearch();
  const navigate = route.useNavigate();
  const build = useBuild(buildId);
  const wantedCases = withoutAbsent<CaseFilter>({
    verdict: shown.verdict,
    parameter: shown.parameter,
    value: shown.value,
  });
  const first = useFirstCases(buildId, wantedCases, build.data?.state === 'DONE').data?.items[0];
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
  const status = statusOf(build.data);
  const show = (search: BuildSearch) => void navigate({ search, resetScroll: false });
  const filter = (wanted: CaseFilter) => {
    show(withoutAbsent<BuildSearch>({ ...wanted }));
  };
  const caseDetails = ({ no }: ResultCase) => (
    <>
      <RouteLink to="/builds/$buildId/cases/$caseNo" params={{ buildId, caseNo: String(no) }}>
        3D replay
      </RouteLink>
      {done && !build.data.parentId && (
        <RouteLink
          to="/activities/$activityId/history/$model"
          params={{ activityId, model }}
          search={{ build: buildId, case: no }}
        >
          History of the case
        </RouteLink>
      )}
      {done && <RunCaseAgain build={build.data} no={no} />}
      <CaseLog buildId={buildId} no={no} />
    </>
  );
  const tabs: PageTab<BuildTab>[] = [
    {
      value: 'table',
      label: 'Table',
      content: () =>
        done ? (
          <ResultView
            buildId={buildId}
            filter={wantedCases}
            onFilter={filter}
            cause={<Causes build={build.data} />}
            caseNo={shown.case}
            onCase={(no) => {
              show(withoutAbsent<BuildSearch>({ ...shown, case: no }));
            }}
            caseDetails={caseDetails}
            replay={(no) => <CasePreview build={build.data} no={no} />}
            momentLink={({ no }, { name, at }) =>
              at !== undefined && (
                <RouteLink
                  to="/builds/$buildId/cases/$caseNo"
                  params={{ buildId, caseNo: String(no) }}
                  search={{ condition: name, at }}
                  aria-label={`Show the violation of ${name}`}
                >
                  Show the moment
                </RouteLink>
              )
            }
          />
        ) : (
          <LiveTable build={build.data} caseDetails={caseDetails} />
        ),
    },
    ...(done && first && first.steps.length > 0
      ? [
          {
            value: 'states' as const,
            label: 'States',
            content: () => (
              <StateDiagramView
                buildId={buildId}
                caseLink={(no) => (
                  <RouteLink to="/builds/$buildId" params={{ buildId }} search={{ case: no }}>
                    Case {no}
                  </RouteLink>
                )}
              />
            ),
          },
        ]
      : []),
    ...(done
      ? [
          {
            value: 'score' as const,
            label: 'Score',
            content: () => <ScorePanel build={build.data} />,
          },
          {
            value: 'flaky' as const,
            label: 'Flaky cases',
            content: () => (
              <FlakyPanel
                build={build.data}
                caseLink={(no) => (
                  <RouteLink to="/builds/$buildId" params={{ buildId }} search={{ case: no }}>
                    {no}
                  </RouteLink>
                )}
              />
            ),
          },
          {
            value: 'graphs' as const,
            label: 'Graphs',
            content: () => <ResultGraphs buildId={buildId} onFilter={filter} />,
          },
          {
            value: 'coverage' as const,
            label: 'Coverage',
            content: () => (
              <CoverageView
                buildId={buildId}
                path={shown.file}
                onPath={(file) => {
                  show({ tab: 'coverage', file });
                }}
              />
            ),
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
  // The log has the reason why a build did not run.
  const wanted = shown.tab ?? (state === 'FAILED' ? 'log' : 'table');
  return (
    <Stack gap="md">
      <title>{`${status.sign} ${model} · ${activityName} · SITAF`}</title>
      <TabIcon tone={status.tone} />
      <Group justify="space-between" align="start">
        <div>
          <Breadcrumb>
            <RouteLink to="/activities">All activities</RouteLink>
            <RouteLink to="/activities/$activityId" params={{ activityId }}>
              <UserText>{activityName}</UserText>
            </RouteLink>
          </Breadcrumb>
          <Title order={1} size="h3">
            <UserText>{model}</UserText>
          </Title>
        </div>
        <Group gap="md">
          {!isFinished(build.data) && (
            <RouteLink to="/builds/$buildId/live" params={{ buildId }} size="sm">
              Live view
            </RouteLink>
          )}
          <RouteLink to="/suites/$suiteId" params={{ suiteId }} size="sm">
            Test cases
          </RouteLink>
          {isFinished(build.data) && <BuildAgain build={build.data} />}
        </Group>
      </Group>
      <BuildOverview build={build.data} />
      <PageTabs
        label="Build"
        tabs={tabs}
        value={tabs.some(({ value }) => value === wanted) ? wanted : 'log'}
        onTab={(tab) => {
          show(
            withoutAbsent<BuildSearch>({
              tab: tab === 'table' && state !== 'FAILED' ? undefined : tab,
            }),
          );
        }}
      />
    </Stack>
  );
}

/** The causes of the failures, drawn over the first cases of the result. */
function Causes({ build }: { build: Build }) {
  const navigate = useNavigate();
  const cases = useFirstCases(build.id, {});
  return (
    <CausePanel
      build={build}
      cases={(cases.data?.items ?? [])
        .filter(({ verdict }) => verdict !== 'DONT')
        .map(({ values, verdict }) => ({ values, failed: verdict !== 'PASS' }))}
      caseLink={(no) => (
        <RouteLink to="/builds/$buildId" params={{ buildId: build.id }} search={{ case: no }}>
          {no}
        </RouteLink>
      )}
      onBuild={(id) => void navigate({ to: '/builds/$buildId', params: { buildId: id } })}
    />
  );
}

interface LiveTableProps {
  build: Build;
  caseDetails: (item: ResultCase) => ReactNode;
}

/** A table that grows while the build runs; its columns come from the suite. */
function LiveTable({ build, caseDetails }: LiveTableProps) {
  const suite = useSuite(build.suiteId);
  if (suite.isPending) return <Loading what="the suite" />;
  if (!suite.data) return <ProblemAlert title="The suite could not be read" error={suite.error} />;
  return (
    <LiveCases
      buildId={build.id}
      parameters={suite.data.parameters}
      running={!isFinished(build)}
      caseDetails={caseDetails}
    />
  );
}
