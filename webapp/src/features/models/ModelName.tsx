import { Group, TextInput } from '@mantine/core';
import type { ModelDraft } from './document';

interface ModelNameProps {
  draft: ModelDraft;
  /** An existing model keeps its name, because suites and builds refer to it. */
  isNew: boolean;
  onChange: (draft: ModelDraft) => void;
}

/** What is the same for models of one call and of sequences: names and times. */
export function ModelName({ draft, isNew, onChange }: ModelNameProps) {
  const { target } = draft;
  const what = draft.sequence ? 'first step' : 'call';
  const last = draft.sequence ? 'last step' : 'call';
  return (
    <>
      <Group align="start" grow>
        <TextInput
          label="Name of the test model"
          description={
            isNew ? 'Letters, digits, ., _ and -' : 'Suites and builds refer to this name'
          }
          value={draft.name}
          readOnly={!isNew}
          onChange={(event) => {
            onChange({ ...draft, name: event.currentTarget.value });
          }}
        />
        <TextInput
          label="Description"
          description="What the model tests"
          value={draft.description}
          onChange={(event) => {
            onChange({ ...draft, description: event.currentTarget.value });
          }}
        />
      </Group>
      <Group align="start" grow>
        <TextInput
          label={`Settling time before the ${what} (s)`}
          placeholder="0"
          value={target.settle}
          onChange={(event) => {
            onChange({ ...draft, target: { ...target, settle: event.currentTarget.value } });
          }}
        />
        <TextInput
          label={`Run time after the ${last} (s)`}
          placeholder="0"
          value={target.runFor}
          onChange={(event) => {
            onChange({ ...draft, target: { ...target, runFor: event.currentTarget.value } });
          }}
        />
      </Group>
    </>
  );
}
