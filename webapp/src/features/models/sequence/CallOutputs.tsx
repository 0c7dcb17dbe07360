import { Stack, Text } from '@mantine/core';
import { Section } from '@/shared/ui';
import type { CallDraft, ModelDraft, SequenceDraft } from '../document';
import { Conditions, ExpectedOutput } from '../expressions';
import { inputWords, outputWords } from '../parameters';
import { stateWords } from './defaults';

interface CallOutputsProps {
  draft: ModelDraft;
  sequence: SequenceDraft;
  onChange: (sequence: SequenceDraft) => void;
}

/** The expected values and conditions of each call of a sequence. */
export function CallOutputs({ draft, sequence, onChange }: CallOutputsProps) {
  const { calls } = sequence;
  const definitions = draft.definitions.map(({ name, text }) => ({ label: name, detail: text }));
  const common = [
    ...stateWords(sequence),
    { label: 'step', detail: 'number of the step, from 1' },
    ...definitions,
  ];
  return calls.map((call, index) => {
    const before = [...inputWords(call.inputs), ...common];
    const after = [...before, ...outputWords(call.outputs)];
    const change = (changed: Partial<CallDraft>) => {
      onChange({ ...sequence, calls: calls.with(index, { ...call, ...changed }) });
    };
    return (
      <Section key={index} title={`Call ${call.name}`}>
        <Stack gap="sm">
          {call.outputs.length === 0 && (
            <Text c="dimmed">The call has no output. Post-conditions can check its effects.</Text>
          )}
          {call.outputs.map((output, at) => (
            <ExpectedOutput
              key={output.name}
              output={output}
              of={call.name}
              words={before}
              onChange={(changed) => {
                change({ outputs: call.outputs.with(at, changed) });
              }}
            />
          ))}
          <Conditions
            title={`Pre-conditions of ${call.name}`}
            help="Rows of values that violate a pre-condition are not used."
            words={inputWords(call.inputs)}
            texts={call.preConditions}
            onChange={(preConditions) => {
              change({ preConditions });
            }}
          />
          <Conditions
            title={`Post-conditions of ${call.name}`}
            help="Post-conditions are checked after each of these steps."
            words={after}
            named
            texts={call.postConditions}
            onChange={(postConditions) => {
              change({ postConditions });
            }}
          />
        </Stack>
      </Section>
    );
  });
}
