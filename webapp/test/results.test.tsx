import { screen, waitFor, within } from '@testing-library/react';
import { describe, expect, test } from 'vitest';
import type { ResultCase } from '@/shared/api';
import { eachWithServer } from './support/eachWithServer';
import type { FakeServer } from './support/FakeServer';
import { openPortal } from './support/openPortal';
import { doneBuild, resultCase, resultCases } from './support/samples';

let server: FakeServer;

eachWithServer((started) => {
  server = started;
});

describe('a result', () => {
  test('shows the verdict and the message first, then inputs and outputs by kind', async () => {
    const cases = [resultCase(1, 'FAIL', { message: 'return is 10.0' })];
    server.cases.set('b1', cases);
    server.builds.push(doneBuild('b1', cases));
    openPortal(server, '/builds/b1');
    const table = await screen.findByRole('table', { name: 'Cases' });
    const [groups, names, first] = within(table).getAllByRole('row');
    expect(cells(groups)).toEqual([
      'No',
      'Verdict',
      'Message',
      'Input (TDI)',
      'Simulation (TDSD)',
      'Expected',
      'Actual',
      'Actual − expected',
      'Time',
    ]);
    expect(cells(names)).toEqual([
      'IndexOfSensor',
      'NumOfSensor',
      'Distance',
      'return',
      'return',
      'return',
    ]);
    expect(cells(first)).toEqual([
      '1',
      '✕ Fail',
      'return is 10.0',
      '2',
      '4',
      '5.0',
      '5.0',
      '10.0',
      '+5',
      '4.25 µs',
    ]);
  });

  test('has a column for each output, and none for messages if all cases passed', async () => {
    const outputs = { return: '5.0', quality: '3' };
    const cases = [resultCase(1, 'PASS', { expected: { quality: '3' }, actual: outputs })];
    server.cases.set('b1', cases);
    server.builds.push(doneBuild('b1', cases));
    openPortal(server, '/builds/b1');
    const table = await screen.findByRole('table', { name: 'Cases' });
    const [groups, names, first] = within(table).getAllByRole('row');
    expect(cells(groups)).not.toContain('Message');
    expect(cells(names).slice(3)).toEqual(['quality', 'return', 'quality', 'return']);
    expect(cells(first).slice(5, -1)).toEqual(['3', '–', '3', '5.0']);
  });

  test('shows what was measured of real devices in a case', async () => {
    const devices = {
      devices: ['ir1: a real device', 'ir2: recorded readings'],
      meanJitterMs: 0.25,
      maxJitterMs: 12.5,
      missedDeadlines: 1,
      readings: 1200,
      maxAgeMs: 31,
      staleReadings: 2,
      refusedCommands: 3,
      safeStops: 1,
      faults: ['ir1: a reading was too old'],
    };
    const cases = [resultCase(3, 'DONT', { devices })];
    server.cases.set('b1', cases);
    server.builds.push(doneBuild('b1', cases));
    openPortal(server, '/builds/b1?case=3');
    const drawer = await screen.findByRole('dialog', { name: /^Case 3/ });
    const facts = within(drawer);
    expect(await facts.findByText('ir1: a real device, ir2: recorded readings')).toBeVisible();
    expect(facts.getByText('12.5 ms at most, 250 µs on average, 1 missed deadline')).toBeVisible();
    expect(facts.getByText('1,200, at most 31.0 ms old, 2 too old')).toBeVisible();
    expect(facts.getByText('3 commands refused, 1 safe stop')).toBeVisible();
    expect(facts.getByText('ir1: a reading was too old')).toBeVisible();
  });

  test('names the tools and packages of the build', async () => {
    const cases = resultCases(['PASS']);
    server.cases.set('b1', cases);
    server.builds.push(doneBuild('b1', cases));
    openPortal(server, '/builds/b1');
    const table = await screen.findByRole('table', { name: 'What was executed' });
    const rows = within(table).getAllByRole('row').map(cells);
    expect(rows).toContainEqual(['Compiler', 'Python 3.11.2']);
    expect(rows).toContainEqual(['Package', `numpy 2.4.6 ${'d'.repeat(64)}`]);
  });

  test('hides constant parameters', async () => {
    const cases = resultCases(['PASS', 'FAIL', 'PASS']).map((item) => ({
      ...item,
      values: ['1', String(item.no), '5.0'],
    }));
    server.cases.set('b1', cases);
    server.builds.push(doneBuild('b1', cases));
    const { user } = openPortal(server, '/builds/b1');
    expect(await screen.findByText('IndexOfSensor = 1, Distance = 5.0')).toBeVisible();
    const inputs = () => {
      const table = screen.getByRole('table', { name: 'Cases' });
      return cells(within(table).getAllByRole('row')[1]).slice(0, -3);
    };
    expect(inputs()).toEqual(['NumOfSensor']);
    await user.click(screen.getByRole('switch', { name: 'Show constant parameters' }));
    expect(inputs()).toEqual(['IndexOfSensor', 'NumOfSensor', 'Distance']);
  });

  test('summarizes the verdicts and the processing time', async () => {
    const cases = resultCases(['PASS', 'PASS', 'FAIL', 'ERROR', 'DONT']);
    server.cases.set('b1', cases);
    server.builds.push(doneBuild('b1', cases));
    openPortal(server, '/builds/b1');
    await screen.findByText('Std deviation');
    const facts = Object.fromEntries(
      screen
        .getAllByRole('term')
        .map((term) => [term.textContent, term.nextElementSibling?.textContent]),
    );
    expect(facts).toEqual({
      Total: '5',
      Pass: '2',
      Fail: '1',
      Error: '1',
      'Not executed': '1',
      Min: '4.25 µs',
      Max: '4.75 µs',
      Average: '4.50 µs',
      'Std deviation': '250 ns',
    });
  });

  test('begins with what failed, since when, and the first failing case', async () => {
    const cases = [
      resultCase(1, 'PASS'),
      resultCase(2, 'FAIL', { message: 'return is 10.0', expected: { return: '5.0' } }),
      resultCase(3, 'ERROR', { message: 'ValueError: no sensor' }),
    ];
    server.cases.set('b1', cases);
    server.builds.push(doneBuild('b1', cases));
    server.failures = {
      groups: [
        {
          verdict: 'FAIL',
          message: 'return is 10.0',
          uniform: false,
          cases: 1,
          numbers: [2],
          newlyFailing: 1,
        },
        {
          verdict: 'ERROR',
          message: 'ValueError: no sensor',
          uniform: true,
          cases: 1,
          numbers: [3],
        },
      ],
      leftOut: 3,
      firstFailing: 2,
      before: {
        buildId: 'b0',
        received: '2026-03-09T12:00:00Z',
        newlyFailing: 1,
        stillFailing: 1,
        fixed: 4,
      },
      since: {
        buildId: 'bx',
        received: '2026-03-01T12:00:00Z',
        commit: 'abcdef0123456789',
        results: 7,
        passedBefore: true,
      },
    };
    const { user } = openPortal(server, '/builds/b1');
    expect(await screen.findByText('2 of 3 cases fail')).toBeVisible();
    const groups = await screen.findByRole('table', { name: 'What failed' });
    const rows = within(groups).getAllByRole('row').slice(1);
    expect(rows.map((row) => cells(row).slice(0, 2))).toEqual([
      ['1', '✕ Fail'],
      ['1', '! Error'],
    ]);
    expect(rows[0]).toHaveTextContent(
      'return is 10.0Numbers differ between the cases. Case 2 1 new',
    );
    expect(screen.getByText(/3 other groups/)).toBeVisible();
    expect(screen.getByText(/7 results in a row/)).toHaveTextContent(
      /^Failing since the build of .* \(commit abcdef01.*\), 7 results in a row\. Against the build before: 1 newly failing, 1 still failing, 4 fixed\.$/,
    );
    const first = await screen.findByRole('region', { name: 'First failing case' });
    expect(within(first).getByRole('link', { name: 'Open case 2' })).toHaveAttribute(
      'href',
      '/builds/b1/cases/2',
    );
    expect(within(first).getByRole('row', { name: /^return/ })).toHaveTextContent('5.010.0+5');
    await user.click(within(groups).getByRole('button', { name: 'Open case 3' }));
    expect(await screen.findByRole('dialog', { name: /^Case 3: Error/ })).toBeVisible();
  });

  test('shows the median of repeated calls with its interval, and calls that differ', async () => {
    const repeated = { calls: 20, warmUp: 3, medianUs: 4.1, lowUs: 4, highUs: 4.5 };
    const cases = [
      resultCase(1, 'PASS', { processingTimeUs: 370, repeated }),
      resultCase(2, 'PASS', { repeated: { ...repeated, differs: 'call 7: return is 1, not 0' } }),
    ];
    server.cases.set('b1', cases);
    server.builds.push(doneBuild('b1', cases));
    openPortal(server, '/builds/b1?case=2');
    const table = await screen.findByRole('table', { name: 'Cases', hidden: true });
    const times = within(table)
      .getAllByRole('row', { hidden: true })
      .slice(2)
      .map((row) => row.lastElementChild);
    expect(times.map((time) => time?.textContent)).toEqual([
      '4.10 µs ± 250 ns',
      '4.10 µs ± 250 ns ≠',
    ]);
    expect(times[0]).toHaveAttribute(
      'title',
      'Median of 20 calls, 95 % interval 4.00 µs to 4.50 µs; first call 370 µs',
    );
    expect(await screen.findByText('call 7: return is 1, not 0')).toBeVisible();
    expect(screen.getByText('4.00 µs to 4.50 µs')).toBeVisible();
  });

  test('is filtered by verdict through its address', async () => {
    const cases = resultCases(['PASS', 'FAIL', 'PASS', 'FAIL']);
    server.cases.set('b1', cases);
    server.builds.push(doneBuild('b1', cases));
    const { user, history } = openPortal(server, '/builds/b1?verdict=FAIL');
    const table = await screen.findByRole('table', { name: 'Cases' });
    expect(table).toHaveAttribute('aria-rowcount', String(2 + 2));
    await user.click(screen.getByRole('radio', { name: 'All 4' }));
    await waitFor(() => {
      expect(screen.getByRole('table', { name: 'Cases' })).toHaveAttribute(
        'aria-rowcount',
        String(2 + 4),
      );
    });
    expect(history.location.search).toBe('');
  });

  test('shows a case by its address, with its output as text', async () => {
    const cases = resultCases(['PASS', 'FAIL']);
    server.cases.set('b1', cases);
    server.builds.push(doneBuild('b1', cases));
    server.caseLogs.set('b1 2', '<b>loud</b> \u001b[31m\n');
    const { user, history } = openPortal(server, '/builds/b1?case=2');
    const printed = await screen.findByText('<b>loud</b> ␛[31m');
    await waitFor(() => {
      expect(printed).toBeVisible();
    });
    await waitFor(() => {
      expect(screen.getByText('Case 2: Fail')).toBeVisible();
    });
    await user.keyboard('{Escape}');
    await waitFor(() => {
      expect(history.location.search).toBe('');
    });
    await user.click(screen.getByRole('button', { name: 'Case 1' }));
    const nothing = await screen.findByText('No output.');
    // The drawer has an animation.
    await waitFor(() => {
      expect(nothing).toBeVisible();
    });
    expect(history.location.search).toBe('?case=1');
  });

  test('shows both runs of a relation and in how many cases it was checked', async () => {
    const broken: ResultCase['relations'][number] = {
      name: 'the order does not matter',
      verdict: 'FAIL',
      values: ['4', '2', '5.0'],
      actual: { return: '7.0' },
      message: 'is broken',
    };
    const skipped = { ...broken, verdict: 'SKIPPED' as const, values: [], actual: {} };
    const cases = [
      resultCase(1, 'FAIL', { relations: [broken] }),
      resultCase(2, 'PASS', { relations: [{ ...skipped, message: 'violates a pre-condition' }] }),
    ];
    server.cases.set('b1', cases);
    server.builds.push(doneBuild('b1', cases));
    openPortal(server, '/builds/b1?case=1');
    const counts = await screen.findByRole('table', {
      name: 'Relations between two runs',
      hidden: true,
    });
    expect(cells(within(counts).getAllByRole('row', { hidden: true })[1])).toEqual([
      'the order does not matter',
      '1',
      '1',
      '1',
      '0',
    ]);
    const runs = await screen.findByRole('table', {
      name: 'Runs of the relation the order does not matter',
    });
    const rows = within(runs).getAllByRole('row').map(cells);
    expect(rows[0]).toEqual(['Value', 'First run', 'Second run']);
    expect(rows.slice(1).map(([, ...values]) => values)).toEqual([
      ['2', '4'],
      ['4', '2'],
      ['5.0', '5.0'],
      ['10.0', '7.0'],
    ]);
  });

  test('shows the lines of the component that are not covered', async () => {
    const cases = resultCases(['PASS']);
    server.cases.set('b1', cases);
    server.builds.push(doneBuild('b1', cases));
    openPortal(server, '/builds/b1?tab=coverage');
    expect(await screen.findByText('Not covered: line 4.')).toBeVisible();
    expect(screen.getByText('75.0 %')).toBeVisible();
  });

  test('of 100,000 cases is never fetched at once', async () => {
    const cases = resultCases([...Array<'PASS'>(100_000).fill('PASS')]);
    server.cases.set('b1', cases);
    server.builds.push(doneBuild('b1', cases));
    openPortal(server, '/builds/b1');
    const table = await screen.findByRole('table', { name: 'Cases' });
    expect(table).toHaveAttribute('aria-rowcount', String(2 + 100_000));
    expect(within(table).getAllByRole('row').length).toBeLessThan(200);
    const fetched = server.requests.filter((line) => line.includes('/result/cases'));
    expect(fetched).toEqual(['GET /api/v1/builds/b1/result/cases?page=0&size=200']);
  });

  test('shows hostile text as text', async () => {
    const message = '<img src=x onerror=alert(1)> \u001b[31mred \u202eevil';
    const cases = [resultCase(1, 'ERROR', { message })];
    server.cases.set('b1', cases);
    server.builds.push(doneBuild('b1', cases));
    const { container } = openPortal(server, '/builds/b1');
    expect(
      await screen.findByText('<img src=x onerror=alert(1)> ␛[31mred ⟨U+202E⟩evil'),
    ).toBeVisible();
    expect(container.querySelector('[onerror]')).toBeNull();
  });
});

