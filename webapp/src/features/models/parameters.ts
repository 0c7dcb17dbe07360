import type { ModelPreview } from '@/shared/api';
import type { Words } from '@/shared/ui';
import type { InputDraft, ModelDraft, OutputDraft } from './document';

/** An input of a model, or of one of its calls. */
export interface Parameter {
  /** The step; empty for an input of the model itself. */
  call: string;
  input: InputDraft;
  /** Undefined while the model has problems. */
  values: ModelPreview['inputs'][number] | undefined;
}

/** The inputs of a model and of its calls, with their values. */
export function parametersOf(draft: ModelDraft, preview: ModelPreview | undefined): Parameter[] {
  const of = (call: string, inputs: readonly InputDraft[], values: ModelPreview['inputs']) =>
    inputs.map((input) => ({
      call,
      input,
      values: values.find(({ name }) => name === input.name),
    }));
  return [
    ...of('', draft.inputs, preview?.inputs ?? []),
    ...(draft.sequence?.calls ?? []).flatMap(({ name, inputs }) =>
      of(name, inputs, preview?.calls.find((known) => known.name === name)?.inputs ?? []),
    ),
  ];
}

/** A draft with another input in the place of a parameter. */
export function withInput(draft: ModelDraft, { call, input }: Parameter, changed: InputDraft) {
  const replaced = (inputs: readonly InputDraft[]) =>
    inputs.map((known) => (known === input ? changed : known));
  if (call === '' || !draft.sequence) return { ...draft, inputs: replaced(draft.inputs) };
  const calls = draft.sequence.calls.map((known) =>
    known.name === call ? { ...known, inputs: replaced(known.inputs) } : known,
  );
  return { ...draft, sequence: { ...draft.sequence, calls } };
}

/** The names that expressions see before a call. */
export function inputWords(inputs: readonly InputDraft[]): Words {
  return [
    ...inputs.map(({ name, kind, realType }) => ({ label: name, detail: `${kind} ${realType}` })),
    { label: 'valid', detail: 'true in cases without an invalid value' },
    ...inputs.map(({ name }) => ({
      label: `valid_${name}`,
      detail: 'whether this value is valid',
    })),
  ];
}

/** The names that expressions see after a call, in addition. */
export function outputWords(outputs: readonly OutputDraft[]): Words {
  return [
    { label: 'actual', detail: 'the return value' },
    ...outputs.map(({ name }) => ({ label: `actual_${name}`, detail: 'output' })),
    { label: 'error', detail: 'the name of the exception, or ""' },
    { label: 'calls', detail: "calls of the stub: calls['Interface.Method'].size()" },
  ];
}
