import { Checkbox, Group, NativeSelect, Stack, Text, TextInput } from '@mantine/core';
import type { ModelPreview } from '@/shared/api';
import { Diagnostics, Loading, Section } from '@/shared/ui';
import { CallOutputs } from './sequence';
import {
  Conditions,
  ExpectedOutput,
  FunctionReference,
  Relations,
  TrajectoryConditions,
} from './expressions';
import type { ModelDraft } from './document';
import { inputWords, outputWords, parametersOf } from './parameters';
import { ParameterTable } from './values';

interface OrderStepProps {
  draft: ModelDraft;
  preview: ModelPreview | undefined;
  counting: boolean;
  onChange: (draft: ModelDraft) => void;
}

const ORDERS = [
  { value: '1', label: '1-way: every value' },
  { value: '2', label: '2-way: every pair' },
  { value: '3', label: '3-way' },
  { value: '4', label: '4-way' },
  { value: '5', label: '5-way' },
  { value: '6', label: '6-way' },
  { value: 'all', label: 'All combinations' },
];

/** Step 4 (Fig. 14(d)): expected values, conditions and the order of combinations. */
export function OrderStep({ draft, preview, counting, onChange }: OrderStepProps) {
  const { sequence } = draft;
  const definitions = draft.definitions.map(({ name, text }) => ({ label: name, detail: text }));
  const words = [...inputWords(draft.inputs), ...definitions];
  const afterwards = sequence
    ? [
        ...words,
        { label: 'steps', detail: 'list of the steps: name, inputs, outputs, error, time' },
      ]
    : [...words, ...outputWords(draft.outputs)];
  const parameters = parametersOf(draft, preview);
  const otherProblems = (preview?.diagnostics ?? []).filter(
    ({ element }) =>
      !parameters.some(({ input }) => element.startsWith(`test_element ${input.name}`)),
  );
  return (
    <Stack gap="lg">
      <Section title="Parameters">
        <ParameterTable parameters={parameters} />
      </Section>
      <FunctionReference />
      <Conditions
        title="Definitions"
        help="A definition names a part of several expressions."
        words={afterwards}
        named
        texts={draft.definitions}
        onChange={(definitions) => {
          onChange({ ...draft, definitions });
        }}
      />
      {sequence ? (
        <CallOutputs
          draft={draft}
          sequence={sequence}
          onChange={(changed) => {
            onChange({ ...draft, sequence: changed });
          }}
        />
      ) : (
        <Section title="Expected values and tolerances">
          <Stack gap="sm">
            {draft.outputs.length === 0 && (
              <Text c="dimmed">
                The method has no output. Post-conditions can check its effects.
              </Text>
            )}
            {draft.outputs.map((output, index) => (
              <ExpectedOutput
                key={output.name}
                output={output}
                words={words}
                onChange={(changed) => {
                  onChange({ ...draft, outputs: draft.outputs.with(index, changed) });
                }}
              />
            ))}
          </Stack>
        </Section>
      )}
      <Conditions
        title="Pre-conditions"
        help={
          sequence
            ? 'Initial values that violate a pre-condition are not used.'
            : 'Cases that violate a pre-condition are not generated.'
        }
        words={words}
        texts={draft.preConditions}
        onChange={(preConditions) => {
          onChange({ ...draft, preConditions });
        }}
      />
      <Conditions
        title="Post-conditions"
        help="Post-conditions are checked after each case."
        words={afterwards}
        named
        texts={draft.postConditions}
        onChange={(postConditions) => {
          onChange({ ...draft, postConditions });
        }}
      />
      <TrajectoryConditions
        conditions={draft.trajectoryConditions}
        onChange={(trajectoryConditions) => {
          onChange({ ...draft, trajectoryConditions });
        }}
      />
      {!sequence && (
        <Relations
          relations={draft.relations}
          inputs={draft.inputs.map(({ name }) => name)}
          outputs={draft.outputs.map(({ name }) => name)}
          words={words}
          onChange={(relations) => {
            onChange({ ...draft, relations });
          }}
        />
      )}
      <Section title="Combination">
        <Group align="end">
          <NativeSelect
            label="Order of combinations"
            data={ORDERS}
            value={draft.order}
            onChange={(event) => {
              onChange({ ...draft, order: event.currentTarget.value });
            }}
          />
          <NativeSelect
            label="Invalid values"
            data={[
              { value: 'isolate', label: 'At most one per case (isolate)' },
              { value: 'combine', label: 'Combined like valid values (combine)' },
            ]}
            value={draft.invalidValues}
            onChange={(event) => {
              onChange({
                ...draft,
                invalidValues: event.currentTarget.value === 'combine' ? 'combine' : 'isolate',
              });
            }}
          />
          {!sequence && (
            <TextInput
              label="Maximum number of cases"
              placeholder="Unlimited"
              w={190}
              value={draft.maxCases}
              onChange={(event) => {
                onChange({ ...draft, maxCases: event.currentTarget.value });
              }}
            />
          )}
        </Group>
        {!sequence && (
          <Group align="end">
            <Checkbox
              label="Repeat the call of each case to measure its time"
              checked={draft.timing !== null}
              mb={8}
              onChange={(event) => {
                const timing = event.currentTarget.checked ? { warmUp: '3', repeat: '20' } : null;
                onChange({ ...draft, timing });
              }}
            />
            {draft.timing && (
              <TimingFields timing={draft.timing} draft={draft} onChange={onChange} />
            )}
          </Group>
        )}
        {otherProblems.length > 0 && <Diagnostics items={otherProblems} />}
        {counting ? (
          <Loading what="the number of cases" />
        ) : (
          <Text role="status" fw={600}>
            {preview?.counts
              ? `${preview.counts.total} cases: ${preview.counts.valid} valid, ${preview.counts.invalid} with an invalid value`
              : 'The number of cases is shown when the model has no problems.'}
          </Text>
        )}
      </Section>
    </Stack>
  );
}

interface TimingFieldsProps {
  timing: NonNullable<ModelDraft['timing']>;
  draft: ModelDraft;
  onChange: (draft: ModelDraft) => void;
}

function TimingFields({ timing, draft, onChange }: TimingFieldsProps) {
  return (
    <>
      <TextInput
        label="Calls to warm up"
        placeholder="3"
        w={140}
        value={timing.warmUp}
        onChange={(event) => {
          onChange({ ...draft, timing: { ...timing, warmUp: event.currentTarget.value } });
        }}
      />
      <TextInput
        label="Measured calls"
        placeholder="20"
        w={140}
        value={timing.repeat}
        onChange={(event) => {
          onChange({ ...draft, timing: { ...timing, repeat: event.currentTarget.value } });
        }}
      />
    </>
  );
}
