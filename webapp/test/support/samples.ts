import type {
  Activity,
  ActivityDescription,
  Agent,
  Build,
  CaseSignals,
  GitBisection,
  GitCommit,
  GitRequest,
  GitSource,
  Result,
  ResultCase,
  ResultParameter,
  Suite,
  SuiteCase,
  Verdict,
} from '@/shared/api';

const CREATED = '2026-03-01T10:00:00Z';

export const PARAMETERS: ResultParameter[] = [
  { name: 'IndexOfSensor', type: 'TDI', realType: 'int' },
  { name: 'NumOfSensor', type: 'TDI', realType: 'int' },
  { name: 'Distance', type: 'TDSD', realType: 'double' },
];

export function activity(id: string, changes: Partial<Activity> = {}): Activity {
  return {
    id,
    name: 'ir-sensor',
    description: 'Infrared range sensor, the evaluation of the paper',
    language: 'java',
    componentClass: 'org.sitaf.examples.ir.InfraredSensor',
    created: CREATED,
    updated: CREATED,
    version: 1,
    files: [
      { path: 'activity.yaml', size: 412, sha256: 'a'.repeat(64) },
      { path: 'GetInfraredData.xml', size: 1873, sha256: 'b'.repeat(64) },
    ],
    models: [
      {
        name: 'GetInfraredData',
        path: 'GetInfraredData.xml',
        interfaceName: 'InfraredSensorService',
        method: 'GetInfraredData',
      },
    ],
    interfaces: [
      { name: 'InfraredSensorService', usage: 'provided', methods: ['GetInfraredData'] },
    ],
    tags: [],
    ...changes,
  };
}

export function suite(id: string, activityId: string, model: string): Suite {
  return {
    id,
    activityId,
    model,
    name: `${model}-2way`,
    seed: 1,
    total: 55,
    valid: 25,
    invalid: 30,
    created: CREATED,
    version: 1,
    undoable: 0,
    parameters: PARAMETERS,
    notes: [],
  };
}

export function suiteCases(count: number): SuiteCase[] {
  return Array.from({ length: count }, (_, index) => ({
    no: index + 1,
    valid: index % 2 === 0,
    values: [String(index % 7), '4', '5.0'],
    expected: { return: '5.0' },
    steps: [],
  }));
}

export function build(id: string, changes: Partial<Build> = {}): Build {
  return {
    id,
    activityId: 'a1',
    activityName: 'ir-sensor',
    suiteId: 's1',
    model: 'GetInfraredData',
    state: 'QUEUED',
    attempt: 1,
    created: CREATED,
    version: 1,
    casesTotal: 55,
    priority: 0,
    requirements: [],
    casesDone: 0,
    recordedCases: 'ALL',
    labels: [],
    retries: 2,
    buildLabels: {},
    suspicions: [],
    kind: 'TEST',
    explain: false,
    ros: 'INCLUDED',
    ...changes,
  };
}

/** A finished build with the verdicts of its cases. */
export function doneBuild(id: string, cases: readonly ResultCase[]): Build {
  const { total, pass, fail, error, dont, unjudged, byError } = result(cases).summary;
  return build(id, {
    state: 'DONE',
    agent: 'bench-1',
    started: CREATED,
    finished: '2026-03-01T10:00:04.200Z',
    casesTotal: total,
    casesDone: total - dont,
    summary: { total, pass, fail, error, dont, unjudged, byError },
  });
}

export function resultCase(no: number, verdict: Verdict, changes: Partial<ResultCase> = {}) {
  const distance = ['9.5', '5.0', '0.5', '0.0', '10.0'][no % 5] ?? '0.0';
  const seen = no % 7 < 4;
  const expected = seen ? distance : '-1.0';
  const sample: ResultCase = {
    no,
    values: [String((no % 7) + 1), String(((no * 3) % 7) + 1), distance],
    expected: { return: expected },
    actual: { return: verdict === 'FAIL' ? '10.0' : expected },
    verdict,
    trajectories: [],
    relations: [],
    steps: [],
    processingTimeUs: 4 + (no % 9) / 4,
    ...changes,
  };
  return sample;
}

