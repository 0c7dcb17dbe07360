import { screen } from '@testing-library/react';
import axe from 'axe-core';
import { expect, test } from 'vitest';
import { eachWithServer } from './support/eachWithServer';
import type { FakeServer } from './support/FakeServer';
import { openPortal } from './support/openPortal';
import {
  activity,
  build,
  doneBuild,
  gitBisection,
  gitRequest,
  gitSource,
  MODEL,
  resultCases,
  suiteCases,
} from './support/samples';

let server: FakeServer;

eachWithServer((started) => {
  server = started;
  const cases = resultCases(['PASS', 'FAIL', 'ERROR', 'DONT']);
  server.activities.push(activity('a1'));
  server.builds.push(build('b2', { state: 'RUNNING', casesDone: 5 }), doneBuild('b1', cases));
  server.cases.set('b1', cases);
  server.suiteCases = suiteCases(9);
  server.models.set('GetInfraredData', MODEL);
  server.gitSource = gitSource();
  server.gitBisections.push(gitBisection(1, 'b'.repeat(40)));
  server.gitRequests.push(gitRequest(8, { fork: true, waitsForApproval: true }));
});

test.each([
  ['/', 'Builds'],
  ['/activities', 'Activities'],
  ['/activities/a1', 'Builds'],
  ['/activities/a1?tab=commits', 'Pull requests'],
  ['/suites/s1', 'Test cases'],
  ['/builds', 'Builds'],
  ['/builds/b1', 'Cases'],
  ['/agents', 'Agents'],
])('axe finds no violations on %s', async (address, table) => {
  const { container } = openPortal(server, address);
  await screen.findByRole('table', { name: table });
  // jsdom does not paint, so contrast is checked in the browser tests.
  const { violations } = await axe.run(container, {
    rules: { 'color-contrast': { enabled: false } },
  });
  expect(violations.map(({ id, nodes }) => [id, nodes.map((node) => node.html)])).toEqual([]);
});
