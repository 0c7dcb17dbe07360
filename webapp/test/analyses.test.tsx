import { screen, waitFor, within } from '@testing-library/react';
import userEvent from '@testing-library/user-event';
import { describe, expect, onTestFinished, test, vi } from 'vitest';
import { regionOf } from '@/features/analyses/region';
import type { BuildAnalysis, Cause, Explanation } from '@/shared/api';
import { eachWithServer } from './support/eachWithServer';
import type { FakeServer } from './support/FakeServer';
import { openPortal } from './support/openPortal';
import { build, doneBuild, resultCase } from './support/samples';

let server: FakeServer;

eachWithServer((started) => {
  server = started;
});

const OF_ALL: Cause = {
  parameters: [],
  verdict: 'FAIL',
  message: 'return is 10.0',
  cases: [1, 3],
  simplest: [
    { name: 'IndexOfSensor', literal: '1' },
    { name: 'NumOfSensor', literal: '1' },
    { name: 'Distance', literal: '9.5' },
  ],
  executions: 60,
  steps: [],
  sentence: 'fails in every case',
  record: [{ name: 'verdict', literal: 'FAIL' }],
};

const CAUSE: Cause = {
  ...OF_ALL,
  parameters: [{ name: 'Distance', literal: '9.5' }],
  boundary: { parameter: 'Distance', passes: '5.25', fails: '5.250000000000001' },
  sentence: 'fails where `Distance` is above 5.25, whatever the rest',
};

const EXPLANATION: Explanation = {
  causes: [
    CAUSE,
    { ...CAUSE, parameters: [{ name: 'Distance', literal: '10.0' }], cases: [2, 3] },
    {
      ...OF_ALL,
      relation: 'IndexOfSensor == NumOfSensor',
      sentence: 'fails where IndexOfSensor == NumOfSensor, whatever the rest',
      cases: [4],
    },
  ],
  executions: 61,
  unexplained: [5],
  further: [{ values: ['1', '1', '5.0'], failed: false }],
  inputs: [
    { name: 'IndexOfSensor', numeric: true, values: ['2', '1'], invalid: [] },
    { name: 'NumOfSensor', numeric: true, values: ['1', '2'], invalid: [] },
    { name: 'Distance', numeric: true, values: ['9.5', '10.0', '5.0', '-1'], invalid: ['-1'] },
  ],
};

function analysis(changes: Partial<BuildAnalysis>): BuildAnalysis {
  return {
    id: 'x1',
    state: 'DONE',
    created: '2026-03-01T10:01:00Z',
    executed: 61,
    maxCases: 500,
    ...changes,
  };
}

/** Holds the answers to requests such as `GET http://...` until they are released. */
function holdAnswers(requests: RegExp) {
  const send = globalThis.fetch;
  let release = () => {};
  const released = new Promise<void>((resolve) => {
    release = resolve;
  });
  const answers = {
    held: 0,
    release: () => {
      release();
    },
  };
  vi.spyOn(globalThis, 'fetch').mockImplementation(async (input, init) => {
    const answer = await send(input, init);
    if (input instanceof Request && requests.test(`${input.method} ${input.url}`)) {
      answers.held++;
      await released;
    }
    return answer;
  });
  onTestFinished(() => {
    vi.restoreAllMocks();
  });
  return answers;
}

