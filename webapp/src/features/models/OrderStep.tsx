import { Button, Group, NativeSelect, Stack, Table, Text, TextInput } from '@mantine/core';
import type { ModelPreview } from '@/shared/api';
import { Diagnostics, Formula, Loading, ScrollTable, Section, UserText } from '@/shared/ui';
import type { ModelDraft, OutputDraft } from './draft';

interface OrderStepProps {
  draft: ModelDraft;
  preview: ModelPreview | undefined;
  counting: boolean;
  onChange: (draft: ModelDraft) => void;
}

const ORDERS = [
  { value: '1', label: 'each value once' },
  { value: '2', label: '2-way: every pair' },
  { value: '3', label: '3-way' },
  { value: '4', label: '4-way' },
  { value: '5', label: '5-way' },
  { value: '6', label: '6-way' },
  { value: 'all', label: 'all combinations' },
];

/** Step 4 (Fig. 14(d)): the list of parameters, conditions, expected values, order of combinations. */
export function OrderStep({ draft, preview, counting, onChange }: OrderStepProps) {
  const words = [
    ...draft.inputs.map(({ name, kind, realType }) => ({
      label: name,
      detail: `${kind} ${realType}`,
    })),
    { label: 'valid', detail: 'true in a case without an invalid value' },
  ];
  const afterwards = [
    ...words,
    { label: 'actual', detail: 'the return value' },
    ...draft.outputs.map(({ name }) => ({ label: `actual_${name}`, detail: 'output' })),
    { label: 'calls', detail: "calls of the stub: calls['Interface.Method'].size()" },
  ];
  const elsewhere = (preview?.diagnostics ?? []).filter(
    ({ element }) => !draft.inputs.some(({ name }) => element.startsWith(`test_element ${name}`)),
  );
  return (
    <Stack gap="lg">
      <Section title="Parameters">
        <ParameterTable draft={draft} preview={preview} />
      </Section>
      <Section title="Expected">
        <Stack gap="sm">
          {draft.outputs.length === 0 && (
            <Text c="dimmed">The method returns nothing; a post-condition can judge it.</Text>
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
        help="A case that breaks one is never generated."
        words={words}
        texts={draft.preConditions}
        onChange={(preConditions) => {
          onChange({ ...draft, preConditions });
        }}
      />
      <Conditions
        title="Post-conditions"
        help="Judged after each case."
        words={afterwards}
        texts={draft.postConditions}
        onChange={(postConditions) => {
          onChange({ ...draft, postConditions });
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
              { value: 'isolate', label: 'at most one in a case (isolate)' },
              { value: 'combine', label: 'combined like all others (combine)' },
            ]}
            value={draft.invalidValues}
            onChange={(event) => {
              onChange({
                ...draft,
                invalidValues: event.currentTarget.value === 'combine' ? 'combine' : 'isolate',
              });
            }}
          />
        </Group>
        {elsewhere.length > 0 && <Diagnostics items={elsewhere} />}
        {counting ? (
          <Loading what="the exact number of cases" />
        ) : (
          <Text role="status" fw={600}>
            {preview?.counts
              ? `${preview.counts.total} cases: ${preview.counts.valid} valid, ${preview.counts.invalid} with an invalid value`
              : 'The number of cases shows once nothing is wrong.'}
          </Text>
        )}
      </Section>
    </Stack>
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
              <Table.Td>{input.spec?.type ?? '–'}</Table.Td>
              <Table.Td ta="right">{valid}</Table.Td>
              <Table.Td ta="right">{values.length - valid}</Table.Td>
            </Table.Tr>
          );
        })}
      </Table.Tbody>
    </ScrollTable>
  );
}

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
    <Group align="end" wrap="nowrap">
      <div style={{ flex: 1 }}>
        <Formula
          label={`Expected ${output.name}`}
          description="CEL over the parameters; left empty, it is filled in case by case"
          text={output.expected}
          words={words}
          onChange={(expected) => {
            onChange({ ...output, expected });
          }}
        />
      </div>
      <TextInput
        label="Tolerance"
        w={110}
        placeholder="0"
        value={output.absolute}
        onChange={(event) => {
          onChange({ ...output, absolute: event.currentTarget.value });
        }}
      />
      <TextInput
        label="Relative"
        w={110}
        placeholder="0"
        value={output.relative}
        onChange={(event) => {
          onChange({ ...output, relative: event.currentTarget.value });
        }}
      />
    </Group>
  );
}

function Conditions({
  title,
  help,
  words,
  texts,
  onChange,
}: {
  title: string;
  help: string;
  words: Words;
  texts: readonly string[];
  onChange: (texts: string[]) => void;
}) {
  return (
    <Section
      title={title}
      actions={
        <Button
          size="xs"
          variant="default"
          onClick={() => {
            onChange([...texts, '']);
          }}
        >
          Add
        </Button>
      }
    >
      {texts.length === 0 && <Text c="dimmed">None. {help}</Text>}
      {texts.map((text, index) => (
        <Group key={index} align="end" wrap="nowrap">
          <div style={{ flex: 1 }}>
            <Formula
              label={`${title} ${index + 1}`}
              text={text}
              words={words}
              onChange={(changed) => {
                onChange(texts.with(index, changed));
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
