import { Alert, Button, Group, Stack, Text } from '@mantine/core';
import type { Suite } from '@/shared/api';
import { plural } from '@/shared/lib/format';
import { useSuite } from './queries';
import type { Edits } from './useEdits';

/** Shown if another user changed the suite. Nothing is overwritten until the user decides. */
export function Conflict({ suite, edits }: { suite: Suite; edits: Edits }) {
  const stored = useSuite(suite.id);
  return (
    <Alert role="alert" color="orange" variant="outline" title="Another user changed this suite">
      <Stack gap="sm">
        <Text size="sm">
          {edits.drafts.size > 0
            ? `Nothing was overwritten. You have ${plural(edits.drafts.size, 'unsaved value')}.`
            : 'Nothing was overwritten.'}
        </Text>
        <Group gap="sm">
          <Button
            size="xs"
            variant="default"
            onClick={() => {
              edits.discard();
              void stored.refetch();
            }}
          >
            Discard my changes
          </Button>
          <Button
            size="xs"
            onClick={() =>
              void stored.refetch().then(({ data }) => {
                if (data) edits.retry(data.version);
              })
            }
          >
            Apply my changes
          </Button>
        </Group>
      </Stack>
    </Alert>
  );
}