export function gitSource(changes: Partial<GitSource> = {}): GitSource {
  return {
    activityId: 'a1',
    url: 'https://git.example.org/robots/sensors.git',
    branch: 'main',
    folder: '',
    credential: 'NONE',
    policy: 'LATEST',
    intervalS: 300,
    version: 1,
    forge: 'GITHUB',
    hasForgeToken: false,
    hasHook: true,
    ...changes,
  };
}

export function gitCommit(sha: string, changes: Partial<GitCommit> = {}): GitCommit {
  return {
    sha,
    request: 0,
    mergeBase: false,
    subject: 'Add the sensor',
    author: 'Tester',
    authored: CREATED,
    received: CREATED,
    state: 'DONE',
    notBuilt: 0,
    replaced: false,
    cells: [],
    ...changes,
  };
}

export function gitBisection(
  number: number,
  bad: string,
  changes: Partial<GitBisection> = {},
): GitBisection {
  return {
    number,
    state: 'RUNNING',
    bad,
    good: 'a'.repeat(40),
    kind: 'FAILURES',
    criterion: 'Fails: GetInfraredData, case 7',
    commits: 15,
    left: 15,
    builds: 0,
    testing: 'd'.repeat(40),
    tested: [],
    firstBad: [],
    askedBy: 'tester',
    created: CREATED,
    ...changes,
  };
}

export function gitRequest(number: number, changes: Partial<GitRequest> = {}): GitRequest {
  return {
    number,
    title: 'Extend the range',
    author: 'contributor',
    head: 'b'.repeat(40),
    fork: false,
    state: 'OPEN',
    waitsForApproval: false,
    received: CREATED,
    updated: CREATED,
    ...changes,
  };
}

/** Signals of a case that ends one second after the call, with two trajectory conditions. */
export function caseSignals(): CaseSignals {
  return {
    samples: 3000,
    times: [-0.5, 0, 0.4, 0.5, 1],
    signals: [
      { name: 'base.linear.command', unit: 'm/s', values: [0, 0, 0.5, 0.5, 0] },
      { name: 'bumped', unit: '', values: [0, 0, 0, 1, 0] },
      { name: 'lidar.range', unit: 'm', values: [3, 2, null, 1, 1] },
    ],
    conditions: [
      { name: 'stops', from: 0, to: 1, signals: ['base.linear.command'] },
      { name: 'never touches', from: 0.25, to: 0.75, signals: ['bumped'] },
    ],
  };
}

/** The results of its conditions: one is violated. */
export const TRAJECTORIES: ResultCase['trajectories'] = [
  { name: 'stops', verdict: 'PASS', margin: '0.0', at: 1 },
  { name: 'never touches', verdict: 'FAIL', margin: '-1.0', at: 0.5 },
];

export function resultCases(verdicts: readonly Verdict[]): ResultCase[] {
  return verdicts.map((verdict, index) => resultCase(index + 1, verdict));
}

function relationCounts(cases: readonly ResultCase[]): Result['relations'] {
  const results = cases.flatMap(({ relations }) => relations);
  return [...new Set(results.map(({ name }) => name))].map((name) => {
    const count = (...verdicts: string[]) =>
      results.filter((each) => each.name === name && verdicts.includes(each.verdict)).length;
    return {
      name,
      checked: count('PASS', 'FAIL'),
      broken: count('FAIL'),
      skipped: count('SKIPPED'),
      errors: count('ERROR'),
    };
  });
}

export function result(cases: readonly ResultCase[]): Result {
  const count = (verdict: Verdict) => cases.filter((item) => item.verdict === verdict).length;
  const times = cases
    .filter((item) => item.verdict === 'PASS' || item.verdict === 'FAIL')
    .map((item) => item.processingTimeUs ?? 0);
  const average = times.reduce((sum, time) => sum + time, 0) / Math.max(1, times.length);
  const squares = times.reduce((sum, time) => sum + (time - average) ** 2, 0);
  return {
    name: 'GetInfraredData',
    summary: {
      total: cases.length,
      pass: count('PASS'),
      fail: count('FAIL'),
      error: count('ERROR'),
      dont: count('DONT'),
      unjudged: 0,
      byError: 0,
      processingTime: {
        unit: 'us',
        min: Math.min(...times),
        max: Math.max(...times),
        average,
        standardDeviation: Math.sqrt(squares / Math.max(1, times.length - 1)),
      },
    },
    parameters: PARAMETERS,
    provenance: {
      suite: 'a'.repeat(64),
      seed: 1,
      harness: 'b'.repeat(64),
      component: 'c'.repeat(64),
      agent: 'bench-1',
      bridge: 'sitaf_bridge',
      compiler: 'Python 3.11.2',
      packages: [{ name: 'numpy', version: '2.4.6', sha256: 'd'.repeat(64) }],
      started: CREATED,
      finished: CREATED,
    },
    suspicions: [],
    relations: relationCounts(cases),
  };
}

