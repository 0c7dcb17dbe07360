import { Button, Popover, Text } from '@mantine/core';
import { useAgentLabels } from '@/features/agents';
import { BuildOptionsFields, inWords, type BuildOptions } from '@/features/builds';

interface HowToBuildProps {
  options: BuildOptions;
  onOptions: (options: BuildOptions) => void;
}

const TITLE = 'Agent, priority, recordings';

/** How a build that is about to be asked for is executed. */
export function HowToBuild({ options, onOptions }: HowToBuildProps) {
  const labels = useAgentLabels();
  const words = inWords(options);
  return (
    <Popover width="min(440px, calc(100vw - 2rem))" position="bottom-end" trapFocus withRoles>
      <Popover.Target>
        <Button variant="default">{words === '' ? TITLE : `With ${words}`}</Button>
      </Popover.Target>
      <Popover.Dropdown aria-label={TITLE}>
        <BuildOptionsFields options={options} onOptions={onOptions} knownLabels={labels} />
        <Text size="xs" c="dimmed" mt="sm">
          The component’s language and a simulation are asked for anyway.
        </Text>
      </Popover.Dropdown>
    </Popover>
  );
}