describe('causes of failures', () => {
  test('are requested, and shown above the cases with one row for each boundary', async () => {
    const cases = [resultCase(1, 'FAIL'), resultCase(2, 'PASS')];
    server.cases.set('b1', cases);
    server.builds.push(doneBuild('b1', cases), build('b2'));
    server.requestedAnalysis = analysis({ explanation: EXPLANATION });
    openPortal(server, '/builds/b1');
    await userEvent.click(await screen.findByRole('button', { name: 'Explain' }));
    const first = await screen.findByRole('group', { name: 'Cause 1' });
    expect(within(first).getByText(/^Fails where `Distance` is above 5.25/)).toBeVisible();
    expect(within(first).getAllByRole('link', { name: /^\d+$/ })).toHaveLength(3);
    expect(within(first).getByRole('img', { name: /^Distance passes with 5.25/ })).toBeVisible();
    expect(within(first).getByRole('link', { name: 'Download bundle' })).toHaveAttribute(
      'href',
      '/api/v1/builds/b1/explanation/causes/1/bundle',
    );
    expect(screen.queryByRole('group', { name: 'Cause 2' })).toBeNull();
    const relation = screen.getByRole('group', { name: 'Cause 3' });
    expect(
      within(relation).getByRole('img', {
        name: 'Failing cases over IndexOfSensor and NumOfSensor',
      }),
    ).toBeVisible();
    expect(screen.getByText(/^Not explained:/)).toBeVisible();
    await userEvent.click(within(relation).getByRole('button', { name: 'Run again' }));
    expect(server.requests).toContain('POST /api/v1/builds/b1/explanation/causes/3/run');
  });

  test('are shown ten at a time', async () => {
    const causes = Array.from({ length: 25 }, (_, n): Cause => ({
      ...OF_ALL,
      parameters: [{ name: 'Distance', literal: `${n}` }],
      sentence: `fails where Distance is ${n}`,
      cases: [n + 1],
    }));
    const cases = [resultCase(1, 'FAIL')];
    server.cases.set('b1', cases);
    server.builds.push(doneBuild('b1', cases));
    server.analyses.set('b1 explanation', analysis({ explanation: { ...EXPLANATION, causes } }));
    const { user } = openPortal(server, '/builds/b1');
    expect(await screen.findByRole('group', { name: 'Cause 10' })).toBeVisible();
    expect(screen.queryByRole('group', { name: 'Cause 11' })).toBeNull();
    expect(screen.getByText('10 of 25 are shown.')).toBeVisible();
    await user.click(screen.getByRole('button', { name: 'Show 15 more causes' }));
    expect(await screen.findByRole('group', { name: 'Cause 25' })).toBeVisible();
    expect(screen.queryByRole('button', { name: /more causes/ })).toBeNull();
  });

  test('are shown if an answer from before the request arrives after it', async () => {
    const cases = [resultCase(1, 'FAIL')];
    server.cases.set('b1', cases);
    server.builds.push(doneBuild('b1', cases));
    server.requestedAnalysis = analysis({ explanation: EXPLANATION });
    openPortal(server, '/builds/b1');
    const button = await screen.findByRole('button', { name: 'Explain' });
    const early = holdAnswers(/^GET .*\/explanation$/);
    // The portal reads everything again once it is connected again.
    await server.stop();
    await screen.findByText(/No connection to the server/);
    await server.start();
    await waitFor(() => {
      expect(early.held).toBe(1);
    });
    await userEvent.click(button);
    await screen.findByRole('group', { name: 'Cause 1' });
    early.release();
    await new Promise((resolve) => setTimeout(resolve, 100));
    expect(screen.getByRole('group', { name: 'Cause 1' })).toBeVisible();
  });

  test('show how far the explanation is, and can be cancelled', async () => {
    const cases = [resultCase(1, 'FAIL')];
    server.cases.set('b1', cases);
    server.builds.push(doneBuild('b1', cases), build('x1', { state: 'RUNNING' }));
    server.analyses.set('b1 explanation', analysis({ state: 'RUNNING', executed: 12 }));
    openPortal(server, '/builds/b1');
    expect(await screen.findByText('12 of at most 500 further cases executed')).toBeVisible();
    await userEvent.click(screen.getByRole('button', { name: 'Cancel' }));
    expect(server.requests).toContain('POST /api/v1/builds/x1/cancel');
  });

  test('are not offered if all cases passed', async () => {
    const cases = [resultCase(1, 'PASS')];
    server.cases.set('b1', cases);
    server.builds.push(doneBuild('b1', cases));
    openPortal(server, '/builds/b1');
    await screen.findByRole('table', { name: 'Cases' });
    expect(screen.queryByRole('button', { name: 'Explain' })).toBeNull();
  });
});

describe('the failing region', () => {
  test('covers the inputs of the cause, with ascending numbers', () => {
    const [, , relation] = EXPLANATION.causes;
    if (!relation) throw new Error('no relation');
    const region = regionOf(relation, EXPLANATION, [
      { values: ['1', '1', '9.5'], failed: true },
      { values: ['1', '2', '9.5'], failed: false },
      { values: ['2', '2', '9.5'], failed: true },
    ]);
    expect(region?.columns).toEqual(['1', '2']);
    expect(region?.rows).toEqual(['1', '2']);
    expect(region?.cells).toEqual([
      ['both', 'unknown'],
      ['passes', 'fails'],
    ]);
  });

  test('shows the values around that of the cause if there are many', () => {
    const values = Array.from({ length: 100 }, (_, n) => `${n}`);
    const region = regionOf(
      { ...CAUSE, parameters: [{ name: 'Distance', literal: '90' }] },
      {
        ...EXPLANATION,
        further: [{ values: ['1', '1', '90'], failed: true }],
        inputs: EXPLANATION.inputs.map((input) =>
          input.name === 'Distance' ? { ...input, values } : input,
        ),
      },
      [
        { values: ['1', '2', '90'], failed: false },
        { values: ['1', '2', '3'], failed: true },
      ],
    );
    expect(region?.columns).toEqual(values.slice(76));
    expect(region?.cells.flat().filter((state) => state !== 'unknown')).toEqual(['both']);
  });

  test('needs two inputs that vary', () => {
    const inputs = EXPLANATION.inputs.map((input) => ({ ...input, values: ['1'] }));
    expect(regionOf(CAUSE, { ...EXPLANATION, inputs }, [])).toBeNull();
  });
});

