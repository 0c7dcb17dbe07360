import { screen, waitFor, within } from '@testing-library/react';
import { describe, expect, test } from 'vitest';
import type { GitBisectionCommit, GitCell } from '@/shared/api';
import { eachWithServer } from './support/eachWithServer';
import type { FakeServer } from './support/FakeServer';
import { openPortal } from './support/openPortal';
import { activity, gitBisection, gitCommit, gitSource } from './support/samples';

const BAD = 'b'.repeat(40);
const GOOD = 'a'.repeat(40);
const BUTTON = 'Find the first bad commit up to bbbbbbbbbb';
const CELL: GitCell = {
  model: 'GetInfraredData',
  buildId: 'b2',
  baseBuildId: 'b1',
  state: 'DONE',
  suspect: false,
  total: 55,
  pass: 54,
  fail: 1,
  error: 0,
  compared: 55,
  differing: 1,
};
const FIRST_BAD: GitBisectionCommit = {
  sha: 'd'.repeat(40),
  subject: 'Round the distance',
  author: 'Colleague',
  authored: '2026-11-20T12:00:00Z',
  outcome: 'BAD',
  reason: 'GetInfraredData, case 7: a wrong value',
  results: [{ model: 'GetInfraredData', buildId: 'b8', state: 'DONE', baseBuildId: 'b7' }],
};

let server: FakeServer;

eachWithServer((started) => {
  server = started;
  server.activities.push(activity('a1'));
  server.gitSource = gitSource();
  server.gitCommits.push(
    gitCommit(BAD, { base: GOOD, notBuilt: 14, cells: [CELL] }),
    gitCommit('c'.repeat(40), { state: 'SKIPPED' }),
    gitCommit(GOOD, { cells: [{ ...CELL, differing: 0 }] }),
  );
});

const openGit = () => openPortal(server, '/activities/a1?tab=commits');

const search = (number: number) => screen.findByRole('article', { name: `Search ${number}` });

describe('the first bad commit', () => {
  test('is searched with the keyboard where commits between were not built', async () => {
    const { user } = openGit();
    const button = await screen.findByRole('button', { name: BUTTON });
    expect(screen.getAllByRole('button', { name: /^Find the first bad commit/ })).toHaveLength(1);
    button.focus();
    await user.keyboard('{Enter}');
    const begun = await search(1);
    expect(begun).toHaveTextContent('15 commits after aaaaaaaaaa up to bbbbbbbbbb');
    expect(within(begun).getByRole('status')).toHaveTextContent(
      'Testing dddddddddd: one of 15 commits is the first bad one.',
    );
    expect(server.gitBisections.map(({ bad }) => bad)).toEqual([BAD]);
    await waitFor(() => {
      expect(screen.getByRole('button', { name: BUTTON })).toBeDisabled();
    });
  });

  test('is shown with its author, its build and what differs', async () => {
    server.gitBisections.push(
      gitBisection(2, BAD, {
        state: 'FOUND',
        left: 1,
        builds: 5,
        tested: [
          {
            ...FIRST_BAD,
            sha: 'e'.repeat(40),
            subject: 'Start over',
            outcome: 'SKIPPED',
            reason: 'The component does not compile.',
          },
          FIRST_BAD,
        ],
        firstBad: [FIRST_BAD],
      }),
    );
    const { user } = openGit();
    const found = await search(2);
    expect(found).toHaveTextContent('First bad commit found');
    expect(found).toHaveTextContent('Round the distance');
    expect(found).toHaveTextContent('dddddddddd · Colleague');
    expect(found).toHaveTextContent('5 builds');
    expect(within(found).getByRole('link', { name: 'Build of GetInfraredData' })).toHaveAttribute(
      'href',
      '/builds/b8',
    );
    expect(
      within(found).getByRole('link', { name: 'What differs in GetInfraredData' }),
    ).toHaveAttribute('href', '/builds/b8/compare?with=b7');
    await user.click(within(found).getByText('2 commits tested'));
    expect(within(found).getByText('The component does not compile.')).toBeVisible();
    expect(screen.queryByRole('button', { name: BUTTON })).toBeNull();
  });

  test('can be one of several that cannot be tested', async () => {
    server.gitBisections.push(
      gitBisection(1, BAD, {
        state: 'UNCERTAIN',
        left: 2,
        firstBad: [
          FIRST_BAD,
          { ...FIRST_BAD, sha: 'e'.repeat(40), subject: 'Start over', results: [] },
        ],
      }),
    );
    openGit();
    const uncertain = await search(1);
    expect(uncertain).toHaveTextContent('One of these 2 commits is the first bad one');
    expect(uncertain).toHaveTextContent('Round the distance');
    expect(uncertain).toHaveTextContent('Start over');
    expect(screen.getByRole('button', { name: BUTTON })).toBeEnabled();
  });

  test('is not found if a force-push ends the search', async () => {
    server.gitBisections.push(
      gitBisection(1, BAD, { state: 'FAILED', problem: 'A force-push has removed it. Ask again.' }),
    );
    openGit();
    const failed = await search(1);
    expect(failed).toHaveTextContent('Ended without a result');
    expect(failed).toHaveTextContent('Ask again.');
  });

  test('is no longer searched after the search was cancelled', async () => {
    server.gitBisections.push(gitBisection(1, BAD));
    const { user } = openGit();
    await user.click(await screen.findByRole('button', { name: 'Cancel search 1' }));
    await waitFor(async () => {
      expect(within(await search(1)).getByRole('status')).toHaveTextContent('Cancelled');
    });
    expect(screen.queryByRole('button', { name: 'Cancel search 1' })).toBeNull();
  });

  test('shows why a search does not begin', async () => {
    const { user } = openGit();
    const button = await screen.findByRole('button', { name: BUTTON });
    // Somebody else was faster.
    server.gitBisections.push(gitBisection(4, BAD));
    await user.click(button);
    expect(await screen.findByText('Search 4 runs.')).toBeVisible();
  });

  test('has no buttons for viewers', async () => {
    server.role = 'VIEWER';
    server.gitBisections.push(gitBisection(1, BAD));
    openGit();
    expect(await search(1)).toHaveTextContent('Testing');
    expect(screen.queryByRole('button', { name: /Find the first bad|Cancel search/ })).toBeNull();
  });

  test('has no button where no commit was left out or nothing differs', async () => {
    server.gitCommits.splice(
      0,
      server.gitCommits.length,
      gitCommit(BAD, { base: GOOD, notBuilt: 0, cells: [CELL] }),
      gitCommit('c'.repeat(40), {
        base: GOOD,
        notBuilt: 3,
        cells: [{ ...CELL, differing: 0 }],
      }),
    );
    openGit();
    expect(await screen.findByText('1 case differs')).toBeVisible();
    expect(screen.queryByRole('button', { name: /^Find the first bad commit/ })).toBeNull();
  });
});
