import { screen } from '@testing-library/react';
import { describe, expect, test } from 'vitest';
import { eachWithServer } from './support/eachWithServer';
import type { FakeServer } from './support/FakeServer';
import { openPortal } from './support/openPortal';
import { activity, build } from './support/samples';

let server: FakeServer;

eachWithServer((started) => {
  server = started;
});

describe('a lost connection', () => {
  test('is reported, keeps the page, and is restored automatically', async () => {
    server.activities.push(activity('a1'));
    openPortal(server, '/activities');
    await screen.findByRole('link', { name: 'ir-sensor' });

    await server.stop();
    expect(await screen.findByText(/No connection to the server/)).toBeVisible();
    expect(screen.getByRole('link', { name: 'ir-sensor' })).toBeVisible();

    server.activities.push(activity('a2', { name: 'created-later' }));
    await server.start();
    expect(await screen.findByRole('link', { name: 'created-later' })).toBeVisible();
    expect(screen.queryByText(/No connection to the server/)).toBeNull();
  });

  test('is restored on a page that was not loaded', async () => {
    await server.stop();
    server.builds.push(build('b1', { state: 'RUNNING' }));
    openPortal(server, '/builds/b1');
    await screen.findByText(/No connection to the server/);
    await server.start();
    expect(await screen.findByText('Running')).toBeVisible();
  });
});
