import { Button, Group, NativeSelect, Stack, Text, TextInput } from '@mantine/core';
import { Formula, Section, type Words } from '@/shared/ui';
import type { RelationDraft } from '../document';

interface RelationsProps {
  relations: readonly RelationDraft[];
  /** Names of the inputs. */
  inputs: readonly string[];
  /** Names of the outputs. */
  outputs: readonly string[];
  /** Names of the inputs and definitions. */
  words: Words;
  onChange: (relations: RelationDraft[]) => void;
}

/** Relations between two runs of a valid case. */
export function Relations({ relations, inputs, outputs, words, onChange }: RelationsProps) {
  const outputWords = [...words, ...wordsOf('before', outputs), ...wordsOf('after', outputs)];
  return (
    <Section
      title="Relations between two runs"
      actions={
        <Button
          size="xs"
          variant="default"
          aria-label="Add a relation"
          onClick={() => {
            const change = { name: inputs[0] ?? '', text: '' };
            onChange([...relations, { name: '', changes: [change], holds: '' }]);
          }}
        >
          Add
        </Button>
      }
    >
      {relations.length === 0 && (
        <Text c="dimmed">
          None. Each valid case runs a second time with changed inputs; a relation compares the
          outputs of both runs.
        </Text>
      )}
      <Stack gap="lg">
        {relations.map((relation, index) => (
          <Relation
            key={index}
            relation={relation}
            which={`relation ${(index + 1).toString()}`}
            inputs={inputs}
            words={words}
            outputWords={outputWords}
            onChange={(changed) => {
              onChange(relations.with(index, changed));
            }}
            onRemove={() => {
              onChange(relations.toSpliced(index, 1));
            }}
          />
        ))}
      </Stack>
    </Section>
  );
}

interface RelationProps {
  relation: RelationDraft;
  which: string;
  inputs: readonly string[];
  words: Words;
  outputWords: Words;
  onChange: (relation: RelationDraft) => void;
  onRemove: () => void;
}

function Relation({
  relation,
  which,
  inputs,
  words,
  outputWords,
  onChange,
  onRemove,
}: RelationProps) {
  const { changes } = relation;
  return (
    <Stack gap="xs">
      <Group align="end">
        <TextInput
          label="Name"
          aria-label={`Name of ${which}`}
          style={{ flexGrow: 1 }}
          value={relation.name}
          onChange={(event) => {
            onChange({ ...relation, name: event.currentTarget.value });
          }}
        />
        <Button variant="subtle" size="xs" aria-label={`Remove ${which}`} onClick={onRemove}>
          Remove
        </Button>
      </Group>
      {changes.map((change, index) => (
        <Group key={index} align="end" wrap="nowrap">
          <NativeSelect
            label="Input"
            aria-label={`Changed input ${(index + 1).toString()} of ${which}`}
            // A document may name an input that was removed.
            data={[...new Set([...inputs, change.name])]}
            value={change.name}
            onChange={(event) => {
              const { value: name } = event.currentTarget;
              onChange({ ...relation, changes: changes.with(index, { ...change, name }) });
            }}
          />
          <div style={{ flex: 1 }}>
            <Formula
              label={`Change ${(index + 1).toString()} of ${which}`}
              text={change.text}
              words={words}
              onChange={(text) => {
                onChange({ ...relation, changes: changes.with(index, { ...change, text }) });
              }}
            />
          </div>
          {changes.length > 1 && (
            <Button
              variant="subtle"
              size="xs"
              aria-label={`Remove change ${(index + 1).toString()} of ${which}`}
              onClick={() => {
                onChange({ ...relation, changes: changes.toSpliced(index, 1) });
              }}
            >
              Remove
            </Button>
          )}
        </Group>
      ))}
      <Group>
        <Button
          variant="default"
          size="xs"
          aria-label={`Add a change to ${which}`}
          onClick={() => {
            const free = inputs.find((name) => !changes.some((change) => change.name === name));
            onChange({ ...relation, changes: [...changes, { name: free ?? '', text: '' }] });
          }}
        >
          Add a change
        </Button>
      </Group>
      <Formula
        label={`Condition of ${which}`}
        description="Over the inputs of the first run, and the outputs of both runs as before and after"
        text={relation.holds}
        words={outputWords}
        onChange={(holds) => {
          onChange({ ...relation, holds });
        }}
      />
    </Stack>
  );
}

/** The outputs of a run; the return value is `value`. */
function wordsOf(run: 'before' | 'after', outputs: readonly string[]): Words {
  const detail = run === 'before' ? 'of the first run' : 'of the second run';
  return [
    ...outputs.map((name) => ({
      label: `${run}.${name.replace(/^return(?![A-Za-z0-9_])/, 'value')}`,
      detail: `output ${detail}`,
    })),
    { label: `${run}.error`, detail: `the exception ${detail}, or ""` },
  ];
}
