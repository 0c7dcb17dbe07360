import { screen, waitFor } from '@testing-library/react';
import { describe, expect, test } from 'vitest';
import { eachWithServer } from './support/eachWithServer';
import type { FakeServer } from './support/FakeServer';
import { openPortal } from './support/openPortal';
import { MODEL, modelOf, suiteCases } from './support/samples';

let server: FakeServer;

eachWithServer((started) => {
  server = started;
  server.models.set('GetInfraredData', MODEL);
});

describe('the grid of cases', () => {
  test.each([
    ['none', {}],
    ['one', { return: '5.0' }],
  ])('edits the outputs of a model of which %s has an expected value', async (_, expected) => {
    server.models.set(
      'GetInfraredData',
      modelOf([
        { name: 'return', type: 'RETURN' },
        { name: 'quality', type: 'OUT' },
      ]),
    );
    server.suiteCases = suiteCases(3).map((item) => ({ ...item, expected }));
    const { user } = openPortal(server, '/suites/s1');
    await user.type(await screen.findByLabelText('Expected quality of case 2'), '3{Enter}');
    await waitFor(() => {
      expect(server.suiteEdits.map(({ changes }) => changes)).toEqual([
        [{ no: 2, output: 'quality', literal: '3' }],
      ]);
    });
  });

  test('saves a value with the version of the suite', async () => {
    server.suiteCases = suiteCases(55);
    const { user } = openPortal(server, '/suites/s1');
    const cell = await screen.findByLabelText('Expected return of case 3');
    await user.clear(cell);
    await user.type(cell, '7.5{Enter}');
    await screen.findByText(/ · saved/);
    expect(server.suiteEdits).toEqual([{ ifMatch: '"1"', changes: [{ no: 3, literal: '7.5' }] }]);
    expect(screen.getByLabelText('Expected return of case 3')).toHaveValue('7.5');
  });

  test('pastes rows of a spreadsheet', async () => {
    server.suiteCases = suiteCases(55);
    const { user } = openPortal(server, '/suites/s1');
    await user.click(await screen.findByLabelText('Expected return of case 2'));
    await user.paste('1.0\r\n2.0\r\n3.0\r\n');
    await waitFor(() => {
      expect(server.suiteEdits.map(({ changes }) => changes)).toEqual([
        [
          { no: 2, literal: '1.0' },
          { no: 3, literal: '2.0' },
          { no: 4, literal: '3.0' },
        ],
      ]);
    });
  });

  test('reports a change of another user and overwrites nothing', async () => {
    server.suiteCases = suiteCases(5);
    const { user } = openPortal(server, '/suites/s1');
    const cell = await screen.findByLabelText('Expected return of case 1');
    server.suiteVersion = 9;
    await user.clear(cell);
    await user.type(cell, '7.5{Enter}');
    expect(
      await screen.findByRole('alert', { name: 'Another user changed this suite' }),
    ).toBeVisible();
    expect(server.suiteEdits).toEqual([]);
    expect(screen.getByLabelText('Expected return of case 1')).toHaveValue('7.5');
    await user.click(screen.getByRole('button', { name: 'Apply my changes' }));
    await waitFor(() => {
      expect(server.suiteEdits).toEqual([{ ifMatch: '"9"', changes: [{ no: 1, literal: '7.5' }] }]);
    });
  });
});
