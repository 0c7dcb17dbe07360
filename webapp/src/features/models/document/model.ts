import { readComments, withComments } from './comments';
import type { ModelDraft } from './draft';
import { readInput, readOutput, writeInput, writeOutput } from './elements';
import { readSequence, writeSequence } from './sequence';
import { attributes, child, children, escape, list, namedOf, serialized, textOf } from './text';

/**
 * Reads the document of a test model.
 *
 * @throws Error if it is not the XML of a test model
 */
export function readModel(xml: string): ModelDraft {
  const root = new DOMParser().parseFromString(xml, 'application/xml').documentElement;
  if (root.tagName !== 'test_model') throw new Error('The document is not a test model.');
  const target = child(root, 'target');
  const sequence = child(root, 'sequence_spec');
  return {
    name: textOf(root, 'name'),
    description: textOf(root, 'description'),
    target: {
      interface: target?.getAttribute('interface') ?? '',
      method: target?.getAttribute('method') ?? (target || sequence ? '' : textOf(root, 'name')),
      signature: target?.getAttribute('signature') ?? '',
      settle: target?.getAttribute('settle') ?? '',
      runFor: target?.getAttribute('run_for') ?? '',
    },
    definitions: namedOf(child(root, 'definition_list'), 'define'),
    preConditions: namedOf(child(root, 'pre_condition_spec_list'), 'pre_condition'),
    inputs: children(child(root, 'input_spec_list'), 'test_element').map(readInput),
    outputs: children(child(root, 'output_spec_list'), 'test_element').map(readOutput),
    postConditions: namedOf(child(root, 'post_condition_spec_list'), 'post_condition'),
    trajectoryConditions: children(
      child(root, 'trajectory_condition_spec_list'),
      'trajectory_condition',
    ).map((condition) => ({
      name: condition.getAttribute('name') ?? '',
      from: condition.getAttribute('from') ?? '',
      formula: condition.textContent.trim(),
    })),
    relations: children(child(root, 'relation_list'), 'relation').map((relation) => ({
      name: relation.getAttribute('name') ?? '',
      changes: namedOf(relation, 'change'),
      holds: textOf(relation, 'holds'),
    })),
    invalidValues: textOf(root, 'invalid_values') === 'combine' ? 'combine' : 'isolate',
    order: textOf(root, 'order_of_combinations'),
    maxCases: textOf(root, 'max_cases'),
    timing: readTiming(child(root, 'timing')),
    sequence: sequence ? readSequence(sequence) : null,
    strengths: children(root, 'strength').map(serialized),
    others: children(root, 'case_list').map(serialized),
    comments: readComments(root),
  };
}

function readTiming(element: Element | undefined): ModelDraft['timing'] {
  return element
    ? {
        warmUp: element.getAttribute('warm_up') ?? '',
        repeat: element.getAttribute('repeat') ?? '',
      }
    : null;
}

/** Writes the document of a test model, its elements in the order of the schema. */
export function writeModel(draft: ModelDraft): string {
  const { target } = draft;
  const lines = [
    '<?xml version="1.0" encoding="UTF-8"?>',
    '<test_model>',
    `  <name>${escape(draft.name)}</name>`,
    ...(draft.description ? [`  <description>${escape(draft.description)}</description>`] : []),
    `  <target${attributes({
      interface: target.interface,
      method: target.method,
      signature: target.signature,
      settle: target.settle,
      run_for: target.runFor,
    })}/>`,
    ...list('definition_list', 'define', draft.definitions),
    ...list('pre_condition_spec_list', 'pre_condition', draft.preConditions),
    '  <input_spec_list>',
    ...draft.inputs.flatMap(writeInput),
    '  </input_spec_list>',
    ...(draft.outputs.length > 0
      ? ['  <output_spec_list>', ...draft.outputs.flatMap(writeOutput), '  </output_spec_list>']
      : []),
    ...(draft.sequence ? writeSequence(draft.sequence) : []),
    ...list('post_condition_spec_list', 'post_condition', draft.postConditions),
    ...writeTrajectoryConditions(draft),
    ...writeRelations(draft),
    `  <invalid_values>${draft.invalidValues}</invalid_values>`,
    `  <order_of_combinations>${escape(draft.order)}</order_of_combinations>`,
    ...draft.strengths.map((strength) => `  ${strength}`),
    ...(draft.maxCases.trim() ? [`  <max_cases>${escape(draft.maxCases)}</max_cases>`] : []),
    ...(draft.timing
      ? [`  <timing${attributes({ warm_up: draft.timing.warmUp, repeat: draft.timing.repeat })}/>`]
      : []),
    ...draft.others.map((other) => `  ${other}`),
    '</test_model>',
    '',
  ];
  return withComments(lines.join('\n'), draft.comments);
}

function writeTrajectoryConditions({ trajectoryConditions }: ModelDraft): string[] {
  const given = trajectoryConditions.filter(({ formula }) => formula.trim() !== '');
  if (given.length === 0) return [];
  return [
    '  <trajectory_condition_spec_list>',
    ...given.map(
      ({ name, from, formula }) =>
        `    <trajectory_condition${attributes({ name, from })}>${escape(formula)}</trajectory_condition>`,
    ),
    '  </trajectory_condition_spec_list>',
  ];
}

function writeRelations({ relations }: ModelDraft): string[] {
  if (relations.length === 0) return [];
  return [
    '  <relation_list>',
    ...relations.flatMap(({ name, changes, holds }) => [
      `    <relation${attributes({ name })}>`,
      ...changes.map(
        (change) =>
          `      <change${attributes({ name: change.name })}>${escape(change.text)}</change>`,
      ),
      `      <holds>${escape(holds)}</holds>`,
      '    </relation>',
    ]),
    '  </relation_list>',
  ];
}