function cells(row: HTMLElement | undefined): (string | null)[] {
  return [...(row?.children ?? [])].map((cell) => cell.textContent);
}

describe('a comparison', () => {
  const comparison = {
    parameters: [{ name: 'Distance', type: 'TDSD' as const, realType: 'double' }],
    common: 2,
    onlyBefore: 0,
    onlyNow: 0,
    newlyFailing: 0,
    fixed: 0,
    slower: 0,
    timed: 0,
    items: [],
  };

  test('says why no case is slower and what to change', async () => {
    server.comparison = { ...comparison, notTimed: 'Times are not compared. Repeat the calls.' };
    openPortal(server, '/builds/b1/compare?with=b0');
    expect(await screen.findByText('Times are not compared. Repeat the calls.')).toBeVisible();
    expect(screen.getByRole('heading', { name: 'Slower: 0' })).toBeVisible();
  });

  test('shows the ratio and the p-value of slower cases', async () => {
    server.comparison = {
      ...comparison,
      slower: 1,
      timed: 2,
      items: [
        {
          change: 'slower',
          no: 7,
          values: ['5.0'],
          before: 'PASS',
          now: 'PASS',
          timeBeforeUs: 4,
          timeNowUs: 6,
          ratio: 1.5,
          p: 0.0000679,
        },
      ],
    };
    openPortal(server, '/builds/b1/compare?with=b0');
    const table = await screen.findByRole('table', { name: 'Slower' });
    const row = within(table).getAllByRole('row')[1];
    expect(cells(row)).toEqual([
      '7',
      '5.0',
      'Pass',
      'Pass',
      '4.00 µs',
      '6.00 µs',
      '1.50',
      '0.000068',
      '',
    ]);
    expect(screen.getByText(/2 cases with repeated calls in both results/)).toBeVisible();
  });
});
