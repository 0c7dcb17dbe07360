import {
  Checkbox,
  NativeSelect,
  NumberInput,
  SimpleGrid,
  Stack,
  TagsInput,
  TextInput,
} from '@mantine/core';
import { RECORDINGS } from '@/shared/lib/recordings';
import type { BuildOptions } from './options';

interface BuildOptionsFieldsProps {
  options: BuildOptions;
  onOptions: (options: BuildOptions) => void;
  /** Labels of the known agents, offered for completion. */
  knownLabels: readonly string[];
  /** Whether an agent has a ROS 2 that nodes can run with. */
  offersRos: boolean;
}

/** The fields for the agent, the priority and the recordings of a build. */
export function BuildOptionsFields({
  options,
  onOptions,
  knownLabels,
  offersRos,
}: BuildOptionsFieldsProps) {
  const number = (key: 'priority' | 'shards' | 'retries') => ({
    value: options[key],
    onChange: (value: string | number) => {
      onOptions({ ...options, [key]: String(value) });
    },
  });
  return (
    <Stack gap="sm">
      <SimpleGrid cols={{ base: 1, xs: 3 }}>
        <NumberInput
          label="Priority"
          description="higher runs first"
          min={-100}
          max={100}
          {...number('priority')}
        />
        <NumberInput
          label="Shards"
          description="number of agents"
          min={1}
          max={100}
          {...number('shards')}
        />
        <NumberInput
          label="Retries"
          description="if an agent fails"
          placeholder="default"
          min={0}
          max={99}
          {...number('retries')}
        />
      </SimpleGrid>
      <TextInput
        label="Toolchain version"
        description="such as 17 or 3.11; empty for any"
        value={options.toolchain}
        onChange={({ currentTarget: { value } }) => {
          onOptions({ ...options, toolchain: value });
        }}
      />
      <TagsInput
        label="Agent labels"
        description="The agent must have all of them; Enter adds a label"
        data={[...knownLabels]}
        value={options.labels}
        onChange={(labels) => {
          onOptions({ ...options, labels });
        }}
        clearButtonProps={{ 'aria-label': 'Remove all labels' }}
      />
      <NativeSelect
        label="3D recordings"
        description="Recording adds a few milliseconds to each case."
        value={options.recordings}
        data={[...RECORDINGS].map(({ value, label }) => ({
          value,
          label: value === '' ? `Default: ${label}` : label,
        }))}
        onChange={({ currentTarget: { value } }) => {
          onOptions({
            ...options,
            recordings: RECORDINGS.find((known) => known.value === value)?.value ?? '',
          });
        }}
      />
      <Checkbox
        label="Explain failures"
        description="Further cases are executed if a case fails."
        checked={options.explain}
        onChange={({ currentTarget: { checked } }) => {
          onOptions({ ...options, explain: checked });
        }}
      />
      {(offersRos || options.installedRos) && (
        <Checkbox
          label="Installed ROS 2"
          description="A ROS 2 node runs with the ROS 2 of the agent, in real time."
          checked={options.installedRos}
          onChange={({ currentTarget: { checked } }) => {
            onOptions({ ...options, installedRos: checked });
          }}
        />
      )}
    </Stack>
  );
}
