import { Checkbox, Stack, Text } from '@mantine/core';
import { Section, UserText } from '@/shared/ui';
import {
  argumentsOf,
  stubInputs,
  worldInputs,
  type Candidate,
  type Description,
  type Method,
} from './defaults';
import { INPUT_KINDS, type ModelDraft } from './draft';

interface ParametersStepProps {
  description: Description;
  method: Method | undefined;
  draft: ModelDraft;
  onChange: (draft: ModelDraft) => void;
}

/** Step 2 (Fig. 14(b)): what the test varies. */
export function ParametersStep({ description, method, draft, onChange }: ParametersStepProps) {
  const groups = [
    {
      title: 'Input of the method (TDI)',
      none: 'The method has no input.',
      candidates: method ? argumentsOf(method) : [],
    },
    {
      title: 'Simulation (TDSD)',
      none: 'The world declares nothing that a test may vary.',
      candidates: worldInputs(description),
    },
    {
      title: 'Test stub (TDTS)',
      none: 'The component requires no interface.',
      candidates: stubInputs(description),
    },
  ];
  const offered = groups.flatMap(({ candidates }) => candidates.map(({ input }) => input.name));
  const others = draft.inputs.filter(({ name }) => !offered.includes(name));

  function toggle({ input }: Candidate, wanted: boolean) {
    const without = draft.inputs.filter(({ name }) => name !== input.name);
    const inputs = wanted ? [...without, input] : without;
    // In the order of the paper's tables.
    inputs.sort((a, b) => INPUT_KINDS.indexOf(a.kind) - INPUT_KINDS.indexOf(b.kind));
    onChange({ ...draft, inputs });
  }

  return (
    <Stack gap="lg">
      {groups.map(({ title, none, candidates }) => (
        <Section key={title} title={title}>
          {candidates.length === 0 ? (
            <Text c="dimmed">{none}</Text>
          ) : (
            <Stack gap="xs">
              {candidates.map((candidate) => (
                <Checkbox
                  key={candidate.input.name}
                  label={<UserText>{candidate.input.name}</UserText>}
                  description={<UserText>{candidate.note}</UserText>}
                  checked={draft.inputs.some(({ name }) => name === candidate.input.name)}
                  onChange={(event) => {
                    toggle(candidate, event.currentTarget.checked);
                  }}
                />
              ))}
            </Stack>
          )}
        </Section>
      ))}
      {others.length > 0 && (
        <Section title="Others in the model">
          <Stack gap="xs">
            {others.map((input) => (
              <Checkbox
                key={input.name}
                label={<UserText>{input.name}</UserText>}
                description={`${input.kind}, ${input.realType}`}
                checked
                onChange={() => {
                  toggle({ input, note: '' }, false);
                }}
              />
            ))}
          </Stack>
        </Section>
      )}
    </Stack>
  );
}
