import { screen, waitFor } from '@testing-library/react';
import { describe, expect, test } from 'vitest';
import { eachWithServer } from './support/eachWithServer';
import type { FakeServer } from './support/FakeServer';
import { openPortal } from './support/openPortal';
import { activity, build, doneBuild, resultCases } from './support/samples';

let server: FakeServer;

eachWithServer((started) => {
  server = started;
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

  test('is recorded as was asked for, and as the server has it where nobody asked', async () => {
    server.activities.push(activity('a1'));
    const { user } = openPortal(server, '/activities/a1');
    await user.click(await screen.findByRole('button', { name: 'Agent, priority, recordings' }));
    const recordings = await screen.findByLabelText('Recordings to see in 3D');
    expect(recordings).toHaveDisplayValue('by default: all of up to 100 cases, none of more');
    expect(recordings).toHaveAccessibleDescription(/some milliseconds/);
    await user.selectOptions(recordings, 'cases that fail or end in an error');
    await user.keyboard('{Escape}');
    expect(
      await screen.findByRole('button', { name: 'With failing cases recorded' }),
    ).toBeVisible();
    await user.click(screen.getByRole('button', { name: 'Build now' }));
    await screen.findByText('Queued');
    expect(server.buildRequests).toEqual([{ suiteId: 's1', recordings: 'FAILED' }]);
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

  test('whose results cannot be trusted has not passed, and says why', async () => {
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

  test('whose results cannot be trusted is marked in the list, and its activity as failing', async () => {
    const cases = resultCases(['PASS']);
    server.builds.push({ ...doneBuild('b1', cases), suspicions: ['a torn line'] });
    openPortal(server);
    expect(await screen.findAllByText('Suspect')).not.toHaveLength(0);
    expect(screen.queryByText('All passed')).toBeNull();
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
