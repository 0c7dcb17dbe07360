import { screen, waitFor, within } from '@testing-library/react';
import { describe, expect, test } from 'vitest';
import { readModel, type SequenceDraft } from '@/features/models/document';
import { eachWithServer } from './support/eachWithServer';
import type { FakeServer } from './support/FakeServer';
import { openPortal } from './support/openPortal';
import { activity, DESCRIPTION } from './support/samples';

let server: FakeServer;

const MODEL = `<?xml version="1.0" encoding="UTF-8"?>
<test_model>
  <name>LifeCycle</name>
  <target interface="InfraredSensorService"/>
  <input_spec_list>
  </input_spec_list>
  <sequence_spec length="6" order="2">
    <state name="enabled" type="boolean" initial="false"/>
    <!-- A guess. -->
    <call name="Read" method="GetInfraredData">
      <guard>enabled</guard>
      <forbidden>!error</forbidden>
      <input_spec_list>
        <test_element abstract_type="NUMERIC" real_type="int">
          <name>IndexOfSensor</name>
          <type>TDI</type>
          <user_value_list>
            <value>1</value>
          </user_value_list>
        </test_element>
      </input_spec_list>
      <output_spec_list>
        <test_element abstract_type="NUMERIC" real_type="double">
          <name>return</name>
          <type>RETURN</type>
        </test_element>
      </output_spec_list>
    </call>
    <event name="Nears" set="Distance" to="0.5">
      <update state="enabled">true</update>
    </event>
  </sequence_spec>
  <invalid_values>isolate</invalid_values>
  <order_of_combinations>2</order_of_combinations>
</test_model>
`;

eachWithServer((started) => {
  server = started;
  server.activities.push(activity('a1'));
  server.models.set('LifeCycle', MODEL);
  const [service] = DESCRIPTION.provided;
  const [method] = service?.methods ?? [];
  if (!service || !method) throw new Error('The description has no method.');
  const enable = { ...method, name: 'Enable', signature: '', parameters: [] };
  server.description = {
    ...DESCRIPTION,
    provided: [{ ...service, methods: [...service.methods, enable] }],
  };
  server.proposal = MODEL.replace('<name>LifeCycle', '<name>Sequences');
});

const ADDRESS = '/activities/a1/models/LifeCycle';

/** The sequence of the last draft that was sent for a preview. */
function sent(): SequenceDraft | null {
  return readModel(server.previews.at(-1) ?? MODEL).sequence;
}

