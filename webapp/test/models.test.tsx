import { screen, waitFor, within } from '@testing-library/react';
import { describe, expect, test } from 'vitest';
import { argumentsOf, draftFor, stubInputs, worldInputs } from '@/features/models/defaults';
import { withModel } from '@/features/models/profile';
import { readModel, writeModel } from '@/features/models/document';
import type { ActivityDescription } from '@/shared/api';
import { eachWithServer } from './support/eachWithServer';
import type { FakeServer } from './support/FakeServer';
import { openPortal } from './support/openPortal';
import { activity, DESCRIPTION, MODEL } from './support/samples';

let server: FakeServer;

eachWithServer((started) => {
  server = started;
  server.activities.push(activity('a1'));
  server.models.set('GetInfraredData', MODEL);
  server.description = DESCRIPTION;
});

const ADDRESS = '/activities/a1/models/GetInfraredData';
const [SERVICE] = DESCRIPTION.provided;
const METHOD = SERVICE?.methods[0];
if (!METHOD) throw new Error('The description has no method.');

describe('the editor of a test model', () => {
  test('saves a change with the version of the activity and keeps everything else', async () => {
    const { user } = openPortal(server, ADDRESS);
    const description = await screen.findByLabelText('Description');
    expect(screen.getByText('Saved')).toBeVisible();
    await user.type(description, 'Distances');
    expect(screen.getByText('Unsaved changes')).toBeVisible();
    await user.click(screen.getByRole('button', { name: 'Save' }));
    await screen.findByText('Saved');
    expect(server.models.get('GetInfraredData')).toBe(
      MODEL.replace('</name>', '</name>\n  <description>Distances</description>'),
    );
    expect(server.modelVersions).toEqual(['"1"']);
  });

  test('reports a change of another user and overwrites nothing', async () => {
    const { user } = openPortal(server, ADDRESS);
    await user.type(await screen.findByLabelText('Description'), 'Distances');
    server.activities[0] = activity('a1', { version: 2 });
    await user.click(screen.getByRole('button', { name: 'Save' }));
    expect(await screen.findByRole('alert', { name: 'The activity was changed' })).toBeVisible();
    expect(server.models.get('GetInfraredData')).toBe(MODEL);
  });

  test('shows the number of problems and the first one', async () => {
    const problem = { severity: 'ERROR', file: 'GetInfraredData.xml', line: 9 } as const;
    server.preview.diagnostics = [
      { ...problem, element: 'test_element Distance', message: 'gives no values' },
      { ...problem, element: 'strength', message: 'is missing' },
    ];
    openPortal(server, ADDRESS);
    expect(
      await screen.findByText('2 problems: test_element Distance gives no values'),
    ).toBeVisible();
  });

  test('adds and removes parameters of the world', async () => {
    const { user } = openPortal(server, ADDRESS);
    await user.click(await screen.findByRole('button', { name: 'Next' }));
    await user.click(screen.getByRole('checkbox', { name: 'Friction' }));
    await user.click(screen.getByRole('checkbox', { name: 'Distance' }));
    await waitFor(() => {
      const inputs = readModel(server.previews.at(-1) ?? MODEL).inputs;
      expect(inputs.map(({ name, kind }) => [name, kind])).toEqual([
        ['IndexOfSensor', 'TDI'],
        ['Friction', 'TDSD'],
      ]);
    });
  });

  test('changes the values of a parameter and shows those that result', async () => {
    server.preview.inputs = [
      {
        name: 'IndexOfSensor',
        type: 'TDI',
        values: [
          { literal: '0', valid: false },
          { literal: '1', valid: true },
          { literal: '9', valid: true },
        ],
        leftOut: ['0.5'],
      },
    ];
    const { user } = openPortal(server, ADDRESS);
    await user.click(await screen.findByRole('button', { name: /Values/ }));
    const index = screen.getByRole('region', { name: 'Specification of IndexOfSensor' });
    await user.clear(within(index).getByLabelText('To'));
    await user.type(within(index).getByLabelText('To'), '9');
    await user.type(within(index).getByLabelText('Custom values'), '11, 12');
    await waitFor(() => {
      expect(readModel(server.previews.at(-1) ?? MODEL).inputs[0]).toMatchObject({
        spec: { classes: [{ attributes: { min: '1', max: '9' } }] },
        userValues: ['11', '12'],
      });
    });
    expect(
      within(index).getByRole('img', { name: '3 values from 0 to 9 on a number line' }),
    ).toBeVisible();
    expect(index).toHaveTextContent('Valid (2): 1, 9');
    expect(index).toHaveTextContent('Invalid (1): 0');
    expect(index).toHaveTextContent('Omitted, because int cannot represent them: 0.5');
    await user.selectOptions(within(index).getByLabelText('Scheme of IndexOfSensor'), 'RANDOM');
    await waitFor(() => {
      expect(readModel(server.previews.at(-1) ?? MODEL).inputs[0]?.spec?.type).toBe('RANDOM');
    });
  });

  test('changes tolerances and conditions, and shows the number of cases', async () => {
    server.preview.counts = { total: 55, valid: 25, invalid: 30 };
    const { user } = openPortal(server, ADDRESS);
    await user.click(await screen.findByRole('button', { name: /Combination/ }));
    await user.type(screen.getByLabelText('ULP tolerance of return'), '4');
    await user.selectOptions(screen.getByLabelText('Order of combinations'), 'all');
    await user.selectOptions(screen.getByLabelText('Invalid values'), 'combine');
    await waitFor(() => {
      expect(readModel(server.previews.at(-1) ?? MODEL)).toMatchObject({
        order: 'all',
        invalidValues: 'combine',
        outputs: [{ name: 'return', tolerance: { ulp: '4' } }],
      });
    });
    expect(await screen.findByText('55 cases: 25 valid, 30 with an invalid value')).toBeVisible();
  });

  test('adds a relation between two runs', async () => {
    const { user } = openPortal(server, ADDRESS);
    await user.click(await screen.findByRole('button', { name: /Combination/ }));
    await user.click(screen.getByRole('button', { name: 'Add a relation' }));
    await user.type(screen.getByLabelText('Name of relation 1'), 'farther');
    await user.selectOptions(screen.getByLabelText('Changed input 1 of relation 1'), 'Distance');
    await user.click(screen.getByRole('button', { name: 'Add a change to relation 1' }));
    await waitFor(() => {
      expect(readModel(server.previews.at(-1) ?? MODEL).relations).toMatchObject([
        { name: 'farther', changes: [{ name: 'Distance' }, { name: 'IndexOfSensor' }] },
      ]);
    });
  });

  test('generates test cases from the saved model', async () => {
    const { user, history } = openPortal(server, ADDRESS);
    await user.type(await screen.findByLabelText('Description'), 'Distances');
    await user.click(screen.getByRole('button', { name: /Combination/ }));
    await user.click(await screen.findByRole('button', { name: 'Generate test cases' }));
    await waitFor(() => {
      expect(history.location.pathname).toBe('/suites/s1');
    });
    expect(server.models.get('GetInfraredData')).toContain('Distances');
  });

  test('adds a new model to the profile of the activity', async () => {
    server.files.set('activity.yaml', 'name: ir-sensor # the paper\nmodels:\n  - A.xml\n');
    const { user, history } = openPortal(server, '/activities/a1/new-model');
    expect(await screen.findByLabelText(/Name of the test model/)).toHaveValue('GetInfraredData-2');
    await user.click(screen.getByRole('button', { name: 'Save' }));
    await waitFor(() => {
      expect(history.location.pathname).toBe('/activities/a1/models/GetInfraredData-2');
    });
    expect(server.files.get('activity.yaml')).toBe(
      'name: ir-sensor # the paper\nmodels:\n  - A.xml\n  - GetInfraredData-2.xml\n',
    );
    const model = readModel(server.files.get('GetInfraredData-2.xml') ?? '');
    expect(model.inputs.map(({ name }) => name)).toEqual(['IndexOfSensor', 'pose.x', 'path[0]']);
  });
});

