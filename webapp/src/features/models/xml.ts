import { readComments, withComments } from './comments';
import type {
  ClassDraft,
  InputDraft,
  InputKind,
  ModelDraft,
  NamedText,
  OutputDraft,
  SpecDraft,
} from './draft';
import { INPUT_KINDS, OUTPUT_KINDS, SCHEMES } from './draft';

/** Child elements of a specification that are more than a setting. */
const STRUCTURED = ['equiv_class', 'range', 'distribution'];

/** Settings that are written as child elements; all others are written as attributes. */
const STRING_SETTINGS = [
  'min_length',
  'max_length',
  'alphabet',
  'number',
  'special_char',
  'space',
  'negative_char_list',
];

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
    sequence: sequence ? serialized(sequence) : '',
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

function serialized(element: Element): string {
  return new XMLSerializer().serializeToString(element);
}

function readInput(element: Element): InputDraft {
  const type = textOf(element, 'type');
  const [spec = null, ...furtherSpecs] = children(element, 'test_spec').map(readSpec);
  return {
    name: textOf(element, 'name'),
    kind: INPUT_KINDS.find((kind) => kind === type) ?? kindOfAlias(type),
    abstractType: element.getAttribute('abstract_type') ?? '',
    realType: element.getAttribute('real_type') ?? '',
    description: textOf(element, 'description'),
    spec,
    furtherSpecs,
    userValues: textsOf(child(element, 'user_value_list'), 'value'),
  };
}

/** The paper's Table 2 writes TDS. */
function kindOfAlias(type: string): InputKind {
  return type === 'TDS' ? 'TDSD' : 'TDI';
}

function readSpec(element: Element): SpecDraft {
  const { type, ...settings } = attributesOf(element);
  // As in the server's reader, an attribute has precedence over an element of the same name.
  const distribution = child(element, 'distribution');
  if (distribution) {
    const { type: name = distribution.textContent.trim(), ...own } = attributesOf(distribution);
    Object.assign(settings, { ...own, ...(name && { distribution: name }), ...settings });
  }
  for (const { tagName, textContent } of element.children) {
    if (!STRUCTURED.includes(tagName)) settings[tagName] ??= textContent;
  }
  return {
    type: SCHEMES.find((scheme) => scheme === type) ?? 'BVA',
    settings,
    classes: children(element, 'equiv_class').map(readClass),
    ranges: [...children(element, 'range'), ...children(distribution, 'range')].map((range) => ({
      min: range.getAttribute('min') ?? '',
      max: range.getAttribute('max') ?? '',
      weight: range.getAttribute('weight') ?? '',
    })),
  };
}

function readClass(element: Element): ClassDraft {
  const { type = '', ...attributes } = attributesOf(element);
  return {
    // The paper misspells the names of two classes.
    type: type.replace('_BOUDARY', '_BOUNDARY'),
    attributes,
    values: textsOf(element, 'value'),
  };
}

