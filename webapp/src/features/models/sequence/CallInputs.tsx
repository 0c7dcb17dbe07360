import { Checkbox, Stack, Text } from '@mantine/core';
import { Section, UserText } from '@/shared/ui';
import { argumentsOf, type Description } from '../defaults';
import type { InputDraft, SequenceDraft } from '../document';
import { methodOf, methodsOf } from './defaults';

interface CallInputsProps {
  description: Description;
  interfaceName: string;
  sequence: SequenceDraft;
  onChange: (sequence: SequenceDraft) => void;
}

/** The inputs to vary of each call of a sequence. */
export function CallInputs({ description, interfaceName, sequence, onChange }: CallInputsProps) {
  const { calls } = sequence;
  const methods = methodsOf(description, interfaceName);
  const offered = calls.map((call) => {
    const method = methodOf(methods, call);
    const candidates = method ? argumentsOf(method).map(({ input }) => input) : [];
    const others = call.inputs.filter(
      ({ name }) => !candidates.some((candidate) => candidate.name === name),
    );
    return [...candidates, ...others];
  });
  function toggle(index: number, input: InputDraft, selected: boolean) {
    const call = calls[index];
    if (!call) return;
    const names = (offered[index] ?? []).map(({ name }) => name);
    const inputs = call.inputs.filter(({ name }) => name !== input.name);
    if (selected) inputs.push(input);
    inputs.sort((a, b) => names.indexOf(a.name) - names.indexOf(b.name));
    onChange({ ...sequence, calls: calls.with(index, { ...call, inputs }) });
  }
  return (
    <Section title="Inputs of the calls (TDI)">
      {offered.every((inputs) => inputs.length === 0) && (
        <Text c="dimmed">The calls have no inputs.</Text>
      )}
      {calls.map((call, index) => {
        const inputs = offered[index] ?? [];
        return (
          inputs.length > 0 && (
            <Stack key={index} gap="xs" role="group" aria-label={`Inputs of ${call.name}`}>
              <Text fw={600}>
                <UserText>{call.name}</UserText>
              </Text>
              {inputs.map((input) => (
                <Checkbox
                  key={input.name}
                  label={<UserText>{input.name}</UserText>}
                  description={<UserText>{input.realType}</UserText>}
                  checked={call.inputs.some(({ name }) => name === input.name)}
                  onChange={(event) => {
                    toggle(index, input, event.currentTarget.checked);
                  }}
                />
              ))}
            </Stack>
          )
        );
      })}
    </Section>
  );
}
