import { List, Stack, Text } from '@mantine/core';
import { useMemo, useState } from 'react';
import type { StateDiagram } from '@/shared/api';
import { plural } from '@/shared/lib/format';
import { layoutOf, Section, StatesLegend, StatesView, UserText } from '@/shared/ui';

const SHOWN = ['planned', 'forbidden'] as const;

/** The abstract states that the sequences of a draft reach, and the steps from the selected one. */
export function PlannedStates({ diagram }: { diagram: StateDiagram | undefined }) {
  const layout = useMemo(
    () => diagram && diagram.states.length > 0 && layoutOf(diagram, true),
    [diagram],
  );
  const [chosen, setChosen] = useState(0);
  if (!diagram || !layout) {
    return (
      <Section title="Diagram of the states">
        <Text c="dimmed">The diagram is shown when the model has no problems.</Text>
      </Section>
    );
  }
  const shown = chosen < diagram.states.length ? chosen : 0;
  const nameOf = (state: number) => diagram.states[state]?.name ?? '';
  const steps = diagram.transitions.filter(({ from }) => from === shown);
  return (
    <Section title="Diagram of the states">
      <Text size="sm">
        {plural(diagram.states.length, 'abstract state')},{' '}
        {plural(diagram.transitions.length, 'transition')}.{' '}
        {!diagram.complete && 'The model has more; the diagram shows the first ones. '}
        Select a state to see its steps.
      </Text>
      <StatesLegend shown={SHOWN} />
      <StatesView layout={layout} shown={shown} onState={setChosen} />
      <Stack gap={4}>
        <Text fw={600} id="planned-steps">
          Steps from <UserText>{nameOf(shown)}</UserText>
        </Text>
        <List size="sm" aria-labelledby="planned-steps">
          {steps.map(({ step, kind, to }) => (
            <List.Item key={`${step} ${kind} ${to}`}>
              <UserText>{step}</UserText>
              {kind === 'FORBIDDEN'
                ? ' is forbidden, and made in invalid cases'
                : to === shown
                  ? ' leaves the state'
                  : ' leads to '}
              {kind !== 'FORBIDDEN' && to !== shown && <UserText>{nameOf(to)}</UserText>}
            </List.Item>
          ))}
        </List>
        {steps.length === 0 && <Text c="dimmed">No step is allowed here.</Text>}
      </Stack>
    </Section>
  );
}
