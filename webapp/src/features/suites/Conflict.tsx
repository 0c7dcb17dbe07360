import { Alert, Button, Group, Stack, Text } from '@mantine/core';
import type { Suite } from '@/shared/api';
import { plural } from '@/shared/lib/format';
import { useSuite } from './queries';
import type { Edits } from './useEdits';

/** Two people changed one suite: nothing is overwritten, and the second decides. */
export function Conflict({ suite, edits }: { suite: Suite; edits: Edits }) {
  const present = useSuite(suite.id);
  return (
    <Alert role="alert" color="orange" variant="outline" title="Somebody else changed this suite">
      <Stack gap="sm">
        <Text size="sm">
          {edits.drafts.size > 0
            ? `Your ${plural(edits.drafts.size, 'value')} did not overwrite it, and is still here.`
            : 'Your change did not overwrite it.'}
        </Text>
        <Group gap="sm">
          <Button
            size="xs"
            variant="default"
            onClick={() => {
              edits.discard();
              void present.refetch();
            }}
          >
            Show theirs, drop mine
          </Button>
          <Button
            size="xs"
            onClick={() =>
              void present.refetch().then(({ data }) => {
                if (data) edits.retry(data.version);
              })
            }
          >
            Put mine onto theirs
          </Button>
        </Group>
      </Stack>
    </Alert>
  );
}
