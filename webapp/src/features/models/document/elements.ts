import type { ClassDraft, InputDraft, InputKind, OutputDraft, SpecDraft } from './draft';
import { INPUT_KINDS, OUTPUT_KINDS, SCHEMES } from './draft';
import { attributes, attributesOf, child, children, escape, textOf, textsOf } from './text';

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

export function readInput(element: Element): InputDraft {
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

export function readOutput(element: Element): OutputDraft {
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

export function writeInput(input: InputDraft): string[] {
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

export function writeOutput(output: OutputDraft): string[] {
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
