import { Button, Group, Stack } from '@mantine/core';
import type { Agent } from '@/shared/api';
import { ConfirmedButton, ProblemAlert } from '@/shared/ui';
import { useRemoveAgent, useSetAgentState } from './queries';

/** Actions of administrators on an agent. *Disable* and *Remove* need a confirmation. */
export function AgentActions({ agent }: { agent: Agent }) {
  const setState = useSetAgentState();
  const remove = useRemoveAgent();
  const stateButton = (to: Agent['standing'], label: string) => (
    <Button
      size="compact-xs"
      variant="default"
      aria-label={`${label} ${agent.name}`}
      disabled={setState.isPending}
      onClick={() => {
        setState.mutate({ name: agent.name, standing: to });
      }}
    >
      {label}
    </Button>
  );
  return (
    <Stack gap={4}>
      <Group gap="xs" wrap="nowrap" justify="flex-end">
        {agent.standing !== 'ACTIVE' && stateButton('ACTIVE', 'Activate')}
        {agent.standing === 'ACTIVE' && stateButton('DRAINING', 'Drain')}
        {agent.standing !== 'DISABLED' && (
          <ConfirmedButton
            label="Disable"
            name={agent.name}
            onConfirm={() => {
              setState.mutate({ name: agent.name, standing: 'DISABLED' });
            }}
          />
        )}
        {agent.state === 'OFFLINE' && (
          <ConfirmedButton
            label="Remove"
            name={agent.name}
            onConfirm={() => {
              remove.mutate(agent.name);
            }}
          />
        )}
      </Group>
      {setState.isError && (
        <ProblemAlert
          title="The agent was not changed"
          error={setState.error}
          onClose={setState.reset}
        />
      )}
      {remove.isError && (
        <ProblemAlert
          title="The agent was not removed"
          error={remove.error}
          onClose={remove.reset}
        />
      )}
    </Stack>
  );
}
