import { screen, waitFor, within } from '@testing-library/react';
import axe from 'axe-core';
import { describe, expect, test } from 'vitest';
import type { CaseHistory, CasePoint } from '@/shared/api';
import { caseHistoryOption } from '@/features/history/caseHistoryOption';
import { eachWithServer } from './support/eachWithServer';
import type { FakeServer } from './support/FakeServer';
import { openPortal } from './support/openPortal';
import { activity, doneBuild, gitCommit, gitSource, resultCases } from './support/samples';

const ONE = 'a'.repeat(40);
const TWO = 'b'.repeat(40);
const THREE = 'c'.repeat(40);
const FOUR = 'd'.repeat(40);
const ADDRESS = '/activities/a1/history/GetInfraredData';

function point(changes: Partial<CasePoint>): CasePoint {
  return {
    at: '2026-01-01T00:00:00Z',
    replaced: false,
    suspect: false,
    state: 'JUDGED',
    actual: {},
    ...changes,
  };
}

const PASSED = point({
  commit: ONE,
  subject: 'Add the sensor',
  author: 'Tester',
  buildId: 'b1',
  no: 7,
  verdict: 'PASS',
  valid: true,
  actual: { return: '2.5' },
  margin: { condition: 'stays away', value: '0.25' },
  time: { medianUs: 12.5, calls: 20, lowUs: 12, highUs: 13 },
});

const FAILED = point({
  commit: TWO,
  subject: 'Break it',
  author: 'Tester',
  buildId: 'b2',
  no: 9,
  verdict: 'FAIL',
  valid: false,
  actual: { return: '42' },
  margin: { condition: 'stays away', value: '-Infinity' },
  time: { medianUs: 30, calls: 0 },
  message: 'a wrong value',
  verdictChanged: true,
  valueChanged: true,
});

const ABSENT = point({
  commit: THREE,
  subject: 'Change the model',
  author: 'Tester',
  buildId: 'b3',
  state: 'ABSENT',
  reason: 'The build has no case with these inputs.',
});

const INVALID = point({
  commit: FOUR,
  subject: 'Remove the profile',
  state: 'INVALID',
  reason: 'The folder holds no activity.yaml.',
});

function history(items: CasePoint[], changes: Partial<CaseHistory> = {}): CaseHistory {
  return {
    buildId: 'b1',
    no: 7,
    parameters: ['Index', 'Distance'],
    values: ['1', '2.5'],
    steps: 0,
    by: 'COMMITS',
    items,
    page: 0,
    size: 50,
    total: items.length,
    ...changes,
  };
}

let server: FakeServer;

eachWithServer((started) => {
  server = started;
  server.activities.push(activity('a1'));
});

async function rows() {
  const table = await screen.findByRole('table', { name: 'History of the case' });
  return within(table)
    .getAllByRole('row')
    .slice(1)
    .map((row) => row);
}

