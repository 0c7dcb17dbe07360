import { Button, Popover, Text } from '@mantine/core';
import { useOffersOfAgents } from '@/features/agents';
import { BuildOptionsFields, describeOptions, type BuildOptions } from '@/features/builds';

interface BuildOptionsButtonProps {
  options: BuildOptions;
  onOptions: (options: BuildOptions) => void;
}

const TITLE = 'Build options';

/** Opens the options of the build that is about to be requested. */
export function BuildOptionsButton({ options, onOptions }: BuildOptionsButtonProps) {
  const { labels, offersRos } = useOffersOfAgents();
  const summary = describeOptions(options);
  return (
    <Popover width="min(440px, calc(100vw - 2rem))" position="bottom-end" trapFocus withRoles>
      <Popover.Target>
        <Button variant="default">{summary === '' ? TITLE : `Options: ${summary}`}</Button>
      </Popover.Target>
      <Popover.Dropdown aria-label={TITLE}>
        <BuildOptionsFields
          options={options}
          onOptions={onOptions}
          knownLabels={labels}
          offersRos={offersRos}
        />
        <Text size="xs" c="dimmed" mt="sm">
          The language of the component and a simulation are always required if the activity needs
          them.
        </Text>
      </Popover.Dropdown>
    </Popover>
  );
}
