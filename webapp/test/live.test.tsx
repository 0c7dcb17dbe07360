import { MantineProvider } from '@mantine/core';
import { render, screen } from '@testing-library/react';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { LiveCase } from '@/live/LiveCase';
import { recordingGlb } from './support/glb';

/** What the command answers, by path; without an answer, it has ended. */
let answers: Partial<Record<string, () => Response>>;

beforeEach(() => {
  answers = {};
  vi.stubGlobal('fetch', (path: string) => {
    const answer = answers[path];
    return answer ? Promise.resolve(answer()) : Promise.reject(new TypeError('refused'));
  });
});

afterEach(() => {
  vi.unstubAllGlobals();
});

function watched(ended: boolean) {
  return () =>
    Response.json({
      activity: 'sensor',
      model: 'Read',
      no: 7,
      inputs: [
        { name: 'Index', literal: '2' },
        { name: 'Label', literal: '' },
      ],
      ended,
    });
}

function motion() {
  return new Response(new Uint8Array(recordingGlb()), { status: 200, headers: { ETag: '"1"' } });
}

function open() {
  render(
    <MantineProvider>
      <LiveCase />
    </MantineProvider>,
  );
}

test('shows the case before it begins, while it runs, and after it', async () => {
  answers['case.json'] = watched(false);
  answers['motion.glb'] = () => new Response(null, { status: 204 });
  open();
  expect(await screen.findByRole('heading', { name: 'Case 7' })).toBeVisible();
  expect(screen.getByText('sensor, Read')).toBeVisible();
  expect(screen.getByText('Index = 2, Label = ""')).toBeVisible();
  expect(screen.getByText('The case has not begun.')).toBeVisible();

  answers['motion.glb'] = motion;
  expect(await screen.findByText(/^The case runs: 1.000 s of simulation time/)).toBeVisible();
  // The newest state, not the begin of the recording.
  expect(await screen.findByTestId('clock')).toHaveTextContent('1.00 of 1.00 s');

  answers['case.json'] = watched(true);
  answers['motion.glb'] = () => new Response(null, { status: 304 });
  expect(await screen.findByText('The case has ended.')).toBeVisible();
  answers = {};
  expect(await screen.findByText(/^The command has ended/)).toBeVisible();
  expect(screen.getByTestId('clock')).toBeVisible();
});

test('says why the scene cannot be shown', async () => {
  answers['case.json'] = watched(false);
  answers['motion.glb'] = () => new Response(null, { status: 503 });
  open();
  expect(await screen.findByText('The command answers 503 to motion.glb.')).toBeVisible();
});
