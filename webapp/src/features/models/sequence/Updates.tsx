import { Button, Group, NativeSelect, Stack, Text } from '@mantine/core';
import { Formula, type Words } from '@/shared/ui';
import type { NamedText, StepDraft } from '../document';

interface UpdatesProps {
  step: StepDraft;
  states: readonly string[];
  words: Words;
  onChange: (updates: NamedText[]) => void;
}

/** What a step does to the states; the others keep their values. */
export function Updates({ step, states, words, onChange }: UpdatesProps) {
  const { updates } = step;
  const unchanged = states.find((state) => !updates.some(({ name }) => name === state));
  return (
    <Stack gap={6}>
      {updates.map((update, index) => (
        <Group key={index} gap={6} wrap="nowrap" align="start">
          <NativeSelect
            size="xs"
            w={110}
            aria-label={`State ${index + 1} that ${step.name} changes`}
            data={[...new Set([update.name, ...states])]}
            value={update.name}
            onChange={(event) => {
              onChange(updates.with(index, { ...update, name: event.currentTarget.value }));
            }}
          />
          <div style={{ flex: 1, minWidth: '4rem' }}>
            <Formula
              label={`${update.name} after ${step.name}`}
              labelled={false}
              text={update.text}
              words={words}
              onChange={(text) => {
                onChange(updates.with(index, { ...update, text }));
              }}
            />
          </div>
          <Button
            size="compact-xs"
            variant="subtle"
            aria-label={`Remove the change of ${update.name} by ${step.name}`}
            onClick={() => {
              onChange(updates.toSpliced(index, 1));
            }}
          >
            ×
          </Button>
        </Group>
      ))}
      {updates.length === 0 && (
        <Text size="sm" c="dimmed">
          unchanged
        </Text>
      )}
      {unchanged !== undefined && (
        <div>
          <Button
            size="compact-xs"
            variant="subtle"
            aria-label={`Change a state by ${step.name}`}
            onClick={() => {
              onChange([...updates, { name: unchanged, text: 'true' }]);
            }}
          >
            Change a state
          </Button>
        </div>
      )}
    </Stack>
  );
}
