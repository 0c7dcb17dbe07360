import { Button, Table, Text, TextInput } from '@mantine/core';
import { ScrollTable, Section } from '@/shared/ui';
import { freeName } from '../defaults';
import type { SequenceDraft, StateDraft, StepDraft } from '../document';

/** Types of states; those of the interfaces can be written, too. */
const TYPES = ['boolean', 'int', 'double', 'string'];

interface StateTableProps {
  sequence: SequenceDraft;
  onChange: (sequence: SequenceDraft) => void;
}

/** The variables of the abstract state: what the component should remember. */
export function StateTable({ sequence, onChange }: StateTableProps) {
  const { states } = sequence;
  function change(index: number, changed: StateDraft) {
    onChange(renamed({ ...sequence, states: states.with(index, changed) }, states[index], changed));
  }
  return (
    <Section
      title="States"
      actions={
        <Button
          size="xs"
          variant="default"
          onClick={() => {
            const state = {
              name: freeName(
                'state',
                states.map(({ name }) => name),
                '_',
              ),
              type: 'boolean',
              initial: 'false',
            };
            onChange({ ...sequence, states: [...states, state] });
          }}
        >
          Add a state
        </Button>
      }
    >
      {states.length === 0 ? (
        <Text c="dimmed">
          None. A state is what the component should remember of the calls before, such as whether
          it is enabled. Without states every step is always allowed.
        </Text>
      ) : (
        <ScrollTable label="States" minWidth={440}>
          <Table.Thead>
            <Table.Tr>
              <Table.Th>Name</Table.Th>
              <Table.Th>Type</Table.Th>
              <Table.Th>Initial value</Table.Th>
              <Table.Th aria-label="Remove" />
            </Table.Tr>
          </Table.Thead>
          <Table.Tbody>
            {states.map((state, index) => (
              <Table.Tr key={index}>
                <Table.Td>
                  <TextInput
                    aria-label={`Name of state ${index + 1}`}
                    value={state.name}
                    onChange={(event) => {
                      change(index, { ...state, name: event.currentTarget.value });
                    }}
                  />
                </Table.Td>
                <Table.Td>
                  <TextInput
                    aria-label={`Type of state ${index + 1}`}
                    list="state-types"
                    value={state.type}
                    onChange={(event) => {
                      change(index, { ...state, type: event.currentTarget.value });
                    }}
                  />
                </Table.Td>
                <Table.Td>
                  <TextInput
                    aria-label={`Initial value of state ${index + 1}`}
                    value={state.initial}
                    onChange={(event) => {
                      change(index, { ...state, initial: event.currentTarget.value });
                    }}
                  />
                </Table.Td>
                <Table.Td>
                  <Button
                    size="xs"
                    variant="subtle"
                    aria-label={`Remove state ${state.name}`}
                    onClick={() => {
                      onChange({ ...sequence, states: states.toSpliced(index, 1) });
                    }}
                  >
                    Remove
                  </Button>
                </Table.Td>
              </Table.Tr>
            ))}
          </Table.Tbody>
        </ScrollTable>
      )}
      <datalist id="state-types">
        {TYPES.map((type) => (
          <option key={type} value={type} />
        ))}
      </datalist>
    </Section>
  );
}

/** The updates follow the name of their state. */
function renamed(
  sequence: SequenceDraft,
  before: StateDraft | undefined,
  after: StateDraft,
): SequenceDraft {
  if (!before || before.name === after.name) return sequence;
  const follow = <T extends StepDraft>(step: T): T => ({
    ...step,
    updates: step.updates.map((update) =>
      update.name === before.name ? { ...update, name: after.name } : update,
    ),
  });
  return {
    ...sequence,
    calls: sequence.calls.map(follow),
    events: sequence.events.map(follow),
  };
}
