import { screen, waitFor, within } from '@testing-library/react';
import { describe, expect, test } from 'vitest';
import { eachWithServer } from './support/eachWithServer';
import type { FakeServer } from './support/FakeServer';
import { openPortal } from './support/openPortal';
import { doneBuild, resultCase, resultCases } from './support/samples';

let server: FakeServer;

eachWithServer((started) => {
  server = started;
});

describe('a result', () => {
  test('shows the columns of Fig. 17(a) in order, inputs grouped by kind', async () => {
    const cases = [resultCase(1, 'PASS')];
    server.cases.set('b1', cases);
    server.builds.push(doneBuild('b1', cases));
    openPortal(server, '/builds/b1');
    const table = await screen.findByRole('table', { name: 'Cases' });
    const [groups, names, first] = within(table).getAllByRole('row');
    expect(cells(groups)).toEqual([
      'No',
      'Input (TDI)',
      'Simulation (TDSD)',
      'ER',
      'MR',
      'MR − ER',
      'PF',
      'Time (µs)',
      'Message',
    ]);
    expect(cells(names)).toEqual(['IndexOfSensor', 'NumOfSensor', 'Distance']);
    expect(cells(first)).toEqual(['1', '2', '4', '5.0', '5.0', '5.0', '', '✓ Pass', '4.250', '']);
  });

  test('sums up its verdicts and the processing time', async () => {
    const cases = resultCases(['PASS', 'PASS', 'FAIL', 'ERROR', 'DONT']);
    server.cases.set('b1', cases);
    server.builds.push(doneBuild('b1', cases));
    openPortal(server, '/builds/b1');
    await screen.findByText('Std deviation (µs)');
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
      'Min (µs)': '4.250',
      'Max (µs)': '4.750',
      'Average (µs)': '4.500',
      'Std deviation (µs)': '0.250',
    });
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

  test('shows a case whole by its address, with what it printed as text', async () => {
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
    const nothing = await screen.findByText('It printed nothing.');
    // The drawer slides in.
    await waitFor(() => {
      expect(nothing).toBeVisible();
    });
    expect(history.location.search).toBe('?case=1');
  });

  test('says which lines of the component were not reached', async () => {
    const cases = resultCases(['PASS']);
    server.cases.set('b1', cases);
    server.builds.push(doneBuild('b1', cases));
    openPortal(server, '/builds/b1?tab=coverage');
    expect(await screen.findByText('Not reached: line 4.')).toBeVisible();
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