describe('the editor of sequences', () => {
  test('adds a state, and its name is followed by the updates', async () => {
    const { user } = openPortal(server, ADDRESS);
    await user.click(await screen.findByRole('button', { name: 'Add a state' }));
    await user.clear(screen.getByLabelText('Name of state 1'));
    await user.type(screen.getByLabelText('Name of state 1'), 'on');
    await user.clear(screen.getByLabelText('Type of state 2'));
    await user.type(screen.getByLabelText('Type of state 2'), 'int');
    await waitFor(() => {
      expect(sent()).toMatchObject({
        states: [
          { name: 'on', type: 'boolean' },
          { name: 'state', type: 'int' },
        ],
        events: [{ name: 'Nears', updates: [{ name: 'on', text: 'true' }] }],
      });
    });
  });

  test('adds, renames and removes calls and events', async () => {
    const { user } = openPortal(server, ADDRESS);
    await user.click(await screen.findByRole('button', { name: 'Add a call' }));
    await user.click(screen.getByRole('button', { name: 'Add an event' }));
    await user.selectOptions(screen.getByLabelText('What Event sets'), 'Friction');
    await user.click(screen.getByRole('button', { name: 'Remove event Nears' }));
    await user.click(screen.getByRole('button', { name: 'Times of Read' }));
    await user.type(screen.getByLabelText('After (s) Read'), '0.1');
    await user.click(screen.getByLabelText('The next step begins while it runs: Read'));
    await user.click(screen.getByRole('button', { name: 'Change a state by Read' }));
    await waitFor(() => {
      const sequence = sent();
      expect(sequence?.events).toMatchObject([{ name: 'Event', set: 'Friction', to: '0' }]);
      expect(sequence?.calls[0]).toMatchObject({
        name: 'Read',
        runFor: '0.1',
        overlap: 'true',
        updates: [{ name: 'enabled', text: 'true' }],
        forbidden: '!error',
      });
      expect(sequence?.calls).toHaveLength(2);
      expect(sequence?.calls[1]).toMatchObject({ name: 'Enable', method: 'Enable' });
    });
    await user.click(screen.getByRole('button', { name: 'Remove call Read' }));
    await waitFor(() => {
      expect(sent()?.calls).toHaveLength(1);
    });
  });

  test('another method brings its inputs and outputs', async () => {
    const { user } = openPortal(server, ADDRESS);
    const select = await screen.findByLabelText('Method of Read');
    await user.selectOptions(select, 'Enable()');
    await waitFor(() => {
      expect(sent()?.calls).toMatchObject([
        { name: 'Read', method: 'Enable', guard: 'enabled', inputs: [] },
      ]);
    });
  });

  test('shows the states that the sequences reach, and the steps of the selected one', async () => {
    const step = { step: 'Read', passed: 0, failed: 0 };
    server.preview.states = {
      states: [
        { name: 'enabled=false', steps: 0 },
        { name: 'enabled=true', steps: 0 },
      ],
      transitions: [
        { ...step, from: 0, to: 0, kind: 'FORBIDDEN' },
        { ...step, from: 0, to: 1, step: 'Nears', kind: 'VALID' },
        { ...step, from: 1, to: 1, kind: 'VALID' },
      ],
      complete: true,
      settleS: 0,
    };
    const { user } = openPortal(server, ADDRESS);
    const diagram = await screen.findByRole('group', { name: 'Diagram of the states' });
    const steps = screen.getByRole('list', { name: 'Steps from enabled=false' });
    expect(steps).toHaveTextContent('Read is forbidden, and made in invalid cases');
    expect(steps).toHaveTextContent('Nears leads to enabled=true');
    await user.click(within(diagram).getByRole('button', { name: 'enabled=true' }));
    expect(screen.getByRole('list', { name: 'Steps from enabled=true' })).toHaveTextContent(
      'Read leaves the state',
    );
  });

  test('shows a problem at its step', async () => {
    server.preview.diagnostics = [
      {
        severity: 'ERROR',
        file: 'model',
        line: 9,
        element: 'call Read/guard',
        message: "there is no 'enabeld'",
      },
    ];
    openPortal(server, ADDRESS);
    const table = await screen.findByRole('table', { name: 'Calls and events' });
    expect(await within(table).findByText(/there is no 'enabeld'/)).toBeVisible();
  });

  test('selects the inputs of a call, and changes their values', async () => {
    const { user } = openPortal(server, ADDRESS);
    await user.click(await screen.findByRole('button', { name: /Parameters/ }));
    const inputs = screen.getByRole('group', { name: 'Inputs of Read' });
    const boxes = within(inputs).getAllByRole('checkbox');
    expect(boxes.length).toBeGreaterThan(1);
    const missing = boxes.find((box) => !(box as HTMLInputElement).checked);
    if (!missing) throw new Error('All inputs are selected.');
    await user.click(missing);
    await waitFor(() => {
      expect(sent()?.calls[0]?.inputs).toHaveLength(2);
    });
    await user.click(screen.getByRole('button', { name: /Values/ }));
    const index = screen.getByRole('region', { name: 'Specification of IndexOfSensor of Read' });
    await user.type(within(index).getByLabelText('Custom values'), ', 7');
    await waitFor(() => {
      expect(
        sent()?.calls[0]?.inputs.find(({ name }) => name === 'IndexOfSensor')?.userValues,
      ).toEqual(['1', '7']);
    });
  });

  test('lets a call set the world before it', async () => {
    const { user } = openPortal(server, ADDRESS);
    await user.click(await screen.findByRole('button', { name: /Parameters/ }));
    const inputs = screen.getByRole('group', { name: 'Inputs of Read' });
    await user.selectOptions(
      within(inputs).getByLabelText('Add to the inputs of Read'),
      'Distance',
    );
    await waitFor(() => {
      expect(sent()?.calls[0]?.inputs).toHaveLength(2);
    });
    expect(sent()?.calls[0]?.inputs.at(-1)).toMatchObject({ name: 'Distance', kind: 'TDSD' });
    const box = within(inputs).getByRole('checkbox', { name: 'Distance' });
    await user.click(box);
    expect(box).not.toBeInTheDocument();
  });

  test('edits the tolerances and conditions of a call', async () => {
    const { user } = openPortal(server, ADDRESS);
    await user.click(await screen.findByRole('button', { name: /Combination/ }));
    await user.type(screen.getByLabelText('ULP tolerance of return of Read'), '4');
    const conditions = screen.getByRole('region', { name: 'Post-conditions of Read' });
    await user.click(within(conditions).getByRole('button', { name: 'Add' }));
    await user.type(screen.getByLabelText('Name of Post-conditions of Read 1'), 'positive');
    await waitFor(() => {
      expect(sent()?.calls[0]?.outputs).toMatchObject([
        { name: 'return', tolerance: { ulp: '4' } },
      ]);
    });
    expect(screen.queryByLabelText('Maximum number of cases')).toBeNull();
  });

  test('a new model begins with what the server proposes, and is saved with its comments', async () => {
    server.files.set('activity.yaml', 'name: ir\nmodels: [GetInfraredData.xml]\n');
    const { user } = openPortal(server, '/activities/a1/new-model');
    await user.click(await screen.findByRole('radio', { name: 'A sequence of calls in a case' }));
    expect(await screen.findByLabelText('Name of step Read')).toBeVisible();
    expect(server.requests).toContain(
      'GET /api/v1/activities/a1/proposals/sequences?interface=InfraredSensorService&name=Sequences',
    );
    await user.click(screen.getByRole('button', { name: 'Save' }));
    await waitFor(() => {
      expect(server.models.get('Sequences')).toBe(
        MODEL.replace('<name>LifeCycle', '<name>Sequences'),
      );
    });
  });
});
