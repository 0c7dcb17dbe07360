import { Button, Group, NativeSelect, Stack, Table, TextInput } from '@mantine/core';
import type { Diagnostic } from '@/shared/api';
import { Diagnostics, Formula, ScrollTable, Section, type Words } from '@/shared/ui';
import { CallSettings } from './CallSettings';
import { argumentsOf, outputsOf, type Description, type Method } from '../defaults';
import type { CallDraft, EventDraft, SequenceDraft, StepDraft } from '../document';
import classes from './sequence.module.css';
import { callOf, changesOf, eventOf, methodOf, methodsOf, stateWords } from './defaults';
import { Updates } from './Updates';

interface StepTableProps {
  description: Description;
  interfaceName: string;
  sequence: SequenceDraft;
  problems: readonly Diagnostic[];
  onChange: (sequence: SequenceDraft) => void;
}

/** The calls and events of a sequence with their guards and updates. */
export function StepTable(props: StepTableProps) {
  const { description, interfaceName, sequence, problems, onChange } = props;
  const { calls, events, states } = sequence;
  const methods = methodsOf(description, interfaceName);
  const changes = changesOf(description);
  const words = stateWords(sequence);
  const stateNames = states.map(({ name }) => name);
  const [firstMethod] = methods;
  const [firstChange] = changes;
  const problemsOf = (kind: string, { name }: StepDraft) =>
    problems.filter(({ element }) => `${element}/`.startsWith(`${kind} ${name}/`));
  const common = { words, stateNames };
  return (
    <Section
      title="Calls and events"
      actions={
        <Group gap="xs">
          <Button
            size="xs"
            variant="default"
            disabled={!firstMethod}
            onClick={() => {
              const unused = methods.find(
                ({ name }) => !calls.some(({ method }) => method === name),
              );
              const method = unused ?? firstMethod;
              if (!method) return;
              onChange({ ...sequence, calls: [...calls, callOf(method, methods, sequence)] });
            }}
          >
            Add a call
          </Button>
          <Button
            size="xs"
            variant="default"
            disabled={firstChange === undefined}
            title={firstChange === undefined ? 'The activity has no world.' : undefined}
            onClick={() => {
              const event = eventOf(firstChange ?? '', sequence);
              onChange({ ...sequence, events: [...events, event] });
            }}
          >
            Add an event
          </Button>
        </Group>
      }
    >
      <ScrollTable label="Calls and events" minWidth={680} className={classes.steps ?? ''}>
        <Table.Thead>
          <Table.Tr>
            <Table.Th>Step</Table.Th>
            <Table.Th>Allowed if</Table.Th>
            <Table.Th>State afterwards</Table.Th>
            <Table.Th>Outcome where not allowed</Table.Th>
          </Table.Tr>
        </Table.Thead>
        <Table.Tbody>
          {calls.map((call, index) => (
            <CallRow
              key={`call ${index}`}
              {...common}
              call={call}
              methods={methods}
              problems={problemsOf('call', call)}
              onChange={(changed) => {
                onChange({ ...sequence, calls: calls.with(index, changed) });
              }}
              onRemove={() => {
                onChange({ ...sequence, calls: calls.toSpliced(index, 1) });
              }}
            />
          ))}
          {events.map((event, index) => (
            <EventRow
              key={`event ${index}`}
              {...common}
              event={event}
              changes={changes}
              problems={problemsOf('event', event)}
              onChange={(changed) => {
                onChange({ ...sequence, events: events.with(index, changed) });
              }}
              onRemove={() => {
                onChange({ ...sequence, events: events.toSpliced(index, 1) });
              }}
            />
          ))}
        </Table.Tbody>
      </ScrollTable>
    </Section>
  );
}

interface RowProps {
  words: Words;
  stateNames: readonly string[];
  problems: readonly Diagnostic[];
  onRemove: () => void;
}

interface CallRowProps extends RowProps {
  call: CallDraft;
  methods: readonly Method[];
  onChange: (call: CallDraft) => void;
}

