import { fireEvent, screen, waitFor, within } from '@testing-library/react';
import { describe, expect, test } from 'vitest';
import { eachWithServer } from './support/eachWithServer';
import type { FakeServer } from './support/FakeServer';
import { openPortal } from './support/openPortal';
import { activity, build } from './support/samples';

let server: FakeServer;

eachWithServer((started) => {
  server = started;
});

function zip(name = 'ir-sensor.zip') {
  return new File(['PK\u0003\u0004'], name, { type: 'application/zip' });
}

describe('the activities', () => {
  test('are listed with their components and test models', async () => {
    server.activities.push(activity('a1'));
    openPortal(server, '/activities');
    const table = await screen.findByRole('table', { name: 'Activities' });
    const [, row] = within(table).getAllByRole('row');
    expect(row).toHaveTextContent('ir-sensor');
    expect(row).toHaveTextContent('org.sitaf.examples.ir.InfraredSensor');
    expect(row).toHaveTextContent('GetInfraredData');
  });

  test('are fetched page by page, with the page in the address', async () => {
    for (let n = 1; n <= 45; n++) server.activities.push(activity(`a${n}`, { name: `no-${n}` }));
    const { user, history } = openPortal(server, '/activities');
    await user.click(await screen.findByRole('button', { name: 'Page 3' }));
    expect(await screen.findByRole('link', { name: 'no-45' })).toBeVisible();
    expect(screen.queryByRole('link', { name: 'no-40' })).toBeNull();
    expect(history.location.search).toBe('?page=3');
  });

  test('are searched, with the text in the address', async () => {
    for (let n = 1; n <= 45; n++) server.activities.push(activity(`a${n}`, { name: `no-${n}` }));
    const { user, history } = openPortal(server, '/activities?page=2');
    await user.type(await screen.findByRole('searchbox', { name: 'Search activities' }), 'no-44');
    expect(await screen.findByRole('link', { name: 'no-44' })).toBeVisible();
    await waitFor(() => {
      expect(history.location.search).toBe('?search=no-44');
    });
    expect(screen.queryByRole('link', { name: 'no-21' })).toBeNull();
    await user.click(screen.getByRole('button', { name: 'Clear the search' }));
    expect(await screen.findByRole('link', { name: 'no-1' })).toBeVisible();
  });

  test('are filtered by a tag, with the tag in the address', async () => {
    server.activities.push(
      activity('a1', { name: 'shoulder', tags: ['arm/left'] }),
      activity('a2', { name: 'wheels', tags: ['base'] }),
    );
    const { user, history } = openPortal(server, '/activities');
    expect(await screen.findByRole('link', { name: 'wheels' })).toBeVisible();
    await user.selectOptions(await screen.findByRole('combobox', { name: 'Tag' }), 'arm/left (1)');
    await waitFor(() => {
      expect(screen.queryByRole('link', { name: 'wheels' })).toBeNull();
    });
    expect(history.location.search).toBe('?tag=arm%2Fleft');
    expect(screen.getByRole('link', { name: 'shoulder' })).toBeVisible();
    await user.selectOptions(screen.getByRole('combobox', { name: 'Tag' }), 'All tags');
    await user.click(await screen.findByRole('link', { name: '#base' }));
    await waitFor(() => {
      expect(history.location.search).toBe('?tag=base');
    });
  });

  test('get tags on their page, and keep what was typed if the server refuses', async () => {
    server.activities.push(activity('a1'));
    const { user } = openPortal(server, '/activities/a1');
    await user.click(await screen.findByRole('button', { name: 'Add tags' }));
    const input = screen.getByRole('combobox', { name: 'Tags' });
    await user.type(input, 'two words{Enter}');
    await user.click(screen.getByRole('button', { name: 'Save tags' }));
    expect(await screen.findByText(/must have 1 to 50 letters/)).toBeVisible();
    await user.type(input, '{Backspace}nightly{Enter}');
    await user.click(screen.getByRole('button', { name: 'Save tags' }));
    expect(await screen.findByRole('link', { name: '#nightly' })).toHaveAttribute(
      'href',
      '/activities?tag=nightly',
    );
    expect(server.activities[0]?.tags).toEqual(['nightly']);
  });

  test('are marked as favourites, which the first page lists', async () => {
    server.activities.push(activity('a1'));
    const { user } = openPortal(server, '/activities');
    await user.click(await screen.findByRole('button', { name: 'Favourite: ir-sensor' }));
    await user.click(screen.getByRole('link', { name: 'SITAF' }));
    const favourites = await screen.findByRole('region', { name: 'Favourites' });
    expect(within(favourites).getByRole('link', { name: 'ir-sensor' })).toHaveAttribute(
      'href',
      '/activities/a1',
    );
    localStorage.clear();
  });

  test('are searched from the list of builds by state, too', async () => {
    server.builds.push(
      build('b1', { activityName: 'arm', state: 'FAILED' }),
      build('b2', { activityName: 'arm', state: 'DONE' }),
      build('b3', { activityName: 'base', state: 'FAILED' }),
    );
    const { user, history } = openPortal(server, '/builds?search=arm');
    expect(await screen.findAllByRole('link', { name: /^arm/ })).toHaveLength(2);
    await user.selectOptions(screen.getByRole('combobox', { name: 'State' }), 'Could not run');
    await waitFor(() => {
      expect(screen.getAllByRole('link', { name: /^arm/ })).toHaveLength(1);
    });
    expect(history.location.search).toBe('?search=arm&state=FAILED');
  });

  test('are created from a selected zip file', async () => {
    const { user } = openPortal(server, '/activities');
    await user.upload(await screen.findByLabelText('Zip file of an activity'), zip());
    expect(await screen.findByRole('table', { name: 'Activities' })).toHaveTextContent('uploaded');
    expect(server.uploads.map((body) => body.toString())).toEqual(['PK\u0003\u0004']);
  });

  test('are created from a dropped zip file', async () => {
    openPortal(server, '/activities');
    const zone = await screen.findByRole('group', { name: 'Upload an activity' });
    fireEvent.drop(zone, { dataTransfer: { files: [zip()] } });
    expect(await screen.findByRole('table', { name: 'Activities' })).toHaveTextContent('uploaded');
  });

  test('refuse several dropped zip files', async () => {
    openPortal(server, '/activities');
    const zone = await screen.findByRole('group', { name: 'Upload an activity' });
    fireEvent.drop(zone, { dataTransfer: { files: [zip('a.zip'), zip('b.zip')] } });
    expect(await screen.findByText(/one zip file at a time/)).toBeVisible();
    expect(server.uploads).toEqual([]);
  });

  test('take further files into a folder, and show the first one', async () => {
    server.activities.push(activity('a1'));
    const { user, history } = openPortal(server, '/activities/a1?tab=files');
    await user.type(await screen.findByLabelText('Folder of added files'), '/world/');
    await user.upload(screen.getByLabelText('Files to add'), [
      new File(['mjcf: arm.xml'], 'arm.world.yaml'),
      new File(['<mujoco/>'], 'arm.xml'),
    ]);
    const files = await screen.findByRole('navigation', { name: 'Files of the activity' });
    expect(await within(files).findByText('world/arm.world.yaml')).toBeVisible();
    expect(within(files).getByText('world/arm.xml')).toBeVisible();
    expect(history.location.search).toBe('?tab=files&file=world%2Farm.world.yaml');
  });

  test('keep their files if they have changed in the meantime', async () => {
    server.activities.push(activity('a1'));
    const { user } = openPortal(server, '/activities/a1?tab=files');
    const input = await screen.findByLabelText('Files to add');
    const [changed] = server.activities;
    if (changed) server.activities[0] = { ...changed, version: 2 };
    await user.upload(input, new File(['x'], 'x.xml'));
    expect(await screen.findByRole('alert', { name: 'The files were not added' })).toBeVisible();
    expect(server.activities[0]?.files.map(({ path }) => path)).not.toContain('x.xml');
  });

  test('lose a file after a second press, but never their profile', async () => {
    server.activities.push(activity('a1'));
    server.files.set('GetInfraredData.xml', '<test_model/>');
    server.files.set('activity.yaml', 'name: ir-sensor');
    const { user, history } = openPortal(
      server,
      '/activities/a1?tab=files&file=GetInfraredData.xml',
    );
    await user.click(await screen.findByRole('button', { name: 'Delete GetInfraredData.xml' }));
    await user.click(screen.getByRole('button', { name: 'Confirm: Delete GetInfraredData.xml' }));
    await waitFor(() => {
      expect(history.location.search).toBe('?tab=files');
    });
    expect(await screen.findByLabelText('Text of activity.yaml')).toBeVisible();
    expect(screen.queryByRole('button', { name: /^Delete/ })).toBeNull();
    expect(server.activities[0]?.files.map(({ path }) => path)).toEqual(['activity.yaml']);
  });

  test('show the problems of a zip file', async () => {
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
    await user.upload(await screen.findByLabelText('Zip file of an activity'), zip());
    const list = await screen.findByRole('list', { name: 'Diagnostics' });
    expect(
      within(list)
        .getAllByRole('listitem')
        .map((item) => item.textContent),
    ).toEqual([
      'GetInfraredData.xml:12: equiv_class: min 7 is greater than max 1',
      'activity.yaml: warning: the world has no parameters',
    ]);
    expect(screen.getByRole('alert', { name: 'ir-sensor.zip was not uploaded' })).toHaveTextContent(
      'The input cannot be used',
    );
  });
});