function readOutput(element: Element): OutputDraft {
  const type = textOf(element, 'type');
  const tolerance = child(element, 'tolerance');
  return {
    name: textOf(element, 'name'),
    kind: OUTPUT_KINDS.find((kind) => kind === type) ?? 'RETURN',
    abstractType: element.getAttribute('abstract_type') ?? '',
    realType: element.getAttribute('real_type') ?? '',
    description: textOf(element, 'description'),
    expected: textOf(element, 'expected'),
    orError: child(element, 'expected')?.getAttribute('or_error') ?? '',
    tolerance: attributesOf(tolerance),
  };
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
    ...(draft.sequence ? [`  ${draft.sequence}`] : []),
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

function writeInput(input: InputDraft): string[] {
  const { spec } = input;
  return [
    `    <test_element${attributes({ abstract_type: input.abstractType, real_type: input.realType })}>`,
    `      <name>${escape(input.name)}</name>`,
    `      <type>${input.kind}</type>`,
    ...(input.description ? [`      <description>${escape(input.description)}</description>`] : []),
    ...(spec ? [spec, ...input.furtherSpecs].flatMap(writeSpec) : []),
    ...(input.userValues.length > 0
      ? [
          '      <user_value_list>',
          ...input.userValues.map((value) => `        <value>${escape(value)}</value>`),
          '      </user_value_list>',
        ]
      : []),
    '    </test_element>',
  ];
}

function writeSpec(spec: SpecDraft): string[] {
  const entries = Object.entries(spec.settings).filter(([, value]) => value !== '');
  const inside = entries.filter(([name]) => STRING_SETTINGS.includes(name));
  const outside = entries.filter(([name]) => !STRING_SETTINGS.includes(name));
  return [
    `      <test_spec${attributes({ type: spec.type, ...Object.fromEntries(outside) })}>`,
    ...spec.classes.map(
      ({ type, attributes: own, values }) =>
        `        <equiv_class${attributes({ type, ...own })}${
          values.length > 0
            ? `>${values.map((value) => `<value>${escape(value)}</value>`).join('')}</equiv_class>`
            : '/>'
        }`,
    ),
    ...spec.ranges.map((range) => `        <range${attributes(range)}/>`),
    ...STRING_SETTINGS.flatMap((name) =>
      inside
        .filter(([setting]) => setting === name)
        .map(([, value]) => `        <${name}>${escape(value)}</${name}>`),
    ),
    '      </test_spec>',
  ];
}

function writeOutput(output: OutputDraft): string[] {
  return [
    `    <test_element${attributes({ abstract_type: output.abstractType, real_type: output.realType })}>`,
    `      <name>${escape(output.name)}</name>`,
    `      <type>${output.kind}</type>`,
    ...(output.description
      ? [`      <description>${escape(output.description)}</description>`]
      : []),
    ...(output.expected
      ? [
          `      <expected${attributes({ or_error: output.orError })}>${escape(output.expected)}</expected>`,
        ]
      : []),
    ...(attributes(output.tolerance) === ''
      ? []
      : [`      <tolerance${attributes(output.tolerance)}/>`]),
    '    </test_element>',
  ];
}

function list(name: string, item: string, texts: readonly NamedText[]): string[] {
  const given = texts.filter(({ text }) => text.trim() !== '');
  if (given.length === 0) return [];
  return [
    `  <${name}>`,
    ...given.map(
      ({ name: own, text }) => `    <${item}${attributes({ name: own })}>${escape(text)}</${item}>`,
    ),
    `  </${name}>`,
  ];
}

function attributes(given: Record<string, string>): string {
  return Object.entries(given)
    .filter(([, value]) => value !== '')
    .map(([name, value]) => ` ${name}="${escape(value)}"`)
    .join('');
}

function escape(text: string): string {
  return text
    .replaceAll('&', '&amp;')
    .replaceAll('<', '&lt;')
    .replaceAll('>', '&gt;')
    .replaceAll('"', '&quot;');
}

function attributesOf(element: Element | undefined): Record<string, string> {
  return Object.fromEntries(
    [...(element?.attributes ?? [])].map(({ name, value }) => [name, value]),
  );
}

function child(parent: Element | null | undefined, name: string): Element | undefined {
  return children(parent, name)[0];
}

function children(parent: Element | null | undefined, name: string): Element[] {
  return [...(parent?.children ?? [])].filter(({ tagName }) => tagName === name);
}

function textOf(parent: Element, name: string): string {
  return child(parent, name)?.textContent.trim() ?? '';
}

function namedOf(parent: Element | undefined, name: string): NamedText[] {
  return children(parent, name).map((element) => ({
    name: element.getAttribute('name') ?? '',
    text: element.textContent,
  }));
}

function textsOf(parent: Element | undefined, name: string): string[] {
  return children(parent, name).map(({ textContent }) => textContent);
}
