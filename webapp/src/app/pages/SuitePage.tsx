import { Button, Group, Stack, Text, Title } from '@mantine/core';
import { getRouteApi, useNavigate } from '@tanstack/react-router';
import { useState } from 'react';
import { HowToBuild } from '@/app/building';
import { NotFound } from '@/app/NotFound';
import { PageTabs, type PageTab } from '@/app/PageTabs';
import { withoutAbsent, type SuiteSearch, type SuiteTab } from '@/app/search';
import { TestApplicationView } from '@/app/TestApplicationView';
import { useActivity } from '@/features/activities';
import { DEFAULT_OPTIONS, requestOf, useRequestBuild } from '@/features/builds';
import { CaseGrid, CombinationView, SuiteChangesView, useSuite } from '@/features/suites';
import { ApiError, type Suite } from '@/shared/api';
import { ButtonLink, Diagnostics, Loading, ProblemAlert, RouteLink, UserText } from '@/shared/ui';

const route = getRouteApi('/suites/$suiteId');

/** The test cases of a model (Fig. 15), and what executes them. */
export function SuitePage() {
  const { suiteId } = route.useParams();
  const shown = route.useSearch();
  const navigate = route.useNavigate();
  const suite = useSuite(suiteId);
  if (suite.isPending) return <Loading what="the suite" />;
  if (!suite.data) {
    return suite.error instanceof ApiError && suite.error.status === 404 ? (
      <NotFound />
    ) : (
      <ProblemAlert title="The suite could not be read" error={suite.error} />
    );
  }
  const { data } = suite;
  const tabs: PageTab<SuiteTab>[] = [
    { value: 'cases', label: 'Cases', content: () => <CaseGrid suite={data} /> },
    {
      value: 'combinations',
      label: 'Combinations',
      content: () => <CombinationView suite={data} />,
    },
    { value: 'changes', label: 'Changes', content: () => <SuiteChangesView suite={data} /> },
    {
      value: 'application',
      label: 'Test application',
      content: () => (
        <TestApplicationView
          suite={data}
          path={shown.file}
          onPath={(file) => void navigate({ search: { tab: 'application', file } })}
        />
      ),
    },
  ];
  return (
    <Stack gap="lg">
      <title>{`${data.name} · SITAF`}</title>
      <Head suite={data} />
      {data.notes.length > 0 && <Diagnostics items={data.notes} />}
      <PageTabs
        label="Parts of the suite"
        tabs={tabs}
        value={shown.tab ?? 'cases'}
        onTab={(tab) =>
          void navigate({
            search: withoutAbsent<SuiteSearch>({ tab: tab === 'cases' ? undefined : tab }),
            resetScroll: false,
          })
        }
      />
    </Stack>
  );
}

function Head({ suite }: { suite: Suite }) {
  const activity = useActivity(suite.activityId);
  const build = useRequestBuild();
  const navigate = useNavigate();
  const [how, setHow] = useState(DEFAULT_OPTIONS);
  return (
    <Stack gap="sm">
      <Group justify="space-between" align="start">
        <div>
          <Text size="sm">
            <RouteLink to="/activities/$activityId" params={{ activityId: suite.activityId }}>
              <UserText>{activity.data?.name ?? 'Activity'}</UserText>
            </RouteLink>
            {' / '}
            <RouteLink
              to="/activities/$activityId/models/$model"
              params={{ activityId: suite.activityId, model: suite.model }}
            >
              <UserText>{suite.model}</UserText>
            </RouteLink>
          </Text>
          <Title order={1} size="h2">
            <UserText>{suite.name}</UserText>
          </Title>
        </div>
        <Group gap="sm">
          <HowToBuild options={how} onOptions={setHow} />
          <ButtonLink variant="default" to="/schedules/new" search={{ suite: suite.id }}>
            Build later
          </ButtonLink>
          <Button
            loading={build.isPending}
            onClick={() => {
              build.mutate(
                { suiteId: suite.id, ...requestOf(how) },
                {
                  onSuccess: ({ id }) =>
                    void navigate({ to: '/builds/$buildId', params: { buildId: id } }),
                },
              );
            }}
          >
            Build now
          </Button>
        </Group>
      </Group>
      {build.isError && (
        <ProblemAlert title="It was not built" error={build.error} onClose={build.reset} />
      )}
    </Stack>
  );
}
