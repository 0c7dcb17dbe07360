import { Checkbox, NativeSelect, Stack, Text } from '@mantine/core';
import { Section, UserText } from '@/shared/ui';
import { argumentsOf, isPartOfFault, type Candidate, type Description } from '../defaults';
import { INPUT_KINDS, type InputDraft, type SequenceDraft } from '../document';
import { methodOf, methodsOf, surroundingsOf } from './defaults';

const ADD = 'Add a parameter of the world, a fault or an answer of a stub';

interface CallInputsProps {
  description: Description;
  interfaceName: string;
  sequence: SequenceDraft;
  onChange: (sequence: SequenceDraft) => void;
}

/** The inputs to vary of each call of a sequence: its arguments, and what the call finds around it. */
export function CallInputs({ description, interfaceName, sequence, onChange }: CallInputsProps) {
  const { calls } = sequence;
  const methods = methodsOf(description, interfaceName);
  const around = calls.map((call) => surroundingsOf(description, call));
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
    const inputs = call.inputs.filter(
      ({ name }) => name !== input.name && (selected || !isPartOfFault(name, input.name)),
    );
    if (selected) inputs.push(input);
    const names = (offered[index] ?? []).map(({ name }) => name);
    function place({ kind, name }: InputDraft) {
      // The order of the paper's tables, then that of the method.
      const known = names.indexOf(name);
      return INPUT_KINDS.indexOf(kind) * 1000 + (known < 0 ? names.length : known);
    }
    inputs.sort((a, b) => place(a) - place(b));
    onChange({ ...sequence, calls: calls.with(index, { ...call, inputs }) });
  }
  return (
    <Section title="Inputs of the calls">
      {offered.every((inputs, index) => inputs.length + (around[index]?.length ?? 0) === 0) && (
        <Text c="dimmed">The calls have no inputs.</Text>
      )}
      {around.some((further) => further.length > 0) && (
        <Text size="sm" c="dimmed">
          Parameters of the world, faults and answers of stubs are set when the call begins, and
          kept until another step sets them.
        </Text>
      )}
      {calls.map((call, index) => {
        const inputs = offered[index] ?? [];
        const further = around[index] ?? [];
        return (
          inputs.length + further.length > 0 && (
            <Stack key={index} gap="xs" role="group" aria-label={`Inputs of ${call.name}`}>
              <Text fw={600}>
                <UserText>{call.name}</UserText>
              </Text>
              {inputs.map((input) => (
                <Checkbox
                  key={input.name}
                  label={<UserText>{input.name}</UserText>}
                  description={<UserText>{`${input.kind}, ${input.realType}`}</UserText>}
                  checked={call.inputs.some(({ name }) => name === input.name)}
                  onChange={(event) => {
                    toggle(index, input, event.currentTarget.checked);
                  }}
                />
              ))}
              {further.length > 0 && (
                <NativeSelect
                  aria-label={`Add to the inputs of ${call.name}`}
                  data={[{ value: '', label: ADD }, ...grouped(further)]}
                  value=""
                  maw="32rem"
                  onChange={(event) => {
                    const name = event.currentTarget.value;
                    const chosen = further.find(({ input }) => input.name === name);
                    if (chosen) toggle(index, chosen.input, true);
                  }}
                />
              )}
            </Stack>
          )
        );
      })}
    </Section>
  );
}

function grouped(candidates: readonly Candidate[]) {
  return [
    { group: 'Simulation (TDSD)', kind: 'TDSD' },
    { group: 'Stub (TDTS)', kind: 'TDTS' },
  ]
    .map(({ group, kind }) => ({
      group,
      items: candidates.filter(({ input }) => input.kind === kind).map(({ input }) => input.name),
    }))
    .filter(({ items }) => items.length > 0);
}
