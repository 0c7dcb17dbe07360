import { Button, Stack } from '@mantine/core';
import { useState } from 'react';
import { ProblemAlert } from '@/shared/ui';
import { useCreateFromGit } from './queries';
import { draftOf, requestOf, SourceFields } from './SourceFields';

/** Creates an activity from a folder of a Git branch. */
export function NewFromGit({ onCreated }: { onCreated: (id: string) => void }) {
  const [draft, setDraft] = useState(() => draftOf(null));
  const create = useCreateFromGit();
  return (
    <form
      onSubmit={(event) => {
        event.preventDefault();
        create.mutate(requestOf(draft), {
          onSuccess: ({ id }) => {
            onCreated(id);
          },
        });
      }}
    >
      <Stack gap="sm">
        <SourceFields draft={draft} onDraft={setDraft} stored={false} storedForgeToken={false} />
        <div>
          <Button type="submit" loading={create.isPending}>
            Create from Git
          </Button>
        </div>
        {create.isError && (
          <ProblemAlert
            title="The activity was not created"
            error={create.error}
            onClose={create.reset}
          />
        )}
      </Stack>
    </form>
  );
}
