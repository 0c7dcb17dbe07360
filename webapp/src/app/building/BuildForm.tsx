import { Button, NativeSelect, Group, NumberInput, Stack, Text } from '@mantine/core';
import { useState, type SyntheticEvent } from 'react';
import type { Activity, SuiteOptions } from '@/shared/api';
import { DEFAULT_OPTIONS } from '@/features/builds';
import { ProblemAlert } from '@/shared/ui';
import { BuildOptionsButton } from './BuildOptionsButton';
import { useBuildLater } from './useBuildLater';
import { useStartBuild } from './useStartBuild';

const INVALID_VALUES = [
  { value: '', label: 'As in the model' },
  { value: 'isolate', label: 'At most one per case (isolate)' },
  { value: 'combine', label: 'Combined like valid values (combine)' },
] as const;

/** Chooses a test model, the options of its cases and of the build, then builds now or later. */
export function BuildForm({ activity }: { activity: Activity }) {
  const start = useStartBuild();
  const later = useBuildLater();
  const [model, setModel] = useState(activity.models[0]?.name);
  const [invalidValues, setInvalidValues] = useState('');
  const [maxCases, setMaxCases] = useState<number | string>('');
  const [buildOptions, setBuildOptions] = useState(DEFAULT_OPTIONS);
  const chosen = activity.models.find(({ name }) => name === model);
  if (!chosen) return <Text c="dimmed">The activity has no test models.</Text>;

  function submit(event: SyntheticEvent) {
    event.preventDefault();
    if (chosen) {
      start.mutate({
        activityId: activity.id,
        model: chosen.name,
        options: optionsOf(invalidValues, maxCases),
        buildOptions,
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
          <NumberInput
            label="Maximum number of cases"
            placeholder="As in the model"
            w={190}
            min={1}
            allowDecimal={false}
            value={maxCases}
            onChange={setMaxCases}
          />
          <BuildOptionsButton options={buildOptions} onOptions={setBuildOptions} />
          <Button
            variant="default"
            loading={later.isPending}
            onClick={() => {
              later.mutate({
                activityId: activity.id,
                model: chosen.name,
                options: optionsOf(invalidValues, maxCases),
                buildOptions,
              });
            }}
          >
            Build later
          </Button>
          <Button type="submit" loading={start.isPending}>
            Build now
          </Button>
        </Group>
      </form>
      {later.isError && (
        <ProblemAlert
          title={`No test cases were generated from ${later.variables.model}`}
          error={later.error}
          onClose={later.reset}
        />
      )}
      {start.isError && (
        <ProblemAlert
          title={`The build of ${start.variables.model} was not started`}
          error={start.error}
          onClose={start.reset}
        />
      )}
    </Stack>
  );
}

function optionsOf(invalidValues: string, maxCases: number | string): SuiteOptions {
  return {
    ...((invalidValues === 'isolate' || invalidValues === 'combine') && { invalidValues }),
    ...(typeof maxCases === 'number' && { maxCases }),
  };
}