export const AGENT: Agent = {
  name: 'bench-1',
  version: '0.1.0',
  state: 'ONLINE',
  slots: 2,
  busy: 0,
  labels: [],
  devices: [],
  simulation: true,
  standing: 'ACTIVE',
  toolchains: [{ language: 'java', version: '17' }],
  lastSeen: CREATED,
};

/** The document of the test model that the suites are generated from. */
export const MODEL = modelOf([{ name: 'return', type: 'RETURN', expected: 'Distance' }]);

/** A test model with these outputs. */
export function modelOf(outputs: { name: string; type: string; expected?: string }[]): string {
  return `<?xml version="1.0" encoding="UTF-8"?>
<test_model>
  <name>GetInfraredData</name>
  <target interface="InfraredSensorService" method="GetInfraredData"/>
  <input_spec_list>
    <test_element abstract_type="NUMERIC" real_type="int">
      <name>IndexOfSensor</name>
      <type>TDI</type>
      <test_spec type="BVA" offset="1">
        <equiv_class type="NEC_NUMERIC_TWO_BOUNDARY" min="1" max="7"/>
      </test_spec>
    </test_element>
    <test_element abstract_type="NUMERIC" real_type="double">
      <name>Distance</name>
      <type>TDSD</type>
      <user_value_list>
        <value>5.0</value>
      </user_value_list>
    </test_element>
  </input_spec_list>
  <output_spec_list>
${outputs.map(outputElement).join('')}  </output_spec_list>
  <invalid_values>isolate</invalid_values>
  <order_of_combinations>2</order_of_combinations>
</test_model>
`;
}

function outputElement(output: { name: string; type: string; expected?: string }): string {
  return `    <test_element abstract_type="NUMERIC" real_type="double">
      <name>${output.name}</name>
      <type>${output.type}</type>
${output.expected === undefined ? '' : `      <expected>${output.expected}</expected>\n`}    </test_element>
`;
}

const scalar = (spelling: string) => ({
  spelling,
  kind: 'scalar' as const,
  members: [],
  literals: [],
});

/** The interfaces and the world of the sample activity. */
export const DESCRIPTION: ActivityDescription = {
  provided: [
    {
      name: 'InfraredSensorService',
      source: 'InfraredSensorService.xml',
      methods: [
        {
          name: 'GetInfraredData',
          line: 3,
          signature: 'int,Pose,sequence<double>',
          callType: 'BLOCKING',
          returnType: scalar('double'),
          parameters: [
            { name: 'IndexOfSensor', direction: 'IN', type: scalar('int') },
            {
              name: 'pose',
              direction: 'IN',
              type: {
                ...scalar('Pose'),
                kind: 'struct',
                members: [{ name: 'x', type: scalar('double') }],
              },
            },
            {
              name: 'path',
              direction: 'IN',
              type: {
                ...scalar('sequence<double>'),
                kind: 'sequence',
                members: [{ name: '[]', type: scalar('double') }],
              },
            },
            { name: 'quality', direction: 'OUT', type: scalar('int') },
          ],
          raises: [],
        },
      ],
    },
  ],
  required: [
    {
      name: 'Motor',
      source: 'Motor.xml',
      methods: [
        {
          name: 'State',
          line: 3,
          signature: '',
          callType: 'BLOCKING',
          returnType: { ...scalar('State'), kind: 'enumeration', literals: ['ON', 'OFF'] },
          parameters: [{ name: 'ok', direction: 'OUT', type: scalar('boolean') }],
          raises: [],
        },
      ],
    },
  ],
  world: {
    path: 'world/ir.world.yaml',
    parameters: [
      { name: 'Distance', unit: 'm', min: -10, max: 10, defaultValue: 5 },
      { name: 'Friction', unit: '1', min: 0, max: 2, defaultValue: 1 },
    ],
    devices: [],
    observations: [],
  },
  warnings: [],
};
