import { NativeSelect, Stack, Text, Title } from '@mantine/core';
import { getRouteApi } from '@tanstack/react-router';
import { useState } from 'react';
import { HowToBuild } from '@/app/building';
import { withoutAbsent, type NewScheduleSearch } from '@/app/search';
import { useActivityChoice } from '@/features/activities';
import { DEFAULT_OPTIONS, requestOf } from '@/features/builds';
import { ScheduleForm } from '@/features/schedules';
import { useSuite } from '@/features/suites';
import { Loading, ProblemAlert, RouteLink, UserText } from '@/shared/ui';

const route = getRouteApi('/schedules/new');

/** A build at a time to come, or again and again. */
export function NewSchedulePage() {
  const { suite, activity, model } = route.useSearch();
  const navigate = route.useNavigate();
  const [how, setHow] = useState(DEFAULT_OPTIONS);
  const subject = suite ? { suiteId: suite } : { activityId: activity ?? '', model: model ?? '' };
  return (
    <Stack gap="lg">
      <title>New schedule · SITAF</title>
      <Title order={1} size="h2">
        New schedule
      </Title>
      <ScheduleForm
        subject={{ ...subject, ...requestOf(how) }}
        ready={suite !== undefined || (activity !== undefined && model !== undefined)}
        onMade={({ id }) =>
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
              void navigate({ search: withoutAbsent<NewScheduleSearch>(choice), replace: true })
            }
          />
        )}
        <div>
          <HowToBuild options={how} onOptions={setHow} />
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
      The test cases{' '}
      <RouteLink to="/suites/$suiteId" params={{ suiteId }} underline="always">
        <UserText>{suite.data.name}</UserText>
      </RouteLink>{' '}
      as they are at the time.
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
          { value: '', label: 'choose one' },
          ...items.map(({ id, name }) => ({ value: id, label: name })),
        ]}
        onChange={({ currentTarget: { value } }) => {
          const next = items.find(({ id }) => id === value);
          onChoice({ activity: next?.id, model: next?.models[0]?.name });
        }}
      />
      <NativeSelect
        label="Test model"
        description="its test cases are generated anew each time"
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
