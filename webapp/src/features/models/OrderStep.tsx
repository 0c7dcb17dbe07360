import {
  Checkbox,
  Button,
  Group,
  NativeSelect,
  Stack,
  Table,
  Text,
  TextInput,
} from '@mantine/core';
import type { ModelPreview } from '@/shared/api';
import { Diagnostics, Formula, Loading, ScrollTable, Section, UserText } from '@/shared/ui';
import type { ModelDraft, NamedText, OutputDraft } from './draft';
import { FunctionReference } from './FunctionReference';
import { Relations } from './Relations';
import { TrajectoryConditions } from './TrajectoryConditions';

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
  const words = [
    ...draft.inputs.map(({ name, kind, realType }) => ({
      label: name,
      detail: `${kind} ${realType}`,
    })),
    { label: 'valid', detail: 'true in cases without an invalid value' },
    ...draft.inputs.map(({ name }) => ({
      label: `valid_${name}`,
      detail: 'whether this value is valid',
    })),
    ...draft.definitions.map(({ name, text }) => ({ label: name, detail: text })),
  ];
  const outputWords = [
    ...words,
    { label: 'actual', detail: 'the return value' },
    ...draft.outputs.map(({ name }) => ({ label: `actual_${name}`, detail: 'output' })),
    { label: 'error', detail: 'the name of the exception, or ""' },
    { label: 'calls', detail: "calls of the stub: calls['Interface.Method'].size()" },
  ];
  const otherProblems = (preview?.diagnostics ?? []).filter(
    ({ element }) => !draft.inputs.some(({ name }) => element.startsWith(`test_element ${name}`)),
  );
  return (
    <Stack gap="lg">
      <Section title="Parameters">
        <ParameterTable draft={draft} preview={preview} />
      </Section>
      <FunctionReference />
      <Conditions
        title="Definitions"
        help="A definition names a part of several expressions."
        words={outputWords}
        named
        texts={draft.definitions}
        onChange={(definitions) => {
          onChange({ ...draft, definitions });
        }}
      />
      <Section title="Expected values and tolerances">
        <Stack gap="sm">
          {draft.outputs.length === 0 && (
            <Text c="dimmed">The method has no output. Post-conditions can check its effects.</Text>
          )}
          {draft.outputs.map((output, index) => (
            <Output
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
      <Conditions
        title="Pre-conditions"
        help="Cases that violate a pre-condition are not generated."
        words={words}
        texts={draft.preConditions}
        onChange={(preConditions) => {
          onChange({ ...draft, preConditions });
        }}
      />
      <Conditions
        title="Post-conditions"
        help="Post-conditions are checked after each case."
        words={outputWords}
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
      <Relations
        relations={draft.relations}
        inputs={draft.inputs.map(({ name }) => name)}
        outputs={draft.outputs.map(({ name }) => name)}
        words={words}
        onChange={(relations) => {
          onChange({ ...draft, relations });
        }}
      />
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
          <TextInput
            label="Maximum number of cases"
            placeholder="Unlimited"
            w={190}
            value={draft.maxCases}
            onChange={(event) => {
              onChange({ ...draft, maxCases: event.currentTarget.value });
            }}
          />
        </Group>
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
          {draft.timing && <TimingFields timing={draft.timing} draft={draft} onChange={onChange} />}
        </Group>
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

function ParameterTable({
  draft,
  preview,
}: {
  draft: ModelDraft;
  preview: ModelPreview | undefined;
}) {
  return (
    <ScrollTable label="Parameters" minWidth={480}>
      <Table.Thead>
        <Table.Tr>
          <Table.Th>Parameter</Table.Th>
          <Table.Th>Kind</Table.Th>
          <Table.Th>Type</Table.Th>
          <Table.Th>Scheme</Table.Th>
          <Table.Th ta="right">Valid</Table.Th>
          <Table.Th ta="right">Invalid</Table.Th>
        </Table.Tr>
      </Table.Thead>
      <Table.Tbody>
        {draft.inputs.map((input) => {
          const values = preview?.inputs.find(({ name }) => name === input.name)?.values ?? [];
          const valid = values.filter((value) => value.valid).length;
          return (
            <Table.Tr key={input.name}>
              <Table.Td>
                <UserText>{input.name}</UserText>
              </Table.Td>
              <Table.Td>{input.kind}</Table.Td>
              <Table.Td>
                <UserText>{input.realType}</UserText>
              </Table.Td>
              <Table.Td>
                {[input.spec, ...input.furtherSpecs].map((spec) => spec?.type ?? '–').join(', ')}
              </Table.Td>
              <Table.Td ta="right">{valid}</Table.Td>
              <Table.Td ta="right">{values.length - valid}</Table.Td>
            </Table.Tr>
          );
        })}
      </Table.Tbody>
    </ScrollTable>
  );
}

/** |actual − expected| may be up to the sum of the three. */
const TOLERANCES = [
  { name: 'absolute', label: 'Absolute' },
  { name: 'relative', label: 'Relative' },
  { name: 'ulp', label: 'ULP' },
] as const;

type Words = readonly { label: string; detail: string }[];

function Output({
  output,
  words,
  onChange,
}: {
  output: OutputDraft;
  words: Words;
  onChange: (output: OutputDraft) => void;
}) {
  return (
    <Group align="end">
      <div style={{ flex: '1 1 16rem' }}>
        <Formula
          label={`Expected ${output.name}`}
          description="A CEL expression over the parameters; leave it empty to enter the values case by case"
          text={output.expected}
          words={words}
          onChange={(expected) => {
            onChange({ ...output, expected });
          }}
        />
      </div>
      <TextInput
        label="Or errors"
        aria-label={`Errors that pass as well as the value of ${output.name}`}
        w={150}
        placeholder="none"
        value={output.orError}
        onChange={(event) => {
          onChange({ ...output, orError: event.currentTarget.value });
        }}
      />
      {TOLERANCES.map(({ name, label }) => (
        <TextInput
          key={name}
          label={label}
          aria-label={`${label} tolerance of ${output.name}`}
          w={110}
          placeholder="0"
          value={output.tolerance[name] ?? ''}
          onChange={(event) => {
            const { value } = event.currentTarget;
            onChange({ ...output, tolerance: { ...output.tolerance, [name]: value } });
          }}
        />
      ))}
    </Group>
  );
}

function Conditions({
  title,
  help,
  words,
  named = false,
  texts,
  onChange,
}: {
  title: string;
  help: string;
  words: Words;
  named?: boolean;
  texts: readonly NamedText[];
  onChange: (texts: NamedText[]) => void;
}) {
  return (
    <Section
      title={title}
      actions={
        <Button
          size="xs"
          variant="default"
          onClick={() => {
            onChange([...texts, { name: '', text: '' }]);
          }}
        >
          Add
        </Button>
      }
    >
      {texts.length === 0 && <Text c="dimmed">None. {help}</Text>}
      {texts.map(({ name, text }, index) => (
        <Group key={index} align="end" wrap="nowrap">
          {named && (
            <TextInput
              label="Name"
              aria-label={`Name of ${title} ${index + 1}`}
              w={170}
              value={name}
              onChange={(event) => {
                onChange(texts.with(index, { name: event.currentTarget.value, text }));
              }}
            />
          )}
          <div style={{ flex: 1 }}>
            <Formula
              label={`${title} ${index + 1}`}
              text={text}
              words={words}
              onChange={(changed) => {
                onChange(texts.with(index, { name, text: changed }));
              }}
            />
          </div>
          <Button
            variant="subtle"
            size="xs"
            onClick={() => {
              onChange(texts.toSpliced(index, 1));
            }}
          >
            Remove
          </Button>
        </Group>
      ))}
    </Section>
  );
}