function CallRow({ call, methods, words, stateNames, problems, onChange, onRemove }: CallRowProps) {
  const chosen = methodOf(methods, call);
  const inputs = call.inputs.map(({ name, realType }) => ({
    label: name,
    detail: `input ${realType}`,
  }));
  return (
    <Table.Tr>
      <Table.Td>
        <Stack gap={6}>
          <NameField
            step={call}
            onChange={(name) => {
              onChange({ ...call, name });
            }}
          />
          <NativeSelect
            size="xs"
            aria-label={`Method of ${call.name}`}
            value={chosen ? keyOf(chosen) : call.method}
            data={[
              ...(chosen ? [] : [{ value: call.method, label: `${call.method} (unknown)` }]),
              ...methods.map((method) => ({ value: keyOf(method), label: labelOf(method) })),
            ]}
            onChange={(event) => {
              const method = methods.find((known) => keyOf(known) === event.currentTarget.value);
              if (method) onChange(withMethod(call, method, methods));
            }}
          />
          <CallSettings call={call} onChange={onChange} onRemove={onRemove} />
          {problems.length > 0 && <Diagnostics items={[...problems]} />}
        </Stack>
      </Table.Td>
      <Table.Td>
        <Formula
          label={`Guard of ${call.name}`}
          labelled={false}
          text={call.guard}
          words={words}
          onChange={(guard) => {
            onChange({ ...call, guard });
          }}
        />
      </Table.Td>
      <Table.Td>
        <Updates
          step={call}
          states={stateNames}
          words={[...words, ...inputs]}
          onChange={(updates) => {
            onChange({ ...call, updates });
          }}
        />
      </Table.Td>
      <Table.Td>
        <Formula
          label={`Outcome of ${call.name} where it is forbidden`}
          labelled={false}
          text={call.forbidden}
          words={[{ label: '!error', detail: 'any exception' }, ...words, ...inputs]}
          onChange={(forbidden) => {
            onChange({ ...call, forbidden });
          }}
        />
      </Table.Td>
    </Table.Tr>
  );
}

interface EventRowProps extends RowProps {
  event: EventDraft;
  changes: readonly string[];
  onChange: (event: EventDraft) => void;
}

function EventRow(props: EventRowProps) {
  const { event, changes, words, stateNames, problems, onChange, onRemove } = props;
  return (
    <Table.Tr>
      <Table.Td>
        <Stack gap={6}>
          <NameField
            step={event}
            onChange={(name) => {
              onChange({ ...event, name });
            }}
          />
          <Group gap={6} wrap="nowrap">
            <NativeSelect
              size="xs"
              aria-label={`What ${event.name} sets`}
              data={[...new Set([event.set, ...changes])]}
              value={event.set}
              onChange={({ currentTarget }) => {
                onChange({ ...event, set: currentTarget.value });
              }}
            />
            <TextInput
              size="xs"
              w={70}
              aria-label={`New value of ${event.name}`}
              value={event.to}
              onChange={({ currentTarget }) => {
                onChange({ ...event, to: currentTarget.value });
              }}
            />
          </Group>
          <div>
            <Button
              size="compact-xs"
              variant="subtle"
              aria-label={`Remove event ${event.name}`}
              onClick={onRemove}
            >
              Remove
            </Button>
          </div>
          {problems.length > 0 && <Diagnostics items={[...problems]} />}
        </Stack>
      </Table.Td>
      <Table.Td>
        <Formula
          label={`Guard of ${event.name}`}
          labelled={false}
          text={event.guard}
          words={words}
          onChange={(guard) => {
            onChange({ ...event, guard });
          }}
        />
      </Table.Td>
      <Table.Td>
        <Updates
          step={event}
          states={stateNames}
          words={words}
          onChange={(updates) => {
            onChange({ ...event, updates });
          }}
        />
      </Table.Td>
      <Table.Td>An event is not made where it is not allowed.</Table.Td>
    </Table.Tr>
  );
}

function NameField({ step, onChange }: { step: StepDraft; onChange: (name: string) => void }) {
  return (
    <TextInput
      size="xs"
      aria-label={`Name of step ${step.name}`}
      value={step.name}
      onChange={(event) => {
        onChange(event.currentTarget.value);
      }}
    />
  );
}

function keyOf({ name, signature }: Method): string {
  return `${name}(${signature})`;
}

function labelOf({ name, parameters }: Method): string {
  return `${name}(${parameters.map((parameter) => parameter.name).join(', ')})`;
}

/** Another method brings its own inputs and outputs; inputs of the same name and type stay. */
function withMethod(call: CallDraft, method: Method, methods: readonly Method[]): CallDraft {
  const overloaded = methods.filter(({ name }) => name === method.name).length > 1;
  const inputs = argumentsOf(method).map(
    ({ input }) =>
      call.inputs.find(
        ({ name, realType }) => name === input.name && realType === input.realType,
      ) ?? input,
  );
  return {
    ...call,
    name: call.name === call.method ? method.name : call.name,
    method: method.name,
    signature: overloaded ? method.signature : '',
    inputs,
    outputs: outputsOf(method),
  };
}
