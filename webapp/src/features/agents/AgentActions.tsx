import { Button, Group, Stack } from '@mantine/core';
import { useState } from 'react';
import type { Agent } from '@/shared/api';
import { ProblemAlert } from '@/shared/ui';
import { useForgetAgent, useSetStanding } from './queries';

/** How an agent stands, for administrators. What takes work away or shuts out is asked for twice. */
export function AgentActions({ agent }: { agent: Agent }) {
  const stand = useSetStanding();
  const forget = useForgetAgent();
  const standing = (to: Agent['standing'], label: string) => (
    <Button
      size="compact-xs"
      variant="default"
      aria-label={`${label} ${agent.name}`}
      disabled={stand.isPending}
      onClick={() => {
        stand.mutate({ name: agent.name, standing: to });
      }}
    >
      {label}
    </Button>
  );
  return (
    <Stack gap={4}>
      <Group gap="xs" wrap="nowrap" justify="flex-end">
        {agent.standing !== 'ACTIVE' && standing('ACTIVE', 'Activate')}
        {agent.standing === 'ACTIVE' && standing('DRAINING', 'Drain')}
        {agent.standing !== 'DISABLED' && (
          <Twice
            label="Disable"
            name={agent.name}
            onSure={() => {
              stand.mutate({ name: agent.name, standing: 'DISABLED' });
            }}
          />
        )}
        {agent.state === 'OFFLINE' && (
          <Twice
            label="Forget"
            name={agent.name}
            onSure={() => {
              forget.mutate(agent.name);
            }}
          />
        )}
      </Group>
      {stand.isError && (
        <ProblemAlert title="It stands as it did" error={stand.error} onClose={stand.reset} />
      )}
      {forget.isError && (
        <ProblemAlert title="It was not forgotten" error={forget.error} onClose={forget.reset} />
      )}
    </Stack>
  );
}

interface TwiceProps {
  label: string;
  name: string;
  onSure: () => void;
}

function Twice({ label, name, onSure }: TwiceProps) {
  const [asked, setAsked] = useState(false);
  return (
    <Button
      size="compact-xs"
      variant={asked ? 'filled' : 'default'}
      {...(asked && { color: 'red.9' })}
      aria-label={asked ? `Really ${label.toLowerCase()} ${name}` : `${label} ${name}`}
      onClick={() => {
        if (asked) onSure();
        setAsked(!asked);
      }}
      onBlur={() => {
        setAsked(false);
      }}
    >
      {asked ? `Really ${label.toLowerCase()}?` : label}
    </Button>
  );
}
