import { screen, waitFor, within } from '@testing-library/react';
import { unzipSync, zipSync } from 'fflate';
import { describe, expect, test } from 'vitest';
import { parse } from 'yaml';
import { filesFrom, profileOf } from '@/features/wizard/archive';
import { EMPTY, pathsOf, suggestedClass, type WizardDraft } from '@/features/wizard/draft';
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

function bytes(text: string): Uint8Array {
  return new TextEncoder().encode(text);
}

function draft(changes: Partial<WizardDraft>): WizardDraft {
  return { ...EMPTY, name: 'ir', className: 'ir.Sensor', ...changes };
}

const SOURCE = 'package org.example;\n\npublic final class Sensor implements Service {}\n';

/** The wizard for files that exist. */
async function openWizard() {
  const portal = openPortal(server, '/activities/new');
  await portal.user.click(await screen.findByRole('radio', { name: 'Files that I have' }));
  return portal;
}

describe('the wizard', () => {
  test('creates an activity from its four steps', async () => {
    const { user } = await openWizard();
    await user.type(await screen.findByLabelText(/Name of the activity/), 'ir-sensor');
    await user.type(screen.getByLabelText('Properties'), 'Size: 7');
    await user.type(screen.getByLabelText('Calls before the method under test'), 'Enable()');
    await user.click(screen.getByRole('button', { name: 'Next' }));
    await user.upload(
      screen.getByLabelText('Files: Sources of the component'),
      file('Sensor.java', SOURCE),
    );
    await waitFor(() => {
      expect(screen.getByLabelText(/Component class/)).toHaveValue('org.example.Sensor');
    });
    await user.click(screen.getByRole('button', { name: 'Next' }));
    await user.upload(
      screen.getByLabelText('Files: Provided interfaces'),
      file('Service.idl', 'interface Service {};'),
    );
    await screen.findByRole('list', { name: 'Provided interfaces: 1 file' });
    await user.click(screen.getByRole('button', { name: 'Next' }));
    expect(await screen.findByText('No problems.')).toBeVisible();
    await user.click(screen.getByRole('button', { name: 'Create activity' }));
    await waitFor(() => {
      expect(server.uploads).toHaveLength(1);
    });
    const files = unzipSync(new Uint8Array(server.uploads[0] ?? []));
    expect(Object.keys(files).sort()).toEqual([
      'Service.idl',
      'activity.yaml',
      'component/Sensor.java',
    ]);
    expect(parse(new TextDecoder().decode(files['activity.yaml']))).toMatchObject({
      name: 'ir-sensor',
      component: {
        language: 'java',
        sources: 'component/',
        class: 'org.example.Sensor',
        properties: { Size: 7 },
        before: ['Enable()'],
      },
      provided: ['Service.idl'],
    });
  });

  test('shows a problem at the field that causes it', async () => {
    server.problems = [
      {
        severity: 'ERROR',
        file: 'activity.yaml',
        line: 1,
        element: 'name',
        message: "'-' is not a name",
      },
    ];
    const { user } = await openWizard();
    const name = await screen.findByLabelText(/Name of the activity/);
    await waitFor(() => {
      expect(server.checks).not.toEqual([]);
    });
    // An empty field shows no problem before anything was typed.
    expect(screen.queryByText("'-' is not a name")).toBeNull();
    await user.type(name, '-');
    expect(await screen.findByText("'-' is not a name")).toBeVisible();
    await user.click(screen.getByRole('button', { name: /Summary/ }));
    expect(await screen.findByRole('list', { name: 'Diagnostics' })).toHaveTextContent(
      "activity.yaml:1: name: '-' is not a name",
    );
    expect(screen.getByRole('button', { name: 'Create activity' })).toBeDisabled();
  });

  test('removes a file', async () => {
    const { user } = await openWizard();
    const zone = await screen.findByRole('group', { name: 'Component profile' });
    await user.upload(
      within(zone).getByLabelText('Files: Component profile'),
      file('a.xml', '<a/>'),
    );
    await user.click(await within(zone).findByRole('button', { name: 'Remove a.xml' }));
    expect(within(zone).queryByRole('listitem')).toBeNull();
  });

  test('reports a damaged zip file', async () => {
    const { user } = await openWizard();
    const input = await screen.findByLabelText('Files: Component profile');
    await user.upload(input, file('a.zip', 'no zip'));
    expect(await screen.findByRole('alert', { name: 'The files could not be read' })).toBeVisible();
  });
});

describe('the files of an activity', () => {
  test('are unpacked from zip files without a common folder', async () => {
    const zip = zipSync({
      'ir/a.txt': bytes('a'),
      'ir/deep/b.txt': bytes('b'),
      'ir/deep/': bytes(''),
    });
    const files = await filesFrom([{ path: 'ir.zip', file: file('ir.zip', zip) }]);
    expect([...files.keys()]).toEqual(['a.txt', 'deep/b.txt']);
  });

  test('keep folders that are part of package names', async () => {
    const files = await filesFrom([{ path: 'org/A.java', file: file('A.java', SOURCE) }]);
    expect([...files.keys()]).toEqual(['org/A.java']);
  });

  test('are put into the folders that the profile refers to', () => {
    const content = new Map([['x', bytes('')]]);
    const all = draft({
      sources: new Map([['Sensor.py', bytes('')]]),
      libraries: new Map([['dep.whl', bytes('')]]),
      world: new Map([['ir.world.yaml', bytes('')]]),
      profile: new Map([['Comp.xml', bytes('')]]),
      required: content,
    });
    expect(pathsOf(all)).toEqual([
      'Comp.xml',
      'activity.yaml',
      'component/Sensor.py',
      'lib/dep.whl',
      'world/ir.world.yaml',
      'x',
    ]);
    expect(parse(profileOf(all))).toMatchObject({
      component: { sources: 'component/', profile: 'Comp.xml', life_cycle: 'case' },
      required: ['x'],
      libraries: ['lib/dep.whl'],
      world: 'world/ir.world.yaml',
      models: [],
    });
  });

  test('may be a compiled library instead of sources', () => {
    const library = new Map([['sensor.jar', bytes('')]]);
    expect(parse(profileOf(draft({ library })))).toMatchObject({
      component: { library: 'library/sensor.jar', class: 'ir.Sensor' },
    });
  });
});

describe('the suggested class', () => {
  test.each([
    ['java', 'org/example/Sensor.java', SOURCE, 'org.example.Sensor'],
    ['python', 'ir/sensor.py', 'import x\nclass Sensor:\n  pass\n', 'ir.sensor.Sensor'],
    ['cpp', 'sensor.hpp', '#pragma once\nclass Sensor final : Base {\n', 'Sensor'],
    ['cpp', 'sensor.cpp', 'class Sensor {\n', ''],
    ['java', 'Notes.txt', 'public class Not {}', ''],
  ] as const)('of %s is found in %s', (language, path, text, found) => {
    expect(suggestedClass(draft({ language, sources: new Map([[path, bytes(text)]]) }))).toBe(
      found,
    );
  });
});
