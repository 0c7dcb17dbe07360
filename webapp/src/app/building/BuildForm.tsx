import { Button, NativeSelect, Group, Stack, Text } from '@mantine/core';
import { useState, type SyntheticEvent } from 'react';
import type { Activity, SuiteOptions } from '@/shared/api';
import { DEFAULT_OPTIONS } from '@/features/builds';
import { ButtonLink, ProblemAlert } from '@/shared/ui';
import { HowToBuild } from './HowToBuild';
import { useStartBuild } from './useStartBuild';

const INVALID_VALUES = [
  { value: '', label: 'as the model says' },
  { value: 'isolate', label: 'at most one in a case (isolate)' },
  { value: 'combine', label: 'combined like all others (combine)' },
] as const;

/** Chooses a test model and how its cases are generated, then builds. */
export function BuildForm({ activity }: { activity: Activity }) {
  const start = useStartBuild();
  const [model, setModel] = useState(activity.models[0]?.name);
  const [invalidValues, setInvalidValues] = useState('');
  const [how, setHow] = useState(DEFAULT_OPTIONS);
  const chosen = activity.models.find(({ name }) => name === model);
  if (!chosen) return <Text c="dimmed">The activity has no test model.</Text>;

  function submit(event: SyntheticEvent) {
    event.preventDefault();
    if (chosen) {
      start.mutate({
        activityId: activity.id,
        model: chosen.name,
        options: optionsOf(invalidValues),
        how,
      });
    }
  }

  return (
    <Stack gap="sm">
      <form onSubmit={submit}>
        <Group align="end" gap="md">
          <NativeSelect
            label="Test model"
            value={chosen.name}
            onChange={(event) => {
              setModel(event.currentTarget.value);
            }}
            data={activity.models.map(({ name }) => name)}
          />
          <NativeSelect
            label="Invalid values"
            value={invalidValues}
            onChange={(event) => {
              setInvalidValues(event.currentTarget.value);
            }}
            data={[...INVALID_VALUES]}
          />
          <HowToBuild options={how} onOptions={setHow} />
          <ButtonLink
            variant="default"
            to="/schedules/new"
            search={{ activity: activity.id, model: chosen.name }}
          >
            Build later
          </ButtonLink>
          <Button type="submit" loading={start.isPending}>
            Build now
          </Button>
        </Group>
      </form>
      {start.isError && (
        <ProblemAlert
          title={`${start.variables.model} was not built`}
          error={start.error}
          onClose={start.reset}
        />
      )}
    </Stack>
  );
}

function optionsOf(invalidValues: string): SuiteOptions {
  return invalidValues === 'isolate' || invalidValues === 'combine' ? { invalidValues } : {};
}
