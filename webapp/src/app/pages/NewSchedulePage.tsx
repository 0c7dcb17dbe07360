import { NativeSelect, Stack, Text, Title } from '@mantine/core';
import { getRouteApi } from '@tanstack/react-router';
import { useState } from 'react';
import { BuildOptionsButton } from '@/app/building';
import { withoutAbsent, type NewScheduleSearch } from '@/app/search';
import { useActivityChoice } from '@/features/activities';
import { optionsFrom, requestOf } from '@/features/builds';
import { ScheduleForm } from '@/features/schedules';
import { useSuite } from '@/features/suites';
import { Loading, ProblemAlert, RouteLink, UserText } from '@/shared/ui';

const route = getRouteApi('/schedules/new');

/** Schedules a build, once or repeatedly. */
export function NewSchedulePage() {
  const { suite, activity, model, ...requested } = route.useSearch();
  const navigate = route.useNavigate();
  const [options, setOptions] = useState(() => optionsFrom(requested));
  const subject = suite ? { suiteId: suite } : { activityId: activity ?? '', model: model ?? '' };
  return (
    <Stack gap="lg">
      <title>New schedule · SITAF</title>
      <Title order={1} size="h2">
        New schedule
      </Title>
      <ScheduleForm
        subject={{ ...subject, ...requestOf(options) }}
        ready={suite !== undefined || (activity !== undefined && model !== undefined)}
        onCreated={({ id }) =>
          void navigate({ to: '/schedules/$scheduleId', params: { scheduleId: id } })
        }
      >
        {suite ? (
          <SuiteSubject suiteId={suite} />
        ) : (
          <ModelSubject
            activity={activity}
            model={model}
            onChoice={(choice) =>
              void navigate({
                search: withoutAbsent<NewScheduleSearch>({ ...requested, ...choice }),
                replace: true,
              })
            }
          />
        )}
        <div>
          <BuildOptionsButton options={options} onOptions={setOptions} />
        </div>
      </ScheduleForm>
    </Stack>
  );
}

function SuiteSubject({ suiteId }: { suiteId: string }) {
  const suite = useSuite(suiteId);
  if (suite.isPending) return <Loading what="the suite" />;
  if (!suite.data) return <ProblemAlert title="The suite could not be read" error={suite.error} />;
  return (
    <Text size="sm">
      Builds the test cases{' '}
      <RouteLink to="/suites/$suiteId" params={{ suiteId }} underline="always">
        <UserText>{suite.data.name}</UserText>
      </RouteLink>{' '}
      as they are at that time.
    </Text>
  );
}

interface ModelSubjectProps {
  activity?: string | undefined;
  model?: string | undefined;
  onChoice: (choice: { activity: string | undefined; model: string | undefined }) => void;
}

function ModelSubject({ activity, model, onChoice }: ModelSubjectProps) {
  const activities = useActivityChoice();
  if (activities.isPending) return <Loading what="the activities" />;
  if (!activities.data) {
    return <ProblemAlert title="The activities could not be read" error={activities.error} />;
  }
  const { items } = activities.data;
  const chosen = items.find(({ id }) => id === activity);
  return (
    <>
      <NativeSelect
        label="Activity"
        required
        value={activity ?? ''}
        data={[
          { value: '', label: 'Select an activity' },
          ...items.map(({ id, name }) => ({ value: id, label: name })),
        ]}
        onChange={({ currentTarget: { value } }) => {
          const next = items.find(({ id }) => id === value);
          onChoice({ activity: next?.id, model: next?.models[0]?.name });
        }}
      />
      <NativeSelect
        label="Test model"
        description="Its test cases are generated again for each build"
        required
        disabled={!chosen}
        value={model ?? ''}
        data={chosen?.models.map(({ name }) => name) ?? []}
        onChange={({ currentTarget: { value } }) => {
          onChoice({ activity, model: value });
        }}
      />
    </>
  );
}
