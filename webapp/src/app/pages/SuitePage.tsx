import { Button, Group, Stack, Text, Title } from '@mantine/core';
import { getRouteApi, useNavigate } from '@tanstack/react-router';
import { useState } from 'react';
import { BuildOptionsButton } from '@/app/building';
import { NotFound } from '@/app/NotFound';
import { PageTabs, type PageTab } from '@/app/PageTabs';
import { withoutAbsent, type SuiteSearch, type SuiteTab } from '@/app/search';
import { TestApplicationView } from '@/app/TestApplicationView';
import { useActivity } from '@/features/activities';
import { DEFAULT_OPTIONS, requestOf, useRequestBuild } from '@/features/builds';
import { readModel, useModelDocument } from '@/features/models';
import { CaseGrid, CombinationView, SuiteChangesView, useSuite } from '@/features/suites';
import { ApiError, type Suite } from '@/shared/api';
import { ButtonLink, Diagnostics, Loading, ProblemAlert, RouteLink, UserText } from '@/shared/ui';

const route = getRouteApi('/suites/$suiteId');

/** The test cases of a model (Fig. 15) and the test application that executes them. */
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
    { value: 'cases', label: 'Cases', content: () => <Cases suite={data} /> },
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
        label="Suite"
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

/** The grid needs the outputs of the model: a case names only the outputs it has a value for. */
function Cases({ suite }: { suite: Suite }) {
  const model = useModelDocument(suite.activityId, suite.model);
  if (model.isPending) return <Loading what="the test model" />;
  if (!model.data) {
    return (
      <Stack gap="sm">
        <ProblemAlert title="The test model could not be read" error={model.error} />
        <CaseGrid suite={suite} outputs={['return']} />
      </Stack>
    );
  }
  const { outputs, sequence } = readModel(model.data.document);
  return (
    <CaseGrid
      suite={suite}
      outputs={outputs.map(({ name }) => name)}
      sequences={sequence !== null}
    />
  );
}

function Head({ suite }: { suite: Suite }) {
  const activity = useActivity(suite.activityId);
  const build = useRequestBuild();
  const navigate = useNavigate();
  const [options, setOptions] = useState(DEFAULT_OPTIONS);
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
          <BuildOptionsButton options={options} onOptions={setOptions} />
          <ButtonLink
            variant="default"
            to="/schedules/new"
            search={{ suite: suite.id, ...requestOf(options) }}
          >
            Build later
          </ButtonLink>
          <Button
            loading={build.isPending}
            onClick={() => {
              build.mutate(
                { suiteId: suite.id, ...requestOf(options) },
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
        <ProblemAlert
          title="The build was not requested"
          error={build.error}
          onClose={build.reset}
        />
      )}
    </Stack>
  );
}
