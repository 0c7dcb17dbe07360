import { screen, waitFor, within } from '@testing-library/react';
import { unzipSync, zipSync } from 'fflate';
import { describe, expect, test } from 'vitest';
import {
  fileOf,
  folderOf,
  NEW_COMPONENT,
  NEW_PACKAGE,
  requestOfComponent,
  withoutHidden,
} from '@/features/wizard/proposal';
import { eachWithServer } from './support/eachWithServer';
import type { FakeServer } from './support/FakeServer';
import { openPortal } from './support/openPortal';

let server: FakeServer;

eachWithServer((started) => {
  server = started;
});

function file(name: string, content: string | Uint8Array<ArrayBuffer>): File {
  return new File([content], name);
}

function bytes(text: string): Uint8Array<ArrayBuffer> {
  return new TextEncoder().encode(text);
}

function filesOf(...paths: string[]) {
  return new Map(paths.map((path) => [path, bytes('')]));
}

const ARCHIVE = zipSync({ 'activity.yaml': bytes('name: arm') });

function proposed(...files: { path: string; given: boolean }[]) {
  return {
    notes: ['Say of Arm is left out'],
    files: files.map((known) => ({ ...known, size: 1 })),
    archive: Buffer.from(ARCHIVE).toString('base64'),
  };
}

describe('a new component', () => {
  test('is proposed from its interface and created', async () => {
    server.proposedActivity = proposed(
      { path: 'Arm.idl', given: true },
      { path: 'Move.xml', given: false },
      { path: 'component/arm.py', given: false },
    );
    const { user, history } = openPortal(server, '/activities/new');
    expect(await screen.findByRole('radio', { name: 'A new component' })).toBeChecked();
    const propose = screen.getByRole('button', { name: 'Propose activity' });
    await user.type(screen.getByLabelText(/Name of the activity/), 'arm');
    expect(propose).toBeDisabled();
    await user.upload(screen.getByLabelText('Files: Interface files'), [
      file('types.idl', 'struct Point { double x; };'),
      file('Arm.idl', 'interface Arm {};'),
    ]);
    await user.selectOptions(await screen.findByLabelText('Interface of the component'), 'Arm.idl');
    await user.selectOptions(screen.getByLabelText('Language of the component'), 'cpp');
    await user.type(screen.getByLabelText('Component class'), 'own::Arm{Enter}');

    expect(await screen.findByRole('list', { name: '2 proposed files' })).toHaveTextContent(
      'Move.xmlcomponent/arm.py',
    );
    expect(screen.getByRole('list', { name: '1 file taken over' })).toHaveTextContent('Arm.idl');
    expect(screen.getByRole('list', { name: 'To decide' })).toHaveTextContent(
      /skeleton.*Say of Arm is left out/,
    );
    expect(server.proposals.map(({ query }) => query)).toEqual([
      { name: 'arm', language: 'cpp', interface: 'Arm.idl', class: 'own::Arm' },
    ]);
    expect(Object.keys(unzipSync(new Uint8Array(server.proposals[0]?.zip ?? [])))).toEqual([
      'types.idl',
      'Arm.idl',
    ]);
    expect(server.uploads).toEqual([]);
    await user.click(screen.getByRole('button', { name: 'Create activity' }));
    await waitFor(() => {
      expect(history.location.pathname).toBe('/activities/a1');
    });
    expect(new Uint8Array(server.uploads[0] ?? [])).toEqual(new Uint8Array(ARCHIVE));
  });

  test('needs no files for an interface of ROS 2, and for a small one', async () => {
    const { user } = openPortal(server, '/activities/new');
    await user.type(await screen.findByLabelText(/Name of the activity/), 'spin');
    await user.click(screen.getByRole('radio', { name: 'ROS 2' }));
    await user.type(screen.getByLabelText(/Interface of ROS 2/), 'nav_msgs/srv/GetPlan.srv');
    await user.click(screen.getByRole('button', { name: 'Propose activity' }));
    await screen.findByRole('region', { name: 'Proposed activity' });
    await user.click(screen.getByRole('radio', { name: 'Small example' }));
    // The proposal was for another interface.
    expect(screen.queryByRole('region', { name: 'Proposed activity' })).toBeNull();
    await user.click(screen.getByRole('button', { name: 'Propose activity' }));
    await screen.findByRole('region', { name: 'Proposed activity' });
    expect(server.proposals.map(({ query, zip }) => [query.interface, zip.length])).toEqual([
      ['nav_msgs/srv/GetPlan.srv', 0],
      [undefined, 0],
    ]);
  });

  test('keeps what was typed while another beginning is looked at', async () => {
    const { user } = openPortal(server, '/activities/new');
    await user.type(await screen.findByLabelText(/Name of the activity/), 'arm');
    await user.click(screen.getByRole('radio', { name: 'A ROS 2 package' }));
    expect(screen.getByLabelText(/Name of the activity/)).toHaveValue('');
    await user.click(screen.getByRole('radio', { name: 'A new component' }));
    expect(screen.getByLabelText(/Name of the activity/)).toHaveValue('arm');
  });
});

