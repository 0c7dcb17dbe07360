import { screen, waitFor, within } from '@testing-library/react';
import { expect, test } from 'vitest';
import { eachWithServer } from './support/eachWithServer';
import type { FakeServer } from './support/FakeServer';
import { openPortal } from './support/openPortal';
import { activity, MODEL } from './support/samples';

let server: FakeServer;

eachWithServer((started) => {
  server = started;
  server.activities.push(activity('a1'));
  server.models.set(
    'GetInfraredData',
    MODEL.replace(
      /<output_spec_list>[^]*<\/output_spec_list>/,
      '<sequence_spec length="3" order="2"><call name="Read" method="GetInfraredData"/></sequence_spec>',
    ),
  );
  server.suiteCases = [
    {
      no: 1,
      valid: true,
      values: ['1', '5'],
      expected: {},
      steps: [
        { name: 'Enable', valid: true, inputs: {}, expected: {} },
        { name: 'Read', valid: true, inputs: { IndexOfSensor: '2' }, expected: { return: '5.0' } },
      ],
    },
    {
      no: 2,
      valid: false,
      values: ['1', '5'],
      expected: {},
      steps: [{ name: 'Read', valid: false, inputs: { IndexOfSensor: '2' }, expected: {} }],
    },
  ];
});

test('a suite of sequences shows its steps, and a case opens to their values', async () => {
  const { user } = openPortal(server, '/suites/s1');
  const first = await screen.findByRole('button', { name: /^Enable.*Read/ });
  expect(first).toHaveTextContent('Enable → Read(2) = 5.0');
  expect(screen.queryByRole('button', { name: 'Fill with formula' })).toBeNull();
  await user.click(first);
  const steps = within(await screen.findByRole('dialog')).getByRole('table', { name: 'Steps' });
  expect(steps).toHaveTextContent('IndexOfSensor = 2');
  await user.click(screen.getByRole('button', { name: 'Close' }));
  await user.click(screen.getByRole('button', { name: /^Read/ }));
  const marked = await screen.findByText('forbidden, or with an invalid value');
  await waitFor(() => {
    expect(marked).toBeVisible();
  });
});
