import { fireEvent, screen, within } from '@testing-library/react';
import { expect, test, vi } from 'vitest';
import { eachWithServer } from './support/eachWithServer';
import type { FakeServer } from './support/FakeServer';
import { recordingGlb } from './support/glb';
import { openPortal } from './support/openPortal';
import { caseSignals, doneBuild, resultCase, TRAJECTORIES } from './support/samples';

let server: FakeServer;

eachWithServer((started) => {
  server = started;
});

function addCase(recorded: boolean) {
  const cases = [resultCase(1, 'FAIL', { message: 'touched', trajectories: TRAJECTORIES })];
  server.builds.push(doneBuild('b1', cases));
  server.cases.set('b1', cases);
  server.signals.set('b1 1', caseSignals());
  if (recorded) server.recordings.set('b1 1', recordingGlb());
}

test('the plot shows the violated condition and moves the replay', async () => {
  addCase(true);
  const { user } = openPortal(server, '/builds/b1/cases/1');
  const plot = await screen.findByRole('group', { name: 'Signals over time' });
  await user.click(screen.getByRole('button', { name: /Pause|Play/ }));
  expect(within(plot).getByText(/is violated at 0.5 s, margin -1/)).toBeVisible();
  expect(within(plot).getByRole('img', { name: 'bumped over time' })).toBeInTheDocument();
  expect(within(plot).getByText(/5 of 3,000 samples are shown/)).toBeVisible();
  expect(screen.getByTestId('moment')).toHaveStyle({ left: `${(100 * 1) / 1.5}%` });
  expect(screen.getByTestId('interval')).toHaveStyle({ left: '50%' });

  await user.click(within(plot).getByRole('button', { name: 'Go to 0.5 s' }));
  expect(screen.getByTestId('clock')).toHaveTextContent('0.50 of 1.00 s');
  expect(screen.getByTestId('playhead')).toHaveStyle({ left: `${(100 * 1) / 1.5}%` });
  expect(within(plot).getByLabelText('Signals at this time')).toHaveTextContent('bumped1');

  const slider = within(plot).getByRole('slider', { name: 'Time in the plot' });
  slider.focus();
  await user.keyboard('{End}');
  expect(screen.getByTestId('clock')).toHaveTextContent('1.00 of 1.00 s');
  vi.spyOn(slider, 'getBoundingClientRect').mockReturnValue(new DOMRect(100, 0, 300, 100));
  slider.setPointerCapture = () => {};
  fireEvent.pointerDown(slider, { clientX: 250, pointerId: 1 });
  expect(screen.getByTestId('clock')).toHaveTextContent('0.25 of 1.00 s');

  await user.selectOptions(within(plot).getByLabelText('Condition over time'), 'stops');
  expect(within(plot).getByText(/holds, decided at 1 s, margin 0/)).toBeVisible();
  expect(
    within(plot).getByRole('img', { name: 'base.linear.command over time' }),
  ).toBeInTheDocument();
});

test('the replay moves the playhead', async () => {
  addCase(true);
  const { user } = openPortal(server, '/builds/b1/cases/1?at=0.5&condition=never%20touches');
  expect(await screen.findByTestId('clock')).toHaveTextContent('0.50 of 1.00 s');
  await user.click(screen.getByRole('button', { name: 'Next frame' }));
  expect(screen.getByTestId('playhead')).toHaveStyle({ left: '100%' });
});

test('without a recording the plot is shown alone', async () => {
  addCase(false);
  const { user } = openPortal(server, '/builds/b1/cases/1');
  const plot = await screen.findByRole('group', { name: 'Signals over time' });
  expect(screen.getByText(/There is no recording of this case/)).toBeVisible();
  const slider = within(plot).getByRole('slider', { name: 'Time in the plot' });
  expect(slider).toHaveAttribute('aria-valuetext', '0.500 s');
  slider.focus();
  await user.keyboard('{Home}');
  expect(slider).toHaveAttribute('aria-valuetext', '-0.500 s');
});

test('the details of a case link to the moment of the violation', async () => {
  addCase(true);
  openPortal(server, '/builds/b1?case=1');
  const link = await screen.findByRole('link', { name: 'Show the violation of never touches' });
  expect(link).toHaveAttribute('href', '/builds/b1/cases/1?condition=never+touches&at=0.5');
  expect(screen.queryByRole('link', { name: 'Show the violation of stops' })).toBeNull();
});
