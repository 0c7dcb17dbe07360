import { Anchor, Button, Code, CopyButton, Group, Popover, Stack, Text } from '@mantine/core';
import type { Build } from '@/shared/api';

/** The command that debugs a case, and the files that it needs. */
export function DebugCase({ build, no }: { build: Build; no: number }) {
  const command = `./sitaf run ${quoted(build.activityName)} --model ${quoted(build.model)} --case ${no} --debug`;
  return (
    <Popover width="min(34rem, calc(100vw - 2rem))" position="bottom-end" trapFocus withRoles>
      <Popover.Target>
        <Button variant="default" size="xs">
          Debug
        </Button>
      </Popover.Target>
      <Popover.Dropdown aria-label="Debug">
        <Stack gap="xs">
          <Text size="sm">
            Download the{' '}
            <Anchor
              href={`/api/v1/activities/${encodeURIComponent(build.activityId)}/content`}
              download
              inherit
            >
              files of the activity
            </Anchor>
            , unpack them into a folder <Code>{build.activityName}</Code>, and run:
          </Text>
          <Code block>{command}</Code>
          <Group gap="md">
            <CopyButton value={command}>
              {({ copied, copy }) => (
                <Button size="compact-sm" variant="default" onClick={copy}>
                  {copied ? 'Copied' : 'Copy'}
                </Button>
              )}
            </CopyButton>
            <Anchor href="/docs/debugging.html" target="_blank" size="sm">
              How to debug a case
            </Anchor>
          </Group>
        </Stack>
      </Popover.Dropdown>
    </Popover>
  );
}

/** A word of a shell's command line. */
function quoted(text: string): string {
  return /^[\w.+/-]+$/.test(text) ? text : `'${text.replaceAll("'", String.raw`'\''`)}'`;
}
