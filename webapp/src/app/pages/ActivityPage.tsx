import { Group, Stack, Text, Title } from '@mantine/core';
import { getRouteApi } from '@tanstack/react-router';
import { BuildForm } from '@/app/building';
import { NotFound } from '@/app/NotFound';
import { PageTabs, type PageTab } from '@/app/PageTabs';
import {
  fromIndex,
  toIndex,
  withoutAbsent,
  type ActivitySearch,
  type ActivityTab,
} from '@/app/search';
import {
  ActivityFiles,
  ActivityTags,
  FavouriteButton,
  InterfaceTree,
  useActivity,
} from '@/features/activities';
import { BuildList } from '@/features/builds';
import { GitTab } from '@/features/git';
import { ResultHistory } from '@/features/history';
import { useSession } from '@/features/session';
import { SuiteList } from '@/features/suites';
import { ApiError, type Activity } from '@/shared/api';
import { Breadcrumb, Loading, ProblemAlert, RouteLink, Section, UserText } from '@/shared/ui';

const route = getRouteApi('/activities/$activityId');

export function ActivityPage() {
  const { activityId } = route.useParams();
  const shown = route.useSearch();
  const navigate = route.useNavigate();
  const activity = useActivity(activityId);
  const session = useSession();
  if (activity.isPending) return <Loading what="the activity" />;
  if (!activity.data) {
    return activity.error instanceof ApiError && activity.error.status === 404 ? (
      <NotFound />
    ) : (
      <ProblemAlert title="The activity could not be read" error={activity.error} />
    );
  }
  const { data } = activity;
  const mayBuild = session.data != null && session.data.role !== 'VIEWER';
  const show = (search: ActivitySearch) => void navigate({ search, resetScroll: false });
  const tabs: PageTab<ActivityTab>[] = [
    {
      value: 'overview',
      label: 'Tests',
      content: () => (
        <Overview
          activity={data}
          builds={toIndex(shown.builds)}
          onBuilds={(page) => {
            show(withoutAbsent<ActivitySearch>({ builds: fromIndex(page) }));
          }}
        />
      ),
    },
    {
      value: 'interface',
      label: 'Interface',
      content: () => <InterfaceTree activityId={activityId} />,
    },
    {
      value: 'files',
      label: 'Files',
      content: () => (
        <ActivityFiles
          activity={data}
          path={shown.file}
          mayChange={mayBuild}
          onPath={(file) => {
            show(withoutAbsent<ActivitySearch>({ tab: 'files', file }));
          }}
        />
      ),
    },
    {
      value: 'results',
      label: 'Results',
      content: () => <ResultHistory activityId={activityId} />,
    },
    {
      value: 'commits',
      label: 'Git',
      content: () => (
        <GitTab
          activityId={activityId}
          page={toIndex(shown.commits)}
          request={shown.request}
          marked={shown.commit}
          mayBuild={mayBuild}
          onPage={(page) => {
            show(
              withoutAbsent<ActivitySearch>({
                tab: 'commits',
                request: shown.request,
                commits: fromIndex(page),
              }),
            );
          }}
        />
      ),
    },
  ];
  return (
    <Stack gap="lg">
      <title>{`${data.name} · SITAF`}</title>
      <div>
        <Breadcrumb>
          <RouteLink to="/activities">All activities</RouteLink>
        </Breadcrumb>
        <Group gap="xs">
          <Title order={1} size="h3">
            <UserText>{data.name}</UserText>
          </Title>
          <FavouriteButton activity={data} />
        </Group>
        {data.description && (
          <Text>
            <UserText>{data.description}</UserText>
          </Text>
        )}
        <Text size="sm" c="dimmed">
          <UserText>{[data.language, data.componentClass].filter(Boolean).join(' · ')}</UserText>
        </Text>
        <ActivityTags activity={data} mayChange={mayBuild} />
      </div>
      <PageTabs
        label="Activity"
        tabs={tabs}
        value={shown.tab ?? 'overview'}
        onTab={(tab) => {
          show(withoutAbsent<ActivitySearch>({ tab: tab === 'overview' ? undefined : tab }));
        }}
      />
    </Stack>
  );
}

function Overview({
  activity,
  builds,
  onBuilds,
}: {
  activity: Activity;
  builds: number;
  onBuilds: (page: number) => void;
}) {
  return (
    <Stack gap="xl">
      <Section title="Test models">
        <Group gap="md">
          {activity.models.map(({ name }) => (
            <RouteLink
              key={name}
              to="/activities/$activityId/models/$model"
              params={{ activityId: activity.id, model: name }}
              size="sm"
            >
              <UserText>{`Edit ${name}`}</UserText>
            </RouteLink>
          ))}
          <RouteLink
            to="/activities/$activityId/new-model"
            params={{ activityId: activity.id }}
            size="sm"
          >
            New test model
          </RouteLink>
        </Group>
        <BuildForm activity={activity} />
      </Section>
      <Section title="Test cases">
        <SuiteList activityId={activity.id} />
      </Section>
      <Section title="Builds">
        <BuildList filter={{ activityId: activity.id }} page={builds} onPage={onBuilds} />
      </Section>
    </Stack>
  );
}
