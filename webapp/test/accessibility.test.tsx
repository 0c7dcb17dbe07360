import { screen } from '@testing-library/react';
import axe from 'axe-core';
import { expect, test } from 'vitest';
import { eachWithServer } from './support/eachWithServer';
import type { FakeServer } from './support/FakeServer';
import { openPortal } from './support/openPortal';
import { activity, build, doneBuild, resultCases, suiteCases } from './support/samples';

let server: FakeServer;

eachWithServer((started) => {
  server = started;
  const cases = resultCases(['PASS', 'FAIL', 'ERROR', 'DONT']);
  server.activities.push(activity('a1'));
  server.builds.push(build('b2', { state: 'RUNNING', casesDone: 5 }), doneBuild('b1', cases));
  server.cases.set('b1', cases);
  server.suiteCases = suiteCases(9);
});

test.each([
  ['/', 'Builds'],
  ['/activities', 'Activities'],
  ['/activities/a1', 'Builds'],
  ['/suites/s1', 'Test cases'],
  ['/builds', 'Builds'],
  ['/builds/b1', 'Cases'],
  ['/agents', 'Agents'],
])('axe finds nothing wrong on %s', async (address, table) => {
  const { container } = openPortal(server, address);
  await screen.findByRole('table', { name: table });
  // Contrast needs a browser that paints; the colours' own comments say what they keep.
  const { violations } = await axe.run(container, {
    rules: { 'color-contrast': { enabled: false } },
  });
  expect(violations.map(({ id, nodes }) => [id, nodes.map((node) => node.html)])).toEqual([]);
});
