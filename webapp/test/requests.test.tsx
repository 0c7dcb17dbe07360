import { screen, waitFor, within } from '@testing-library/react';
import { describe, expect, test } from 'vitest';
import type { GitCell } from '@/shared/api';
import { eachWithServer } from './support/eachWithServer';
import type { FakeServer } from './support/FakeServer';
import { openPortal } from './support/openPortal';
import { activity, gitCommit, gitRequest, gitSource } from './support/samples';

const HEAD = 'b'.repeat(40);
const BASE = 'a'.repeat(40);
const CELL: GitCell = {
  model: 'GetInfraredData',
  buildId: 'b2',
  baseBuildId: 'b1',
  state: 'DONE',
  suspect: false,
  total: 55,
  pass: 53,
  fail: 2,
  error: 0,
  compared: 55,
  differing: 2,
};

let server: FakeServer;

eachWithServer((started) => {
  server = started;
  server.activities.push(activity('a1'));
  server.gitSource = gitSource();
});

function openGit(search = '') {
  return openPortal(server, `/activities/a1?tab=commits${search}`);
}

async function rowOf(title: string) {
  const table = await screen.findByRole('table', { name: 'Pull requests' });
  const row = within(table)
    .getByRole('link', { name: new RegExp(title) })
    .closest('tr');
  if (!row) throw new Error(`No row of ${title}`);
  return row;
}

describe('the pull requests', () => {
  test('show the result of the head and what differs from the merge base', async () => {
    server.gitRequests.push(
      gitRequest(7, { commit: gitCommit(HEAD, { request: 7, base: BASE, cells: [CELL] }) }),
    );
    openGit();
    const row = await rowOf('7 Extend the range');
    expect(row).toHaveTextContent('bbbbbbbbbb · contributor');
    expect(row).toHaveTextContent('53 of 55 passed');
    expect(row).toHaveTextContent('2 cases differ from aaaaaaaaaa');
  });

  test('of a fork are built when somebody asks for the head', async () => {
    server.gitRequests.push(gitRequest(8, { fork: true, waitsForApproval: true }));
    const { user } = openGit();
    const row = await rowOf('8 Extend the range');
    expect(row).toHaveTextContent('Waits for approval');
    expect(row).toHaveTextContent('Code of a fork will run on the agents');
    await user.click(within(row).getByRole('button', { name: 'Build: 8' }));
    await waitFor(() => {
      expect(server.builtHeads).toEqual([HEAD]);
    });
    await waitFor(() => {
      expect(row).not.toHaveTextContent('Waits for approval');
    });
  });

  test('are not built if the head has moved', async () => {
    server.gitRequests.push(gitRequest(8, { fork: true, waitsForApproval: true }));
    const { user } = openGit();
    const button = await screen.findByRole('button', { name: 'Build: 8' });
    server.gitRequests[0] = gitRequest(8, {
      fork: true,
      waitsForApproval: true,
      head: 'c'.repeat(40),
    });
    await user.click(button);
    expect(await screen.findByText(/The head is now c{40}/)).toBeVisible();
    expect(server.builtHeads).toEqual([]);
  });

  test('have no button for viewers', async () => {
    server.role = 'VIEWER';
    server.gitRequests.push(gitRequest(8, { fork: true, waitsForApproval: true }));
    openGit();
    expect(await rowOf('8 Extend the range')).toHaveTextContent('Waits for approval');
    expect(screen.queryByRole('button', { name: /^Build/ })).toBeNull();
  });

  test('lead to their commits, which name the merge base', async () => {
    server.gitCommits.push(
      gitCommit(HEAD, { request: 7, subject: 'Extend', base: BASE, cells: [CELL] }),
      gitCommit(BASE, { request: 7, subject: 'Start', mergeBase: true }),
      gitCommit('c'.repeat(40), { subject: 'Of the branch' }),
    );
    server.gitRequests.push(gitRequest(7));
    const { user, history } = openGit();
    await user.click(await screen.findByRole('link', { name: '7 Extend the range' }));
    const commits = await screen.findByRole('region', { name: 'Commits of pull request 7' });
    await waitFor(() => {
      expect(commits).toHaveTextContent('Merge base');
    });
    expect(commits).toHaveTextContent('2 cases differ');
    expect(commits).not.toHaveTextContent('Of the branch');
    expect(history.location.search).toBe('?tab=commits&request=7');
    await user.click(screen.getByRole('link', { name: 'Commits of the branch' }));
    expect(await screen.findByText('Of the branch')).toBeVisible();
  });

  test('are filtered by state, and are called merge requests at GitLab', async () => {
    server.gitSource = gitSource({ forge: 'GITLAB' });
    server.gitRequests.push(gitRequest(7), gitRequest(6, { title: 'Old', state: 'CLOSED' }));
    const { user } = openGit();
    expect(await screen.findByRole('table', { name: 'Merge requests' })).toBeVisible();
    expect(screen.queryByRole('link', { name: '6 Old' })).toBeNull();
    await user.selectOptions(
      screen.getByRole('combobox', { name: 'Merge requests to show' }),
      'Closed',
    );
    expect(await screen.findByRole('link', { name: '6 Old' })).toBeVisible();
    expect(screen.queryByRole('link', { name: '7 Extend the range' })).toBeNull();
  });
});
