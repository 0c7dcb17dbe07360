import { Group, TextInput } from '@mantine/core';
import { Formula, type Words } from '@/shared/ui';
import type { OutputDraft } from '../document';

/** |actual − expected| may be up to the sum of the three. */
const TOLERANCES = [
  { name: 'absolute', label: 'Absolute' },
  { name: 'relative', label: 'Relative' },
  { name: 'ulp', label: 'ULP' },
] as const;

/** The expected value of an output, and how far the actual one may differ. */
export function ExpectedOutput({
  output,
  of = '',
  words,
  onChange,
}: {
  output: OutputDraft;
  /** The call of a sequence. */
  of?: string;
  words: Words;
  onChange: (output: OutputDraft) => void;
}) {
  const what = of === '' ? output.name : `${output.name} of ${of}`;
  return (
    <Group align="end">
      <div style={{ flex: '1 1 16rem' }}>
        <Formula
          label={`Expected ${what}`}
          description={
            of === ''
              ? 'A CEL expression over the parameters; leave it empty to enter the values case by case'
              : 'A CEL expression over the inputs of the call and the states before it'
          }
          text={output.expected}
          words={words}
          onChange={(expected) => {
            onChange({ ...output, expected });
          }}
        />
      </div>
      <TextInput
        label="Or errors"
        aria-label={`Errors that pass as well as the value of ${what}`}
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
          aria-label={`${label} tolerance of ${what}`}
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
