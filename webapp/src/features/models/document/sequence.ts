import type { CallDraft, EventDraft, SequenceDraft, StepDraft } from './draft';
import { readInput, readOutput, writeInput, writeOutput } from './elements';
import {
  attributes,
  attributesOf,
  child,
  children,
  escape,
  list,
  namedOf,
  quoted,
  textOf,
} from './text';

/** Reads a `sequence_spec`. */
export function readSequence(element: Element): SequenceDraft {
  const { length = '', order = '', repeat = '', threads = '' } = attributesOf(element);
  return {
    length,
    order,
    repeat,
    threads,
    states: children(element, 'state').map((state) => {
      const { name = '', type = '', initial = '' } = attributesOf(state);
      return { name, type, initial };
    }),
    calls: children(element, 'call').map(readCall),
    events: children(element, 'event').map(readEvent),
  };
}

function readStep(element: Element): StepDraft {
  return {
    name: element.getAttribute('name') ?? element.getAttribute('method') ?? '',
    guard: textOf(element, 'guard'),
    updates: children(element, 'update').map((update) => ({
      name: update.getAttribute('state') ?? '',
      text: update.textContent.trim(),
    })),
  };
}

function readCall(element: Element): CallDraft {
  const step = readStep(element);
  const { method = step.name, signature = '', settle = '', ...others } = attributesOf(element);
  return {
    ...step,
    method,
    signature,
    settle,
    runFor: others.run_for ?? '',
    overlap: others.overlap ?? '',
    forbidden: textOf(element, 'forbidden'),
    preConditions: namedOf(child(element, 'pre_condition_spec_list'), 'pre_condition'),
    inputs: children(child(element, 'input_spec_list'), 'test_element').map(readInput),
    outputs: children(child(element, 'output_spec_list'), 'test_element').map(readOutput),
    postConditions: namedOf(child(element, 'post_condition_spec_list'), 'post_condition'),
  };
}

function readEvent(element: Element): EventDraft {
  const { set = '', to = '' } = attributesOf(element);
  return { ...readStep(element), set, to };
}

/** The lines of a `sequence_spec`, its elements in the order of the schema. */
export function writeSequence(sequence: SequenceDraft): string[] {
  const { length, order, repeat, threads } = sequence;
  return [
    `  <sequence_spec${attributes({ length, order, repeat, threads })}>`,
    ...sequence.states.map(
      // An initial string may be empty.
      ({ name, type, initial }) =>
        `    <state${attributes({ name, type })} initial="${quoted(initial)}"/>`,
    ),
    ...sequence.calls.flatMap(writeCall),
    ...sequence.events.flatMap(writeEvent),
    '  </sequence_spec>',
  ];
}

function writeCall(call: CallDraft): string[] {
  const { name, method, signature, settle, runFor, overlap, forbidden } = call;
  const head = attributes({
    name,
    method: method === name ? '' : method,
    signature,
    settle,
    run_for: runFor,
    overlap,
  });
  return element('call', head, [
    ...writeStep(call),
    ...(forbidden.trim() ? [`  <forbidden>${escape(forbidden)}</forbidden>`] : []),
    ...list('pre_condition_spec_list', 'pre_condition', call.preConditions),
    ...group('input_spec_list', call.inputs.flatMap(writeInput)),
    ...group('output_spec_list', call.outputs.flatMap(writeOutput)),
    ...list('post_condition_spec_list', 'post_condition', call.postConditions),
  ]);
}

function writeEvent(event: EventDraft): string[] {
  const { name, set, to } = event;
  return element('event', attributes({ name, set, to }), writeStep(event));
}

function writeStep({ guard, updates }: StepDraft): string[] {
  return [
    ...(guard.trim() ? [`  <guard>${escape(guard)}</guard>`] : []),
    ...updates.map(
      ({ name, text }) => `  <update${attributes({ state: name })}>${escape(text)}</update>`,
    ),
  ];
}

function group(name: string, lines: readonly string[]): string[] {
  return lines.length > 0 ? [`  <${name}>`, ...lines, `  </${name}>`] : [];
}

/** A step; its parts are indented like those of a model. */
function element(tag: string, head: string, parts: readonly string[]): string[] {
  return parts.length === 0
    ? [`    <${tag}${head}/>`]
    : [`    <${tag}${head}>`, ...parts.map((part) => `    ${part}`), `    </${tag}>`];
}