describe('the history of a case', () => {
  test('has a row for each commit and marks what changed', async () => {
    server.caseHistories.set(7, history([INVALID, ABSENT, FAILED, PASSED]));
    openPortal(server, `${ADDRESS}?case=7&build=b1`);
    const [invalid, absent, failed, passed] = await rows();
    expect(screen.getByText('Index = 1, Distance = 2.5')).toBeVisible();
    expect(invalid).toHaveTextContent('Cannot be built');
    expect(invalid).toHaveTextContent('no activity.yaml');
    expect(absent).toHaveTextContent('Not in this build');
    expect(failed).toHaveTextContent('✕ Fail');
    expect(failed).toHaveTextContent('Verdict changed');
    expect(failed).toHaveTextContent('Value changed');
    expect(failed).toHaveTextContent('Invalid inputs');
    expect(failed).toHaveTextContent('-Infinity');
    expect(failed).toHaveTextContent('one call');
    expect(failed).toHaveTextContent('a wrong value');
    expect(passed).toHaveTextContent('✓ Pass');
    expect(passed).not.toHaveTextContent('changed');
    expect(passed).toHaveTextContent('12.5 µs');
    expect(passed).toHaveTextContent('0.25');
    expect(within(failed as HTMLElement).getByRole('link', { name: 'Compare' })).toHaveAttribute(
      'href',
      '/builds/b2/compare?with=b1',
    );
    expect(within(failed as HTMLElement).getByRole('link', { name: 'Break it' })).toHaveAttribute(
      'href',
      '/builds/b2?case=9',
    );
    expect(
      screen.getByRole('img', { name: 'Value, Margin, Median time of the case over time' }),
    ).toBeVisible();
    expect(server.requests.filter((request) => request.includes('case-history'))).toEqual([
      'GET /api/v1/activities/a1/case-history?model=GetInfraredData&no=7&build=b1&page=0&size=50',
    ]);
  });

  test('shows another case when its number is entered', async () => {
    server.caseHistories.set(7, history([PASSED]));
    server.caseHistories.set(12, history([FAILED], { no: 12 }));
    const { user, history: address } = openPortal(server, `${ADDRESS}?case=7&build=b1`);
    await rows();
    const number = screen.getByRole('textbox', { name: 'Case' });
    await user.clear(number);
    await user.type(number, '12{Enter}');
    expect(await screen.findByText('a wrong value')).toBeVisible();
    expect(address.location.search).toBe('?case=12&build=b1');
  });

  test('shows builds on request, and has an address for it', async () => {
    server.caseHistories.set(1, history([PASSED]));
    const { user, history: address } = openPortal(server, ADDRESS);
    await rows();
    await user.click(screen.getByRole('radio', { name: 'All builds' }));
    expect(await screen.findByRole('columnheader', { name: 'Build' })).toBeVisible();
    expect(address.location.search).toBe('?points=BUILDS');
  });

  test('is paged', async () => {
    const many = Array.from({ length: 51 }, (_, index) =>
      point({ commit: String(index).padStart(40, '0'), subject: `Commit ${index}` }),
    );
    server.caseHistories.set(1, history(many));
    const { user } = openPortal(server, ADDRESS);
    expect(await rows()).toHaveLength(50);
    await user.click(screen.getByRole('button', { name: 'Page 2' }));
    await waitFor(() => {
      expect(screen.getByText('Commit 50')).toBeVisible();
    });
    expect(await rows()).toHaveLength(1);
  });

  test('says what is wrong with a case that does not exist', async () => {
    openPortal(server, `${ADDRESS}?case=99`);
    expect(await screen.findByText('The history could not be read')).toBeVisible();
  });

  test('is reached from the cells of a branch', async () => {
    server.gitSource = gitSource();
    server.caseHistories.set(1, history([PASSED]));
    server.gitCommits.push(
      gitCommit(ONE, {
        cells: [
          { model: 'GetInfraredData', buildId: 'b1', state: 'DONE', suspect: false, total: 55 },
        ],
      }),
    );
    const { user } = openPortal(server, '/activities/a1?tab=commits');
    await user.click(
      await screen.findByRole('link', {
        name: 'History of the cases of GetInfraredData at aaaaaaaaaa',
      }),
    );
    expect(await rows()).toHaveLength(1);
  });

  test('is reached from a case of a build', async () => {
    const cases = resultCases(['PASS', 'FAIL']);
    server.builds.push(doneBuild('b1', cases));
    server.cases.set('b1', cases);
    openPortal(server, '/builds/b1?case=2');
    expect(await screen.findByRole('link', { name: 'History of the case' })).toHaveAttribute(
      'href',
      '/activities/a1/history/GetInfraredData?build=b1&case=2',
    );
  });

  test('has no violations that axe finds', async () => {
    server.caseHistories.set(1, history([INVALID, ABSENT, FAILED, PASSED]));
    const { container } = openPortal(server, ADDRESS);
    await rows();
    // jsdom does not paint, so contrast is checked in the browser tests.
    const { violations } = await axe.run(container, {
      rules: { 'color-contrast': { enabled: false } },
    });
    expect(violations.map(({ id, nodes }) => [id, nodes.map((node) => node.html)])).toEqual([]);
  });
});

describe('the chart of the history', () => {
  test('has rows for what is a number, and gaps for what is not', () => {
    const { rows: names, option } = caseHistoryOption([PASSED, FAILED, ABSENT]);
    expect(names).toEqual(['Value', 'Margin', 'Median time']);
    const series = option.series as { data: { value: number | null; symbol: string }[] }[];
    expect(series.map(({ data }) => data.map(({ value }) => value))).toEqual([
      [2.5, 42, null],
      [0.25, null, null],
      [12.5, 30, null],
    ]);
    expect(series[0]?.data.map(({ symbol }) => symbol).slice(0, 2)).toEqual(['circle', 'diamond']);
  });

  test('leaves out outputs that are texts', () => {
    const texts = [PASSED, point({ actual: { return: 'open' } })];
    expect(caseHistoryOption(texts).rows).toEqual(['Margin', 'Median time']);
  });
});