describe('the score of a specification', () => {
  test('is shown with what to add to the specification', async () => {
    const cases = [resultCase(1, 'PASS')];
    server.cases.set('b1', cases);
    server.builds.push(doneBuild('b1', cases));
    server.requestedAnalysis = analysis({
      score: {
        injected: 12,
        noticed: 9,
        equivalent: 2,
        survivors: [{ fault: 'return: sign', where: 'return', suggestion: 'expect a value' }],
        outputs: [{ output: 'return', changed: 10, noticed: 9 }],
        warnings: [],
        mutations: {
          made: 7,
          noticed: 3,
          survivors: [
            {
              fault: 'component/Arm.java:12: < replaced by <=',
              where: 'component/Arm.java:12',
              suggestion: 'case 3: return is 5.0 instead of 4.5',
            },
          ],
          unchanged: ['component/Arm.java:20: call of close left out'],
        },
      },
    });
    openPortal(server, '/builds/b1?tab=score');
    await userEvent.click(await screen.findByRole('button', { name: 'Score' }));
    expect(await screen.findByText('90.0 %')).toBeVisible();
    const survivors = screen.getByRole('group', { name: 'Faults that are not noticed' });
    expect(within(survivors).getByText('expect a value')).toBeVisible();
    expect(screen.getByText('50.0 %')).toBeVisible();
    const mutations = screen.getByRole('group', { name: 'Mutations that are not noticed' });
    expect(within(mutations).getByText('case 3: return is 5.0 instead of 4.5')).toBeVisible();
    expect(screen.getByText('component/Arm.java:20: call of close left out')).toBeInTheDocument();
  });
});

describe('flaky cases', () => {
  test('are found by further runs, and shown with the verdict of each', async () => {
    const cases = [resultCase(1, 'FAIL'), resultCase(2, 'PASS')];
    server.cases.set('b1', cases);
    server.builds.push(doneBuild('b1', cases));
    server.requestedAnalysis = analysis({
      repetition: {
        runs: 3,
        count: 1,
        cases: [
          {
            no: 1,
            cause: 'COMPONENT',
            verdicts: ['FAIL', 'PASS', 'PASS', 'ERROR'],
            reason: 'its readings are equal until it gives other commands at 0.12 s',
          },
        ],
      },
    });
    openPortal(server, '/builds/b1?tab=flaky');
    const runs = await screen.findByLabelText(/^Further runs/);
    await userEvent.clear(runs);
    await userEvent.type(runs, '3');
    await userEvent.click(screen.getByRole('button', { name: 'Run repeatedly' }));
    const table = await screen.findByRole('table', { name: 'Flaky cases' });
    expect(server.analysisRequests).toEqual([{ runs: 3 }]);
    expect(screen.getByText('1 case is not reproducible in 3 further runs.')).toBeVisible();
    expect(within(table).getByRole('img', { name: 'FAIL, PASS, PASS, ERROR' })).toBeVisible();
    expect(within(table).getByText('Component')).toBeVisible();
    expect(within(table).getByText(/at 0.12 s$/)).toBeVisible();
    expect(within(table).getByRole('link', { name: '1' })).toHaveAttribute(
      'href',
      '/builds/b1?case=1',
    );
  });

  test('are none if all runs are equal', async () => {
    const cases = [resultCase(1, 'PASS')];
    server.cases.set('b1', cases);
    server.builds.push(doneBuild('b1', cases));
    server.analyses.set(
      'b1 repetition',
      analysis({ repetition: { runs: 10, count: 0, cases: [] } }),
    );
    openPortal(server, '/builds/b1?tab=flaky');
    expect(
      await screen.findByText(
        'In 10 further runs each case had the same verdict and the same values.',
      ),
    ).toBeVisible();
  });
});
