import { screen, within } from '@testing-library/react';
import { beforeEach, describe, expect, test } from 'vitest';
import type { Difference, ResultComparison, ValueComparison } from '@/shared/api';
import { divergenceOf } from '@/features/replay/divergence';
import { readRecording } from '@/features/replay/recording';
import { eachWithServer } from './support/eachWithServer';
import type { FakeServer } from './support/FakeServer';
import { recordingGlb } from './support/glb';
import { openPortal } from './support/openPortal';
import { doneBuild, resultCases } from './support/samples';

let server: FakeServer;

eachWithServer((started) => {
  server = started;
});

const PROVENANCE = {
  suite: 'aa',
  seed: 1,
  harness: 'bb',
  component: 'cc',
  agent: 'bench-1',
  bridge: '',
  compiler: 'javac 17',
  packages: [],
  started: '2026-01-01T00:00:00Z',
  finished: '2026-01-01T00:00:01Z',
};

function difference(no: number, changes: Partial<Difference> = {}): Difference {
  return {
    no,
    baseNo: no,
    valid: true,
    kind: 'value',
    output: 'return',
    inputs: { Distance: '5.0' },
    base: '5.0',
    now: '5.5',
    ...changes,
  };
}

const NO_OTHER_VERDICTS: ResultComparison = {
  parameters: [{ name: 'Distance', type: 'TDSD', realType: 'double' }],
  common: 55,
  onlyBefore: 0,
  onlyNow: 0,
  newlyFailing: 0,
  fixed: 0,
  slower: 0,
  timed: 0,
  notTimed: 'Times are not compared.',
  items: [],
};

const VALUES: ValueComparison = {
  base: PROVENANCE,
  now: PROVENANCE,
  otherTools: ['numpy 2.4.0 -> 2.4.6'],
  parameters: ['Distance'],
  cases: 55,
  differingCases: 3,
  differences: 3,
  groupCount: 2,
  groups: [
    {
      index: 0,
      text: '1 × IllegalStateException in NEW only',
      kind: 'error',
      output: '',
      size: 1,
      valid: 0,
      first: difference(5),
    },
    {
      index: 1,
      text: '2 values of return up to 0.5 off where Distance ≥ 5.0',
      kind: 'value',
      output: 'return',
      size: 2,
      valid: 2,
      first: difference(7),
    },
  ],
  lastBits: 0,
  slower: 0,
  notComparable: 1,
};

describe('a comparison by values', () => {
  beforeEach(() => {
    const cases = resultCases(['PASS', 'PASS', 'PASS']);
    for (const id of ['b0', 'b1']) {
      server.builds.push({ ...doneBuild(id, cases), commit: `${id}23` });
      server.cases.set(id, cases);
    }
    server.values = VALUES;
    server.comparison = NO_OTHER_VERDICTS;
    server.differences.set('1', [difference(2), difference(3, { valid: false, at: 0.25 })]);
  });

  test('shows the groups, and the cases of one with both values', async () => {
    const { user, history } = openPortal(server, '/builds/b1/compare?with=b0');
    expect(await screen.findByRole('heading', { name: 'Differences: 3' })).toBeVisible();
    expect(screen.getByText('numpy 2.4.0 -> 2.4.6')).toBeVisible();
    expect(screen.getByText(/confirms differences by further runs/)).toBeVisible();
    expect(await screen.findByRole('cell', { name: 'only NEW has it' })).toBeVisible();
    await user.click(screen.getByRole('button', { name: /^Show cases: 2 values of return/ }));
    const cases = await screen.findByRole('table', { name: 'Cases of the group' });
    const rows = within(cases).getAllByRole('row');
    expect(rows[1]).toHaveTextContent('25.0return5.05.5');
    expect(rows[2]).toHaveTextContent('3 (invalid)');
    expect(rows[2]).toHaveTextContent('0.25');
    expect(history.location.search).toContain('group=1');
    await user.click(screen.getByRole('button', { name: /^Hide cases/ }));
    expect(screen.queryByRole('table', { name: 'Cases of the group' })).toBeNull();
  });

  test('shows both replays of a case at their divergence', async () => {
    server.recordings.set('b0 2', recordingGlb());
    server.recordings.set('b1 2', recordingGlb(undefined, [2, 1.25, 1]));
    const { user } = openPortal(server, '/builds/b1/compare?with=b0&group=1');
    await user.click(await screen.findByRole('button', { name: 'Replays of case 2' }));
    const both = await screen.findByRole('group', { name: 'Both replays' });
    expect(within(both).getByText(/diverge at 0.500 s/)).toHaveTextContent('front.range');
    expect(screen.getByTestId('pair-clock')).toHaveTextContent('0.50 of 1.00 s');
    const readings = within(both).getByRole('table', { name: 'Readings of both' });
    expect(within(readings).getAllByRole('row')[1]).toHaveTextContent('front.range1.51.25');
    await user.click(screen.getByRole('button', { name: 'Previous step' }));
    expect(screen.getByTestId('pair-clock')).toHaveTextContent('0.00 of 1.00 s');
    await user.click(screen.getByRole('button', { name: 'To the divergence' }));
    expect(screen.getByTestId('pair-clock')).toHaveTextContent('0.50 of 1.00 s');
  });

  test('says which build has no recording', async () => {
    server.recordings.set('b1 2', recordingGlb());
    openPortal(server, '/builds/b1/compare?with=b0&case=2&other=2');
    expect(await screen.findByText(/Not recorded in Before/)).toBeVisible();
  });

  test('names the commits of both builds', async () => {
    openPortal(server, '/builds/b1/compare?with=b0');
    expect(await screen.findByRole('link', { name: /commit b123/ })).toBeVisible();
    expect(await screen.findByRole('link', { name: /commit b023/ })).toBeVisible();
  });

  test('says why results cannot be compared', async () => {
    server.values = undefined;
    openPortal(server, '/builds/b1/compare?with=b0');
    expect(await screen.findByText('The values could not be compared')).toBeVisible();
    expect(await screen.findByText(/their parameters differ/)).toBeVisible();
  });
});

describe('the divergence of two recordings', () => {
  const read = (...given: Parameters<typeof recordingGlb>) =>
    readRecording(new Uint8Array(recordingGlb(...given)).buffer);

  test('is where the first reading or motion differs', () => {
    expect(divergenceOf(read(), read())).toBeUndefined();
    expect(divergenceOf(read(), read(undefined, [2, 1.5, 1.1]))).toEqual({
      frame: 2,
      seconds: 1,
      what: 'front.range',
    });
    expect(divergenceOf(read(), read(undefined, [2, 1.5, 1.1], 0.25))).toEqual({
      frame: 1,
      seconds: 0.5,
      what: 'the translation of robot',
    });
  });

  test('is not a rounding of 32-bit floats', () => {
    expect(divergenceOf(read(), read(undefined, [2, 1.5000001, 1]))).toBeUndefined();
  });
});
