import { Button, Popover, Text } from '@mantine/core';
import { useAgentLabels } from '@/features/agents';
import { BuildOptionsFields, inWords, type BuildOptions } from '@/features/builds';

interface HowToBuildProps {
  options: BuildOptions;
  onOptions: (options: BuildOptions) => void;
}

/** Agent requirements and priority of a build that is about to be asked for. */
export function HowToBuild({ options, onOptions }: HowToBuildProps) {
  const labels = useAgentLabels();
  const words = inWords(options);
  return (
    <Popover width={440} position="bottom-end" trapFocus withRoles>
      <Popover.Target>
        <Button variant="default">{words === '' ? 'Agent and priority' : `With ${words}`}</Button>
      </Popover.Target>
      <Popover.Dropdown aria-label="Agent and priority">
        <BuildOptionsFields options={options} onOptions={onOptions} knownLabels={labels} />
        <Text size="xs" c="dimmed" mt="sm">
          The component’s language and a simulation are asked for anyway.
        </Text>
      </Popover.Dropdown>
    </Popover>
  );
}
