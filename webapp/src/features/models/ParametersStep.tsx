import { Checkbox, Stack, Text } from '@mantine/core';
import { Section, UserText } from '@/shared/ui';
import { CallInputs } from './sequence';
import {
  argumentsOf,
  faultInputs,
  isPartOfFault,
  stubInputs,
  worldInputs,
  type Candidate,
  type Description,
  type Method,
} from './defaults';
import { INPUT_KINDS, type ModelDraft } from './document';

interface ParametersStepProps {
  description: Description;
  method: Method | undefined;
  draft: ModelDraft;
  onChange: (draft: ModelDraft) => void;
}

/** Step 2 (Fig. 14(b)): the parameters to vary. */
export function ParametersStep({ description, method, draft, onChange }: ParametersStepProps) {
  const groups = [
    ...(draft.sequence
      ? []
      : [
          {
            title: 'Method inputs (TDI)',
            none: 'The method has no inputs.',
            candidates: method ? argumentsOf(method) : [],
          },
        ]),
    {
      title: 'Simulation parameters (TDSD)',
      none: 'The world declares no parameters.',
      candidates: worldInputs(description),
    },
    {
      title: 'Faults of devices (TDSD)',
      none: 'The world declares no devices.',
      candidates: faultInputs(
        description,
        draft.inputs.map(({ name }) => name),
      ),
    },
    {
      title: 'Test stub return values (TDTS)',
      none: 'The component requires no interfaces.',
      candidates: stubInputs(description),
    },
  ];
  const offered = groups.flatMap(({ candidates }) => candidates.map(({ input }) => input.name));
  const otherInputs = draft.inputs.filter(({ name }) => !offered.includes(name));

  function toggle({ input }: Candidate, selected: boolean) {
    const without = draft.inputs.filter(
      ({ name }) => name !== input.name && (selected || !isPartOfFault(name, input.name)),
    );
    const inputs = selected ? [...without, input] : without;
    // The order of the paper's tables.
    inputs.sort((a, b) => INPUT_KINDS.indexOf(a.kind) - INPUT_KINDS.indexOf(b.kind));
    onChange({ ...draft, inputs });
  }

  return (
    <Stack gap="lg">
      {draft.sequence && (
        <CallInputs
          description={description}
          interfaceName={draft.target.interface}
          sequence={draft.sequence}
          onChange={(sequence) => {
            onChange({ ...draft, sequence });
          }}
        />
      )}
      {draft.sequence && (
        <Text size="sm" c="dimmed">
          The following parameters have their values from the beginning of a case.
        </Text>
      )}
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
      {otherInputs.length > 0 && (
        <Section title="Other parameters of the model">
          <Stack gap="xs">
            {otherInputs.map((input) => (
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
