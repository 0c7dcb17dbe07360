import { Checkbox, Group, NativeSelect, Stack, TextInput } from '@mantine/core';
import type { ModelPreview } from '@/shared/api';
import { Diagnostics } from '@/shared/ui';
import type { Description } from '../defaults';
import type { ModelDraft, SequenceDraft } from '../document';
import { ModelName } from '../ModelName';
import classes from './sequence.module.css';
import { PlannedStates } from './PlannedStates';
import { StateTable } from './StateTable';
import { StepTable } from './StepTable';

interface SequenceStepProps {
  description: Description;
  draft: ModelDraft;
  sequence: SequenceDraft;
  isNew: boolean;
  preview: ModelPreview | undefined;
  onChange: (draft: ModelDraft) => void;
  onInterface: (name: string) => void;
}

/** Step 1 of a model of sequences: its states, calls and events, with the diagram next to them. */
export function SequenceStep(props: SequenceStepProps) {
  const { description, draft, sequence, isNew, preview, onChange, onInterface } = props;
  const problems = preview?.diagnostics ?? [];
  const ofSequence = problems.filter(({ element }) => /^(sequence_spec|state )/.test(element));
  function change(changed: SequenceDraft) {
    onChange({ ...draft, sequence: changed });
  }
  return (
    <Stack gap="lg">
      <ModelName draft={draft} isNew={isNew} onChange={onChange} />
      <Group align="end">
        <NativeSelect
          label="Interface"
          value={draft.target.interface}
          data={[
            ...new Set([draft.target.interface, ...description.provided.map(({ name }) => name)]),
          ].filter((name) => name !== '' || draft.target.interface === '')}
          disabled={!isNew}
          onChange={(event) => {
            onInterface(event.currentTarget.value);
          }}
        />
        <TextInput
          label="Maximum number of steps"
          w={220}
          value={sequence.length}
          onChange={(event) => {
            change({ ...sequence, length: event.currentTarget.value });
          }}
        />
        <NativeSelect
          label="Order of steps"
          value={sequence.order}
          data={ordersOf(sequence.order)}
          onChange={(event) => {
            change({ ...sequence, order: event.currentTarget.value });
          }}
        />
        <TextInput
          label="Threads"
          w={90}
          placeholder="1"
          value={sequence.threads}
          onChange={(event) => {
            change({ ...sequence, threads: event.currentTarget.value });
          }}
        />
        <Checkbox
          label="Each step at most once in a case"
          mb={8}
          checked={sequence.repeat === 'false'}
          onChange={(event) => {
            change({ ...sequence, repeat: event.currentTarget.checked ? 'false' : '' });
          }}
        />
      </Group>
      {ofSequence.length > 0 && <Diagnostics items={ofSequence} />}
      <div className={classes.withDiagram}>
        <Stack gap="lg">
          <StateTable sequence={sequence} onChange={change} />
          <StepTable
            description={description}
            interfaceName={draft.target.interface}
            sequence={sequence}
            problems={problems}
            onChange={change}
          />
        </Stack>
        <PlannedStates diagram={preview?.states} />
      </div>
    </Stack>
  );
}

const ORDERS = [
  { value: '1', label: '1: every step' },
  { value: '2', label: '2: every pair of steps' },
  { value: '3', label: '3: every triple of steps' },
  { value: '4', label: '4' },
];

/** A document may say more. */
function ordersOf(given: string) {
  return ORDERS.some(({ value }) => value === given)
    ? ORDERS
    : [...ORDERS, { value: given, label: given }];
}
