import { screen, waitFor, within } from '@testing-library/react';
import { describe, expect, test } from 'vitest';
import { eachWithServer } from './support/eachWithServer';
import type { FakeServer } from './support/FakeServer';
import { openPortal } from './support/openPortal';

let server: FakeServer;

eachWithServer((started) => {
  server = started;
});

describe('a new schedule', () => {
  test('shows its next ten times', async () => {
    const { user } = openPortal(server, '/schedules/new?suite=s1');
    const list = await screen.findByRole('list', { name: 'Next times' });
    expect(within(list).getAllByRole('listitem')).toHaveLength(10);
    expect(list).toHaveTextContent(/Tuesday,? 10 March 2099 at /);
    const cron = screen.getByLabelText(/^Cron expression/);
    await user.clear(cron);
    await user.type(cron, 'soon');
    expect(await screen.findByRole('alert', { name: 'Invalid time' })).toHaveTextContent(
      'is not a cron expression',
    );
  });
  test('sends the option for recordings', async () => {
    const { user } = openPortal(server, '/schedules/new?suite=s1');
    await user.click(await screen.findByRole('button', { name: 'Build options' }));
    await user.selectOptions(await screen.findByLabelText('3D recordings'), 'none');
    await user.keyboard('{Escape}');
    await user.click(screen.getByRole('button', { name: 'Create schedule' }));
    await waitFor(() => {
      expect(server.scheduleRequests).toMatchObject([{ suiteId: 's1', recordings: 'NONE' }]);
    });
  });
});
