import { readdirSync, readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { readModel, writeModel } from '@/features/models/document';

const SCHEMA = readFileSync(
  '../schemas/src/main/resources/org/sitaf/schemas/test_model.xsd',
  'utf8',
);

/** A model with every element and every attribute of the schema. */
const COMPLETE = `<?xml version="1.0" encoding="UTF-8"?>
<test_model>
  <name>Move</name>
  <description>Moves &amp; turns</description>
  <target interface="Drive" method="Move" signature="double,int" settle="0.5" run_for="2"/>
  <definition_list>
    <define name="fast">speed &gt; 2.0</define>
  </definition_list>
  <pre_condition_spec_list>
    <pre_condition>speed &lt; 3.0 &amp;&amp; mode != 1</pre_condition>
  </pre_condition_spec_list>
  <input_spec_list>
    <test_element abstract_type="NUMERIC" real_type="double">
      <name>speed</name>
      <type>TDI</type>
      <description>in m/s</description>
      <test_spec type="BVA" offset="0.1" special="true">
        <equiv_class type="NEC_NUMERIC_TWO_BOUNDARY" min="0" max="3" min_inclusive="false" max_inclusive="false"/>
      </test_spec>
      <user_value_list>
        <value>0.25</value>
        <value> NaN</value>
      </user_value_list>
    </test_element>
    <test_element abstract_type="NUMERIC" real_type="int">
      <name>mode</name>
      <type>TDI</type>
      <test_spec type="ECP" offset="2" representatives="3" special="each">
        <equiv_class type="NEC_NUMERIC_SET"><value>1</value><value>2</value></equiv_class>
      </test_spec>
      <test_spec type="RELATED" to="level" offsets="0 1 -10%">
      </test_spec>
    </test_element>
    <test_element abstract_type="NUMERIC" real_type="int">
      <name>level</name>
      <type>TDI</type>
      <test_spec type="ECP">
        <equiv_class type="NEC_NUMERIC_CONSTANT" value="7"/>
      </test_spec>
    </test_element>
    <test_element abstract_type="STRUCT" real_type="Pose">
      <name>pose</name>
      <type>TDI</type>
      <test_spec type="POSE" as="rpy" count="20" min="-2" max="2">
      </test_spec>
      <test_spec type="DIRECTION" count="6" length="2">
      </test_spec>
    </test_element>
    <test_element abstract_type="BOOLEAN" real_type="boolean">
      <name>brake</name>
      <type>TDTS</type>
      <test_spec type="ECP">
        <equiv_class type="NEC_BOOLEAN" value_only="true"/>
      </test_spec>
    </test_element>
    <test_element abstract_type="NUMERIC" real_type="double">
      <name>Distance</name>
      <type>TDSD</type>
      <test_spec type="RANDOM" count="5" min="0" max="9" distribution="normal" mean="4" standard_deviation="2">
      </test_spec>
    </test_element>
    <test_element abstract_type="NUMERIC" real_type="double">
      <name>Friction</name>
      <type>TDSD</type>
      <test_spec type="RANDOM" count="5" distribution="weighted">
        <range min="0" max="1" weight="3"/>
        <range min="1" max="2" weight="0.5"/>
      </test_spec>
    </test_element>
    <test_element abstract_type="STRING" real_type="string">
      <name>label</name>
      <type>TDI</type>
      <test_spec type="RANDOM_STRING">
        <min_length>1</min_length>
        <max_length>8</max_length>
        <alphabet>true</alphabet>
        <number>false</number>
        <special_char>true</special_char>
        <space>false</space>
        <negative_char_list>&lt;" &gt;</negative_char_list>
      </test_spec>
    </test_element>
  </input_spec_list>
  <output_spec_list>
    <test_element abstract_type="NUMERIC" real_type="double">
      <name>return</name>
      <type>RETURN</type>
      <description>the distance</description>
      <expected or_error="Stalled Timeout">valid ? speed * 2.0 : -1.0</expected>
      <tolerance absolute="1e-9" relative="0.01" ulp="4"/>
    </test_element>
    <test_element abstract_type="NUMERIC" real_type="double">
      <name>robot_x</name>
      <type>OBSERVED</type>
      <tolerance ulp="2"/>
    </test_element>
  </output_spec_list>
  <sequence_spec length="6" order="2" repeat="false" threads="1">
    <state name="on" type="boolean" initial="false"/>
    <state name="note" type="string" initial=""/>
    <call name="Go" method="Move" signature="double,int" settle="0.1" run_for="0.2" overlap="false">
      <guard>on &amp;&amp; step &lt; 5</guard>
      <update state="on">false</update>
      <update state="note">"gone"</update>
      <forbidden>!error:Off</forbidden>
      <pre_condition_spec_list>
        <pre_condition>far &gt; 0.0</pre_condition>
      </pre_condition_spec_list>
      <input_spec_list>
        <test_element abstract_type="NUMERIC" real_type="double">
          <name>far</name>
          <type>TDI</type>
          <user_value_list>
            <value> 1</value>
          </user_value_list>
        </test_element>
      </input_spec_list>
      <output_spec_list>
        <test_element abstract_type="NUMERIC" real_type="double">
          <name>return</name>
          <type>RETURN</type>
          <expected>far</expected>
        </test_element>
      </output_spec_list>
      <post_condition_spec_list>
        <post_condition name="moved">actual &gt; 0.0</post_condition>
      </post_condition_spec_list>
    </call>
    <call name="Stop"/>
    <event name="Slips" set="Friction" to="0.1">
      <guard>on</guard>
      <update state="on">false</update>
    </event>
  </sequence_spec>
  <post_condition_spec_list>
    <post_condition name="moves on">actual &gt;= 0.0</post_condition>
  </post_condition_spec_list>
  <trajectory_condition_spec_list>
    <trajectory_condition name="stops" from="settle">eventually[0, 2](always(speed &lt; 0.1 &amp;&amp; t &gt;= 0.0))</trajectory_condition>
  </trajectory_condition_spec_list>
  <relation_list>
    <relation name="faster &amp; further">
      <change name="speed">speed + 1.0</change>
      <change name="mode">mode + level</change>
      <holds>after.value &gt;= before.value</holds>
    </relation>
  </relation_list>
  <invalid_values>combine</invalid_values>
  <order_of_combinations>3</order_of_combinations>
  <strength t="4"><param>speed</param><param>mode</param></strength>
  <max_cases>200</max_cases>
  <timing warm_up="5" repeat="30"/>
  <case_list><case no="1" class="valid"><value>1</value></case></case_list>
</test_model>
`;

/** Elements of the schema that only group others, or whose setting may also be an attribute. */
const SETTINGS_AS_ELEMENTS = [
  'offset',
  'representatives',
  'count',
  'min',
  'max',
  'distribution',
  'mean',
  'standard_deviation',
];

/** Settings of RANDOM_STRING are written as elements. */
const SETTINGS_AS_ATTRIBUTES = [
  'min_length',
  'max_length',
  'alphabet',
  'number',
  'special_char',
  'space',
  'negative_char_list',
];

function parse(xml: string): Element {
  return new DOMParser().parseFromString(xml, 'application/xml').documentElement;
}

/** The names of all elements and attributes, attributes as `element@name`. */
function namesIn(xml: string): { elements: Set<string>; attributes: Set<string> } {
  const elements = [parse(xml), ...parse(xml).querySelectorAll('*')];
  return {
    elements: new Set(elements.map(({ tagName }) => tagName)),
    attributes: new Set(elements.flatMap(({ attributes }) => [...attributes].map((a) => a.name))),
  };
}

test('the complete model has every element and every attribute of the schema', () => {
  const declared = (kind: string) =>
    [...parse(SCHEMA).getElementsByTagName(`xs:${kind}`)].map((e) => e.getAttribute('name') ?? '');
  const { elements, attributes } = namesIn(COMPLETE);
  expect(declared('element').length).toBeGreaterThan(40);
  expect(declared('element').filter((name) => !elements.has(name))).toEqual(SETTINGS_AS_ELEMENTS);
  expect(declared('attribute').filter((name) => !attributes.has(name))).toEqual(
    SETTINGS_AS_ATTRIBUTES,
  );
});

test('every element and every attribute of a model survives the editor', () => {
  expect(writeModel(readModel(COMPLETE))).toBe(COMPLETE);
});

test.each(SETTINGS_AS_ELEMENTS.filter((name) => name !== 'distribution'))(
  'the setting %s may be an element',
  (name) => {
    const spec = (setting: string) =>
      COMPLETE.replace(/<test_spec type="RANDOM" count="5" min[^]*?<\/test_spec>/, setting);
    const read = readModel(
      spec(`<test_spec type="RANDOM"><${name}>5</${name}></test_spec>`),
    ).inputs.find((input) => input.name === 'Distance');
    expect(read?.spec).toMatchObject({ type: 'RANDOM', settings: { [name]: '5' } });
  },
);

test.each(SETTINGS_AS_ATTRIBUTES)('the setting %s may be an attribute', (name) => {
  const xml = COMPLETE.replace(
    '<test_spec type="RANDOM_STRING">',
    `<test_spec type="RANDOM_STRING" ${name}="x">`,
  );
  const read = readModel(xml).inputs.find((input) => input.name === 'label');
  // An attribute has precedence, as in the server's reader.
  expect(read?.spec?.settings[name]).toBe('x');
});

test('a distribution may be an element with ranges', () => {
  const xml = COMPLETE.replace(
    /<test_spec type="RANDOM" count="5" min[^]*?<\/test_spec>/,
    '<test_spec type="RANDOM" count="5"><distribution type="normal" mean="4" standard_deviation="2"><range min="0" max="1" weight="1"/></distribution></test_spec>',
  );
  expect(readModel(xml).inputs.find(({ name }) => name === 'Distance')?.spec).toEqual({
    type: 'RANDOM',
    settings: { count: '5', distribution: 'normal', mean: '4', standard_deviation: '2' },
    classes: [],
    ranges: [{ min: '0', max: '1', weight: '1' }],
  });
});

test('comments stay where they are', () => {
  const xml = COMPLETE.replace('  <input_spec_list>', '  <!-- what varies -->\n  <input_spec_list>')
    .replace('      <name>mode</name>', '      <!-- 0: idle -->\n      <name>mode</name>')
    .replace('  </input_spec_list>', '    <!-- no more inputs -->\n  </input_spec_list>')
    .replace('</test_model>', '  <!-- the end -->\n</test_model>');
  expect(writeModel(readModel(xml))).toBe(xml);
});

test('comments of a sequence stay where they are', () => {
  const xml = COMPLETE.replace(
    '    <state name="on"',
    '    <!-- remembered -->\n    <state name="on"',
  )
    .replace('      <guard>on &amp;', '      <!-- a guess -->\n      <guard>on &amp;')
    .replace('  </sequence_spec>', '    <!-- no more steps -->\n  </sequence_spec>');
  expect(writeModel(readModel(xml))).toBe(xml);
});

test('a call without a name has that of its method', () => {
  const xml = COMPLETE.replace('<call name="Stop"/>', '<call method="Stop"/>');
  expect(writeModel(readModel(xml))).toBe(COMPLETE);
});

test('a comment of a removed element moves to the element around it', () => {
  const xml = COMPLETE.replace(
    '      <name>mode</name>',
    '      <!-- 0: idle -->\n      <name>mode</name>',
  );
  const draft = readModel(xml);
  const written = writeModel({
    ...draft,
    inputs: draft.inputs.filter(({ name }) => name !== 'mode'),
  });
  expect(written).toContain('    <!-- 0: idle -->\n  </input_spec_list>');
});

test('the spellings of the paper are read', () => {
  const xml = COMPLETE.replaceAll('_BOUNDARY', '_BOUDARY').replaceAll('TDSD', 'TDS');
  expect(writeModel(readModel(xml))).toBe(COMPLETE);
});

test('text of other documents is refused', () => {
  expect(() => readModel('<suite/>')).toThrow('not a test model');
  expect(() => readModel('<test_model>')).toThrow('not a test model');
});

/** The models of the examples: files whose root is a test model. */
const EXAMPLES = readdirSync('../examples', { recursive: true, encoding: 'utf8' })
  .filter((path) => path.endsWith('.xml'))
  .map((path) => ({ path, xml: readFileSync(`../examples/${path}`, 'utf8') }))
  .filter(({ xml }) => /<test_model[\s>]/.test(xml));

/** An element without insignificant spaces, comments, the order of attributes and defaults. */
function contentOf(element: Element): unknown {
  const children = [...element.children];
  // Guard, updates and outcome of a step may have any order.
  if (/^(call|event)$/.test(element.tagName)) {
    children.sort((a, b) => a.tagName.localeCompare(b.tagName));
  }
  const inner = children.map(contentOf);
  const own = [...element.attributes].map(({ name, value }) => `${name}=${value}`).sort();
  return [element.tagName, own, inner.length > 0 ? inner : element.textContent.trim()];
}

test.each(EXAMPLES)('the model $path of the examples survives the editor', ({ xml }) => {
  const settings = /^(offset|representatives|count|min|max|special)$/;
  const written = parse(writeModel(readModel(xml)));
  const given = parse(xml);
  for (const element of [given, written]) {
    // These may be elements or attributes; the editor writes attributes.
    for (const spec of element.querySelectorAll('test_spec')) {
      for (const child of [...spec.children]) {
        if (!settings.test(child.tagName)) continue;
        spec.setAttribute(child.tagName, child.textContent);
        child.remove();
      }
    }
  }
  const parts = (root: Element) =>
    [...root.children].map(contentOf).filter((part) => !/,,$/.test(String(part)));
  expect(parts(written)).toEqual(expect.arrayContaining(parts(given)));
});
