import { fireEvent, screen, waitFor, within } from '@testing-library/react';
import { afterEach, beforeEach, describe, expect, test } from 'vitest';
import { FakeServer } from './support/FakeServer';
import { openPortal } from './support/openPortal';
import { activity, build, doneBuild, resultCase, resultCases, suiteCases } from './support/samples';

let server: FakeServer;

beforeEach(async () => {
  server = new FakeServer();
  await server.start();
});

afterEach(async () => {
  await server.stop();
});

function zip(name = 'ir-sensor.zip') {
  return new File(['PK\u0003\u0004'], name, { type: 'application/zip' });
}

describe('the activities', () => {
  test('are listed with their component and their test models', async () => {
    server.activities.push(activity('a1'));
    openPortal(server, '/activities');
    const table = await screen.findByRole('table', { name: 'Activities' });
    const [, row] = within(table).getAllByRole('row');
    expect(row).toHaveTextContent('ir-sensor');
    expect(row).toHaveTextContent('org.sitaf.examples.ir.InfraredSensor');
    expect(row).toHaveTextContent('GetInfraredData');
  });

  test('are fetched a page at a time, and the address says which', async () => {
    for (let n = 1; n <= 45; n++) server.activities.push(activity(`a${n}`, { name: `no-${n}` }));
    const { user, history } = openPortal(server, '/activities');
    await user.click(await screen.findByRole('button', { name: 'Page 3' }));
    expect(await screen.findByRole('link', { name: 'no-45' })).toBeVisible();
    expect(screen.queryByRole('link', { name: 'no-40' })).toBeNull();
    expect(history.location.search).toBe('?page=3');
  });

  test('take a zip by button, byte for byte', async () => {
    const { user } = openPortal(server, '/activities');
    await user.upload(await screen.findByLabelText('Zip of an activity'), zip());
    expect(await screen.findByRole('table', { name: 'Activities' })).toHaveTextContent('uploaded');
    expect(server.uploads.map((body) => body.toString())).toEqual(['PK\u0003\u0004']);
  });

  test('take a zip by drag and drop', async () => {
    openPortal(server, '/activities');
    const zone = await screen.findByRole('group', { name: 'Upload an activity' });
    fireEvent.drop(zone, { dataTransfer: { files: [zip()] } });
    expect(await screen.findByRole('table', { name: 'Activities' })).toHaveTextContent('uploaded');
  });

  test('refuse several zips dropped at once', async () => {
    openPortal(server, '/activities');
    const zone = await screen.findByRole('group', { name: 'Upload an activity' });
    fireEvent.drop(zone, { dataTransfer: { files: [zip('a.zip'), zip('b.zip')] } });
    expect(await screen.findByText(/One zip at a time/)).toBeVisible();
    expect(server.uploads).toEqual([]);
  });

  test('show what is wrong with a zip as file, line and message', async () => {
    server.refusal = [
      {
        severity: 'ERROR',
        file: 'GetInfraredData.xml',
        line: 12,
        element: 'equiv_class',
        message: 'min 7 is greater than max 1',
      },
      {
        severity: 'WARNING',
        file: 'activity.yaml',
        line: 0,
        element: '',
        message: 'the world has no parameters',
      },
    ];
    const { user } = openPortal(server, '/activities');
    await user.upload(await screen.findByLabelText('Zip of an activity'), zip());
    const list = await screen.findByRole('list', { name: 'Diagnostics' });
    expect(
      within(list)
        .getAllByRole('listitem')
        .map((item) => item.textContent),
    ).toEqual([
      'GetInfraredData.xml:12: equiv_class: min 7 is greater than max 1',
      'activity.yaml: warning: the world has no parameters',
    ]);
    expect(screen.getByRole('alert', { name: 'ir-sensor.zip was not taken' })).toHaveTextContent(
      'The input cannot be used',
    );
  });
});