describe('a ROS 2 package', () => {
  test('with several nodes lets the user choose one', async () => {
    server.nodes = ['pkg.talker:main', 'pkg.listener:main'];
    server.proposedActivity = proposed({ path: 'Topics.xml', given: false });
    const { user } = openPortal(server, '/activities/new');
    await user.click(await screen.findByRole('radio', { name: 'A ROS 2 package' }));
    await user.type(screen.getByLabelText(/Name of the activity/), 'node');
    await user.upload(
      screen.getByLabelText('Files: ROS 2 package'),
      file('pkg.zip', zipSync({ 'pkg/package.xml': bytes('<package/>'), 'pkg/n.py': bytes('') })),
    );
    await screen.findByRole('list', { name: 'ROS 2 package: 2 files' });
    const propose = screen.getByRole('button', { name: 'Propose activity' });
    await user.click(propose);
    const choice = await screen.findByLabelText('Node');
    expect(
      within(choice)
        .getAllByRole('option')
        .map((o) => o.textContent),
    ).toEqual(server.nodes);
    await user.selectOptions(choice, 'pkg.listener:main');
    await user.click(propose);
    expect(await screen.findByRole('list', { name: '1 proposed file' })).toHaveTextContent(
      'Topics.xml',
    );
    expect(screen.getByRole('list', { name: 'To decide' })).not.toHaveTextContent('skeleton');
    expect(server.proposals.map(({ query }) => query)).toEqual([
      { name: 'node', node: 'pkg' },
      { name: 'node', node: 'pkg', class: 'pkg.listener:main' },
    ]);
  });

  test('that cannot be used is explained by the server', async () => {
    server.proposalRefusal = [
      {
        severity: 'ERROR',
        file: 'the uploaded archive',
        line: 0,
        element: '',
        message: 'has no package.xml',
      },
    ];
    const { user } = openPortal(server, '/activities/new');
    await user.click(await screen.findByRole('radio', { name: 'A ROS 2 package' }));
    await user.type(screen.getByLabelText(/Name of the activity/), 'node');
    await user.upload(screen.getByLabelText('Files: ROS 2 package'), file('a.py', ''));
    await screen.findByRole('list', { name: 'ROS 2 package: 1 file' });
    await user.click(screen.getByRole('button', { name: 'Propose activity' }));
    expect(
      await screen.findByRole('alert', { name: 'No activity was proposed' }),
    ).toHaveTextContent('the uploaded archive: has no package.xml');
    expect(server.proposals[0]?.query.node).toBe('.');
  });
});

describe('a draft', () => {
  test('takes the first file that can provide an interface, or the chosen one', () => {
    const files = filesOf('pkg/package.xml', 'pkg/msg/A.msg', 'pkg/srv/B.srv', 'pkg/srv/C.srv');
    expect(fileOf({ ...NEW_COMPONENT, files })).toBe('pkg/srv/B.srv');
    expect(fileOf({ ...NEW_COMPONENT, files, chosenFile: 'pkg/srv/C.srv' })).toBe('pkg/srv/C.srv');
    expect(requestOfComponent({ ...NEW_COMPONENT, name: 'x' })).toBeUndefined();
    expect(
      requestOfComponent({ ...NEW_COMPONENT, name: 'x', files: filesOf('a.msg') })?.query,
    ).toEqual({ name: 'x', language: 'python' });
  });

  test('takes the package with sources, or the chosen one', () => {
    const files = filesOf('a_msgs/package.xml', 'node/package.xml', 'node/node/main.py');
    expect(folderOf({ ...NEW_PACKAGE, files })).toBe('node');
    expect(folderOf({ ...NEW_PACKAGE, files, chosenFolder: 'a_msgs' })).toBe('a_msgs');
    expect(folderOf({ ...NEW_PACKAGE, files: filesOf('package.xml', 'a.py') })).toBe('.');
  });

  test('leaves hidden files out', () => {
    const files = filesOf('p/.git/config', 'p/a.py', 'p/__pycache__/a.pyc');
    expect([...withoutHidden(files).keys()]).toEqual(['p/a.py']);
  });
});
