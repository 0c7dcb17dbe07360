import { screen, waitFor, within } from '@testing-library/react';
import { describe, expect, test, vi } from 'vitest';
import { eachWithServer } from './support/eachWithServer';
import { LOG_PART, type FakeServer } from './support/FakeServer';
import { openPortal } from './support/openPortal';
import { activity, AGENT, build, doneBuild, resultCases } from './support/samples';

let server: FakeServer;

eachWithServer((started) => {
  server = started;
});

describe('a build', () => {
  test('is built again with the same options', async () => {
    const cases = resultCases(['PASS']);
    server.cases.set('b1', cases);
    const options = { priority: 7, shards: 3, retries: 1, toolchain: '17', labels: ['bench'] };
    server.builds.push({ ...doneBuild('b1', cases), ...options, recordedCases: 'FAILED' });
    const { user, history } = openPortal(server, '/builds/b1');
    await user.click(await screen.findByRole('button', { name: 'Build again' }));
    await screen.findByText('Queued');
    expect(server.buildRequests).toEqual([{ suiteId: 's1', recordings: 'FAILED', ...options }]);
    expect(history.location.pathname).toBe('/builds/b2');
  });

  test('is run again for the cases that did not pass, and for one case', async () => {
    const cases = resultCases(['PASS', 'FAIL', 'ERROR']);
    server.cases.set('b1', cases);
    server.builds.push({ ...doneBuild('b1', cases), priority: 7, shards: 3 });
    const { user, history } = openPortal(server, '/builds/b1');
    await user.click(await screen.findByRole('button', { name: 'Run failed cases again' }));
    await screen.findByText('Queued');
    expect(history.location.pathname).toBe('/builds/b2');
    history.push('/builds/b1?case=2');
    await user.click(await screen.findByRole('button', { name: 'Run case 2 again' }));
    expect(await screen.findByText(/Only case 2\./)).toBeVisible();
    const options = { suiteId: 's1', recordings: 'ALL', priority: 7, retries: 2 };
    expect(server.buildRequests).toEqual([
      { ...options, shards: 3, failedOf: 'b1' },
      { ...options, cases: '2' },
    ]);
  });

  test('of all passed cases offers no failed cases', async () => {
    const cases = resultCases(['PASS']);
    server.cases.set('b1', cases);
    server.builds.push(doneBuild('b1', cases));
    openPortal(server, '/builds/b1');
    await screen.findByRole('button', { name: 'Build again' });
    expect(screen.queryByRole('button', { name: 'Run failed cases again' })).toBeNull();
  });

  test('is scheduled for later with its options', async () => {
    server.activities.push(activity('a1'));
    const { user } = openPortal(server, '/activities/a1');
    await user.click(await screen.findByRole('button', { name: 'Build options' }));
    const priority = await screen.findByLabelText('Priority');
    await user.clear(priority);
    await user.type(priority, '7');
    await user.type(screen.getByLabelText('Agent labels', { selector: 'input' }), 'bench{Enter}');
    await user.keyboard('{Escape}');
    await user.click(screen.getByRole('button', { name: 'Build later' }));
    await user.click(await screen.findByRole('button', { name: 'Create schedule' }));
    await waitFor(() => {
      expect(server.scheduleRequests).toMatchObject([
        { activityId: 'a1', model: 'GetInfraredData', priority: 7, labels: ['bench'] },
      ]);
    });
  });

  test('runs a node with the ROS 2 that an agent has', async () => {
    server.activities.push(activity('a1'));
    server.agents = [{ ...AGENT, toolchains: [{ language: 'ros', version: 'jazzy' }] }];
    const { user } = openPortal(server, '/activities/a1');
    await user.click(await screen.findByRole('button', { name: 'Build options' }));
    await user.click(await screen.findByLabelText('Installed ROS 2'));
    await user.keyboard('{Escape}');
    await screen.findByRole('button', { name: 'Options: installed ROS 2' });
    await user.click(screen.getByRole('button', { name: 'Build later' }));
    await user.click(await screen.findByRole('button', { name: 'Create schedule' }));
    await waitFor(() => {
      expect(server.scheduleRequests).toMatchObject([{ activityId: 'a1', ros: 'SYSTEM' }]);
    });
  });

  test('offers no installed ROS 2 where no agent has one', async () => {
    server.activities.push(activity('a1'));
    const { user } = openPortal(server, '/activities/a1');
    await user.click(await screen.findByRole('button', { name: 'Build options' }));
    await screen.findByLabelText('Explain failures');
    expect(screen.queryByLabelText('Installed ROS 2')).toBeNull();
  });

  test('is scheduled for later with its test cases', async () => {
    server.activities.push(activity('a1'));
    const { user } = openPortal(server, '/activities/a1');
    await user.selectOptions(await screen.findByLabelText('Invalid values'), 'combine');
    await user.click(screen.getByRole('button', { name: 'Build later' }));
    await user.click(await screen.findByRole('button', { name: 'Create schedule' }));
    await waitFor(() => {
      expect(server.scheduleRequests).toMatchObject([{ suiteId: 's1' }]);
    });
    expect(server.suiteOptions).toEqual([{ invalidValues: 'combine' }]);
  });

  test('has a log that is downloaded completely', async () => {
    server.builds.push(build('b1', { state: 'FAILED' }));
    const log = 'ä line of the log\n'.repeat(LOG_PART / 4);
    server.logs.set('b1', log);
    const saved: Blob[] = [];
    vi.stubGlobal(
      'URL',
      class extends URL {
        static override createObjectURL = (blob: Blob) => {
          saved.push(blob);
          return '#log';
        };
        static override revokeObjectURL = () => undefined;
      },
    );
    const { user } = openPortal(server, '/builds/b1');
    await user.click(await screen.findByRole('button', { name: 'Download' }));
    await waitFor(() => {
      expect(saved).toHaveLength(1);
    });
    expect(await textOf(saved[0])).toBe(log);
    vi.unstubAllGlobals();
  });

  test('says how long its other cases will take', async () => {
    const minuteAgo = new Date(Date.now() - 60_000).toISOString();
    server.builds.push(
      build('b1', { state: 'RUNNING', started: minuteAgo, casesDone: 10, casesTotal: 55 }),
    );
    openPortal(server, '/builds/b1');
    expect(await screen.findByText(/^10 of 55 cases, about (4|5) min left$/)).toBeVisible();
  });

  test('is started from an activity, shown live, and ends with the table of its result', async () => {
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

  test('is generated with the selected treatment of invalid values', async () => {
    server.activities.push(activity('a1'));
    const { user } = openPortal(server, '/activities/a1');
    await user.selectOptions(await screen.findByLabelText('Invalid values'), 'combine');
    await user.click(screen.getByRole('button', { name: 'Build now' }));
    await screen.findByText('Queued');
    expect(server.suiteOptions).toEqual([{ invalidValues: 'combine' }]);
  });

  test('sends the option for recordings', async () => {
    server.activities.push(activity('a1'));
    const { user } = openPortal(server, '/activities/a1');
    await user.click(await screen.findByRole('button', { name: 'Build options' }));
    const recordings = await screen.findByLabelText('3D recordings');
    expect(recordings).toHaveDisplayValue('Default: all cases if there are at most 100');
    expect(recordings).toHaveAccessibleDescription(/milliseconds/);
    await user.selectOptions(recordings, 'failed cases and errors');
    await user.keyboard('{Escape}');
    expect(
      await screen.findByRole('button', { name: 'Options: failing cases recorded' }),
    ).toBeVisible();
    await user.click(screen.getByRole('button', { name: 'Build now' }));
    await screen.findByText('Queued');
    expect(server.buildRequests).toEqual([{ suiteId: 's1', recordings: 'FAILED' }]);
  });

  test('that does not compile shows the file and the line', async () => {
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

  test('with suspicions has not passed, and shows the reasons', async () => {
    const cases = resultCases(['PASS', 'PASS']);
    server.cases.set('b1', cases);
    const suspicions = ['a line without number and token (3 times)'];
    server.builds.push({ ...doneBuild('b1', cases), suspicions });
    openPortal(server, '/builds/b1');
    expect(await screen.findByText('Suspect')).toBeVisible();
    expect(
      await screen.findByRole('alert', { name: 'Suspect: the verdicts cannot be trusted' }),
    ).toHaveTextContent('a line without number and token (3 times)');
    expect(screen.queryByText('All passed')).toBeNull();
  });

  test('with suspicions is marked in the list', async () => {
    const cases = resultCases(['PASS']);
    server.builds.push({ ...doneBuild('b1', cases), suspicions: ['a torn line'] });
    openPortal(server);
    expect(await screen.findAllByText('Suspect')).not.toHaveLength(0);
    expect(screen.queryByText('All passed')).toBeNull();
  });

  test('can be cancelled', async () => {
    server.builds.push(build('b1', { state: 'RUNNING' }));
    const { user } = openPortal(server, '/builds/b1');
    await user.click(await screen.findByRole('button', { name: 'Cancel' }));
    expect(await screen.findByText('Cancelled')).toBeVisible();
  });

  test('that does not exist is reported', async () => {
    openPortal(server, '/builds/none');
    expect(await screen.findByRole('heading', { name: 'Page not found' })).toBeVisible();
  });
});

test('a waiting build shows the reason', async () => {
  server.builds.push(build('b1', { waitingFor: 'no agent offers java' }));
  openPortal(server, '/builds/b1');
  expect(await screen.findByText('no agent offers java')).toBeVisible();
});

test('without an agent the portal reports that builds wait', async () => {
  server.agents = [];
  openPortal(server);
  expect(await screen.findByText('No agent online: builds wait')).toBeVisible();
});

test('without builds the home page leads to the activities', async () => {
  openPortal(server);
  const builds = await screen.findByText(/No builds yet\. Open an/);
  expect(within(builds).getByRole('link', { name: 'activity' })).toHaveAttribute(
    'href',
    '/activities',
  );
});

async function textOf(blob: Blob | undefined): Promise<string> {
  return new TextDecoder().decode(await blob?.arrayBuffer());
}