describe('a build', () => {
  test('is started from an activity, followed live, and ends in the table of its result', async () => {
    server.activities.push(activity('a1'));
    const { user, history } = openPortal(server, '/activities');

    await user.click(await screen.findByRole('button', { name: /Build now: ir-sensor/ }));
    expect(await screen.findByText('Queued')).toBeVisible();
    expect(history.location.pathname).toBe('/builds/b1');
    expect(server.suiteOptions).toEqual([{}]);

    server.advance('b1', { state: 'RUNNING', casesDone: 20, agent: 'bench-1' });
    expect(await screen.findByText('Running')).toBeVisible();
    expect(screen.getByText('20 of 55 cases')).toBeVisible();
    server.liveCases.set('b1', resultCases(['PASS', 'FAIL']));
    const growing = await screen.findByRole('table', { name: 'Cases' });
    expect(growing).toHaveAttribute('aria-rowcount', String(2 + 2));
    server.liveCases.set('b1', resultCases(['PASS', 'FAIL', 'ERROR']));
    expect(await screen.findByText('Error')).toBeVisible();

    const cases = resultCases([...Array<'PASS'>(55).fill('PASS')]);
    server.cases.set('b1', cases);
    server.advance('b1', doneBuild('b1', cases));
    expect(await screen.findByText('All passed')).toBeVisible();
    await waitFor(() => {
      expect(screen.getByRole('table', { name: 'Cases' })).toHaveAttribute(
        'aria-rowcount',
        String(2 + 55),
      );
    });
  });

  test('is generated with the choice of invalid values', async () => {
    server.activities.push(activity('a1'));
    const { user } = openPortal(server, '/activities/a1');
    await user.selectOptions(await screen.findByLabelText('Invalid values'), 'combine');
    await user.click(screen.getByRole('button', { name: 'Build now' }));
    await screen.findByText('Queued');
    expect(server.suiteOptions).toEqual([{ invalidValues: 'combine' }]);
  });

  test('that does not compile shows the file and the line, and not a failed test', async () => {
    server.builds.push(
      build('b1', {
        state: 'FAILED',
        failure: {
          category: 'COMPILATION',
          message: 'The component does not compile.',
          diagnostics: [
            {
              file: 'component/InfraredSensor.java',
              line: 31,
              column: 4,
              generated: false,
              message: "';' expected",
            },
          ],
        },
      }),
    );
    openPortal(server, '/builds/b1');
    expect(
      await screen.findByRole('alert', { name: 'Could not run: compilation' }),
    ).toHaveTextContent("component/InfraredSensor.java:31: ';' expected");
    expect(screen.getByText('Could not run')).toBeVisible();
    expect(screen.queryByText('Cases failed')).toBeNull();
  });

  test('is cancelled on demand', async () => {
    server.builds.push(build('b1', { state: 'RUNNING' }));
    const { user } = openPortal(server, '/builds/b1');
    await user.click(await screen.findByRole('button', { name: 'Cancel' }));
    expect(await screen.findByText('Cancelled')).toBeVisible();
  });

  test('that does not exist is said to be no page', async () => {
    openPortal(server, '/builds/none');
    expect(await screen.findByRole('heading', { name: 'No such page' })).toBeVisible();
  });
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

describe('the grid of cases', () => {
  test('stores what is typed onto the version that was seen', async () => {
    server.suiteCases = suiteCases(55);
    const { user } = openPortal(server, '/suites/s1');
    const cell = await screen.findByLabelText('Expected return of case 3');
    await user.clear(cell);
    await user.type(cell, '7.5{Enter}');
    await screen.findByText(/all stored/);
    expect(server.suiteEdits).toEqual([{ ifMatch: '"1"', changes: [{ no: 3, literal: '7.5' }] }]);
    expect(screen.getByLabelText('Expected return of case 3')).toHaveValue('7.5');
  });

  test('takes the rows of a spreadsheet from the cell on', async () => {
    server.suiteCases = suiteCases(55);
    const { user } = openPortal(server, '/suites/s1');
    await user.click(await screen.findByLabelText('Expected return of case 2'));
    await user.paste('1.0\r\n2.0\r\n3.0\r\n');
    await waitFor(() => {
      expect(server.suiteEdits.map(({ changes }) => changes)).toEqual([
        [
          { no: 2, literal: '1.0' },
          { no: 3, literal: '2.0' },
          { no: 4, literal: '3.0' },
        ],
      ]);
    });
  });

  test('says that somebody else changed the suite, and overwrites nothing', async () => {
    server.suiteCases = suiteCases(5);
    const { user } = openPortal(server, '/suites/s1');
    const cell = await screen.findByLabelText('Expected return of case 1');
    server.suiteVersion = 9;
    await user.clear(cell);
    await user.type(cell, '7.5{Enter}');
    expect(
      await screen.findByRole('alert', { name: 'Somebody else changed this suite' }),
    ).toBeVisible();
    expect(server.suiteEdits).toEqual([]);
    expect(screen.getByLabelText('Expected return of case 1')).toHaveValue('7.5');
    await user.click(screen.getByRole('button', { name: 'Put mine onto theirs' }));
    await waitFor(() => {
      expect(server.suiteEdits).toEqual([{ ifMatch: '"9"', changes: [{ no: 1, literal: '7.5' }] }]);
    });
  });
});

describe('a new schedule', () => {
  test('shows its next ten times in words while it is written', async () => {
    const { user } = openPortal(server, '/schedules/new?suite=s1');
    const list = await screen.findByRole('list', { name: 'Next times' });
    expect(within(list).getAllByRole('listitem')).toHaveLength(10);
    expect(list).toHaveTextContent(/Tuesday,? 10 March 2099 at /);
    const cron = screen.getByLabelText(/^Cron expression/);
    await user.clear(cron);
    await user.type(cron, 'soon');
    expect(await screen.findByRole('alert', { name: 'No such times' })).toHaveTextContent(
      'is no cron expression',
    );
  });
});

describe('a lost connection', () => {
  test('is shown, keeps what was on the page, and heals by itself', async () => {
    server.activities.push(activity('a1'));
    openPortal(server, '/activities');
    await screen.findByRole('link', { name: 'ir-sensor' });

    await server.stop();
    expect(await screen.findByText(/No connection to the server/)).toBeVisible();
    expect(screen.getByRole('link', { name: 'ir-sensor' })).toBeVisible();

    server.activities.push(activity('a2', { name: 'created-meanwhile' }));
    await server.start();
    expect(await screen.findByRole('link', { name: 'created-meanwhile' })).toBeVisible();
    expect(screen.queryByText(/No connection to the server/)).toBeNull();
  });

  test('is healed on a page that had not loaded', async () => {
    await server.stop();
    server.builds.push(build('b1', { state: 'RUNNING' }));
    openPortal(server, '/builds/b1');
    await screen.findByText(/No connection to the server/);
    await server.start();
    expect(await screen.findByText('Running')).toBeVisible();
  });
});

test('a build that waits says why', async () => {
  server.builds.push(build('b1', { waitingFor: 'no agent offers java' }));
  openPortal(server, '/builds/b1');
  expect(await screen.findByText('no agent offers java')).toBeVisible();
});

test('without an agent the portal says that builds wait', async () => {
  server.agents = [];
  openPortal(server);
  expect(await screen.findByText('No agent online: builds wait')).toBeVisible();
});

function cells(row: HTMLElement | undefined): (string | null)[] {
  return [...(row?.children ?? [])].map((cell) => cell.textContent);
}
