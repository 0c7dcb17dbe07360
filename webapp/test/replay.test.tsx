import { screen, within } from '@testing-library/react';
import { expect, test } from 'vitest';
import { eachWithServer } from './support/eachWithServer';
import type { FakeServer } from './support/FakeServer';
import { recordingGlb } from './support/glb';
import { openPortal } from './support/openPortal';
import { build, doneBuild, resultCase, resultCases } from './support/samples';

let server: FakeServer;

eachWithServer((started) => {
  server = started;
});

function addDone(recorded: number[]) {
  const cases = [
    ...resultCases(['PASS', 'PASS', 'PASS']),
    resultCase(4, 'FAIL', { message: 'too short' }),
  ];
  server.builds.push(doneBuild('b1', cases));
  server.cases.set('b1', cases);
  for (const no of recorded) server.recordings.set(`b1 ${no}`, recordingGlb());
}

test('without WebGL the replay shows the readings over time', async () => {
  addDone([2, 4]);
  const { user } = openPortal(server, '/builds/b1/cases/4');
  expect(await screen.findByText(/WebGL is not available/)).toBeVisible();
  expect(await screen.findByRole('heading', { name: 'Result: Fail' })).toBeVisible();
  expect(screen.getByText('too short')).toBeVisible();

  const readings = screen.getByLabelText('Current readings');
  await user.click(screen.getByRole('button', { name: /Pause|Play/ }));
  screen.getByRole('group', { name: 'Replay' }).focus();
  const slider = screen.getByRole('slider', { name: 'Time' });
  slider.focus();
  await user.keyboard('{Home}');
  expect(readings).toHaveTextContent('front.range2');
  await user.click(screen.getByRole('button', { name: 'Next frame' }));
  expect(readings).toHaveTextContent('front.range1.5');
  expect(screen.getByTestId('clock')).toHaveTextContent('0.50 of 1.00 s');
  await user.keyboard('{Tab}');
  await user.click(screen.getByRole('button', { name: 'Next frame' }));
  expect(readings).toHaveTextContent('front.range1');
  await user.click(screen.getByRole('button', { name: 'Previous frame' }));
  expect(readings).toHaveTextContent('front.range1.5');

  const table = screen.getByRole('table', { name: 'Readings over time', hidden: true });
  expect(within(table).getAllByRole('row', { hidden: true })).toHaveLength(4);
  expect(screen.getByRole('link', { name: '← Case 2' })).toHaveAttribute(
    'href',
    '/builds/b1/cases/2',
  );
});

test('a case without a recording shows the reason, and can be recorded', async () => {
  addDone([]);
  const { user, history } = openPortal(server, '/builds/b1/cases/1');
  expect(await screen.findByText(/There is no recording of this case/)).toBeVisible();
  await user.click(screen.getByRole('button', { name: 'Build again, record all cases' }));
  await screen.findByRole('tab', { name: 'Log' });
  expect(history.location.pathname).toBe('/builds/b2');
});

test('the live view waits for the first case and plays it', async () => {
  server.builds.push(build('b1', { state: 'RUNNING' }));
  openPortal(server, '/builds/b1/live');
  expect(await screen.findByText('Waiting for the first case to end.')).toBeVisible();
  server.recordings.set('b1 3', recordingGlb());
  expect(await screen.findByText(/1 recorded case/)).toBeVisible();
  expect(screen.getByRole('link', { name: '3' })).toHaveAttribute('href', '/builds/b1/cases/3');
  expect(await screen.findByRole('group', { name: 'Replay' })).toBeVisible();
});
