import { NativeSelect, NumberInput, SimpleGrid, Stack, TagsInput, TextInput } from '@mantine/core';
import { RECORDINGS } from '@/shared/lib/recordings';
import type { BuildOptions } from './options';

interface BuildOptionsFieldsProps {
  options: BuildOptions;
  onOptions: (options: BuildOptions) => void;
  /** Labels that agents have, to choose from. */
  knownLabels: readonly string[];
}

/** What the agent must be, how much the build matters, and what is recorded of it. */
export function BuildOptionsFields({ options, onOptions, knownLabels }: BuildOptionsFieldsProps) {
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
          description="higher goes first"
          min={-100}
          max={100}
          {...number('priority')}
        />
        <NumberInput
          label="Shards"
          description="so many agents"
          min={1}
          max={100}
          {...number('shards')}
        />
        <NumberInput
          label="Retries"
          description="if an agent fails"
          placeholder="as ever"
          min={0}
          max={99}
          {...number('retries')}
        />
      </SimpleGrid>
      <TextInput
        label="Release of the toolchain"
        description="such as 17 or 3.11; empty for any"
        value={options.toolchain}
        onChange={({ currentTarget: { value } }) => {
          onOptions({ ...options, toolchain: value });
        }}
      />
      <TagsInput
        label="Labels that the agent must have"
        description="Enter adds one"
        data={[...knownLabels]}
        value={options.labels}
        onChange={(labels) => {
          onOptions({ ...options, labels });
        }}
        clearButtonProps={{ 'aria-label': 'Remove all labels' }}
      />
      <NativeSelect
        label="Recordings to see in 3D"
        description="Each case takes some milliseconds longer, a quick one many times as long, whether its recording is kept or not."
        value={options.recordings}
        data={[...RECORDINGS].map(({ value, label }) => ({
          value,
          label: value === '' ? `by default: ${label}` : label,
        }))}
        onChange={({ currentTarget: { value } }) => {
          onOptions({
            ...options,
            recordings: RECORDINGS.find((known) => known.value === value)?.value ?? '',
          });
        }}
      />
    </Stack>
  );
}