describe('a new test model', () => {
  test('has the inputs and outputs of the method', () => {
    const draft = draftFor('InfraredSensorService', METHOD, [], true);
    expect(draft.target).toMatchObject({
      interface: 'InfraredSensorService',
      method: 'GetInfraredData',
      signature: 'int,Pose,sequence<double>',
    });
    expect(draft.inputs.map(({ name, spec }) => [name, spec?.type])).toEqual([
      ['IndexOfSensor', 'BVA'],
      ['pose.x', 'BVA'],
      ['path[0]', 'BVA'],
    ]);
    expect(draft.outputs.map(({ name, kind, tolerance }) => [name, kind, tolerance])).toEqual([
      ['return', 'RETURN', { absolute: '1e-9' }],
      ['quality', 'OUT', {}],
    ]);
    expect(readModel(writeModel(draft))).toEqual(draft);
  });

  test('has boundaries that leave room for invalid values in the world', () => {
    const [distance] = worldInputs(DESCRIPTION);
    expect(distance?.input.spec).toMatchObject({
      settings: { offset: '0.5' },
      classes: [{ attributes: { min: '-9.5', max: '9.5' } }],
    });
    expect(distance?.note).toBe('-10 to 10 m, default 5');
  });

  test('can have the return values and out-parameters of the stub', () => {
    expect(
      stubInputs(DESCRIPTION).map(({ input, note }) => [input.name, input.spec, note]),
    ).toEqual([
      ['Motor.State', null, 'return value, State'],
      ['Motor.State.ok', null, 'out-parameter, boolean'],
    ]);
  });

  test('gives types without boundaries a fitting specification', () => {
    const text = { spelling: 'string', kind: 'scalar', members: [], literals: [] };
    const method = { ...METHOD, parameters: [{ name: 'label', direction: 'IN', type: text }] };
    const [label] = argumentsOf(method as typeof METHOD);
    expect(label?.input).toMatchObject({
      abstractType: 'STRING',
      spec: { type: 'RANDOM_STRING', settings: { min_length: '1', max_length: '10' } },
    });
  });

  test('is added to a profile without models', () => {
    expect(withModel('name: a\n', 'B.xml')).toBe('name: a\nmodels:\n  - B.xml\n');
  });
});

test('a description without a world has no parameters of a world', () => {
  const description: ActivityDescription = { provided: [], required: [], warnings: [] };
  expect(worldInputs(description)).toEqual([]);
});
