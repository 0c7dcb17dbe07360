import { Button, Group, NativeSelect, Stack, Text, Textarea, TextInput } from '@mantine/core';
import { Section } from '@/shared/ui';
import type { TrajectoryDraft } from '../document';

interface TrajectoryConditionsProps {
  conditions: readonly TrajectoryDraft[];
  onChange: (conditions: TrajectoryDraft[]) => void;
}

/** Conditions over time (signal temporal logic). */
export function TrajectoryConditions({ conditions, onChange }: TrajectoryConditionsProps) {
  return (
    <Section title="Conditions over time">
      <Stack gap="sm">
        <Text c="dimmed">
          They are evaluated over the simulation steps of each case, such as always(bumped == 0.0)
          or eventually[0, 2](always(speed &lt; 0.1)).
        </Text>
        {conditions.map((condition, index) => {
          const change = (changed: Partial<TrajectoryDraft>) => {
            onChange(conditions.with(index, { ...condition, ...changed }));
          };
          const which = `condition over time ${(index + 1).toString()}`;
          return (
            <Group key={index} align="end" wrap="wrap">
              <TextInput
                label="Name"
                aria-label={`Name of ${which}`}
                value={condition.name}
                onChange={(event) => {
                  change({ name: event.currentTarget.value });
                }}
              />
              <NativeSelect
                label="From"
                aria-label={`Begin of ${which}`}
                data={[
                  { value: '', label: 'the call' },
                  { value: 'settle', label: 'settling' },
                ]}
                value={condition.from === 'settle' ? 'settle' : ''}
                onChange={(event) => {
                  change({ from: event.currentTarget.value });
                }}
              />
              <Textarea
                label="Formula"
                aria-label={`Formula of ${which}`}
                autosize
                style={{ flexGrow: 1 }}
                value={condition.formula}
                onChange={(event) => {
                  change({ formula: event.currentTarget.value });
                }}
              />
              <Button
                variant="default"
                aria-label={`Remove ${which}`}
                onClick={() => {
                  onChange(conditions.filter((_, other) => other !== index));
                }}
              >
                Remove
              </Button>
            </Group>
          );
        })}
        <Group>
          <Button
            variant="default"
            onClick={() => {
              onChange([...conditions, { name: '', from: '', formula: '' }]);
            }}
          >
            Add a condition over time
          </Button>
        </Group>
      </Stack>
    </Section>
  );
}
