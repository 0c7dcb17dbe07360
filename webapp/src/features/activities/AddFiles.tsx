import { Button, FileButton, Group, Stack, TextInput } from '@mantine/core';
import { useState } from 'react';
import type { Activity } from '@/shared/api';
import { ProblemAlert } from '@/shared/ui';
import { useAddFiles } from './queries';

interface AddFilesProps {
  activity: Pick<Activity, 'id' | 'version'>;
  /** Shows one of the added files. */
  onPath: (path: string) => void;
}

/** Adds files to an activity, such as a world or the sources of a component. */
export function AddFiles({ activity, onPath }: AddFilesProps) {
  const [folder, setFolder] = useState('');
  const add = useAddFiles(activity.id);
  const prefix = folder.trim().replace(/^\/+|\/+$/g, '');
  function send(chosen: readonly File[]) {
    const files = chosen.map((file) => ({
      path: [prefix, file.webkitRelativePath || file.name].filter(Boolean).join('/'),
      file,
    }));
    const [first] = files;
    if (!first) return;
    add.mutate(
      { files, version: activity.version },
      {
        onSuccess: () => {
          onPath(first.path);
        },
      },
    );
  }
  return (
    <Stack gap="xs">
      <Group gap="xs" align="end">
        <TextInput
          label="Folder of added files"
          description="Such as world; empty for the top"
          size="xs"
          value={folder}
          onChange={(event) => {
            setFolder(event.currentTarget.value);
          }}
        />
        <FileButton multiple inputProps={{ 'aria-label': 'Files to add' }} onChange={send}>
          {(props) => (
            <Button {...props} size="xs" variant="default" loading={add.isPending}>
              Add files…
            </Button>
          )}
        </FileButton>
      </Group>
      {add.isError && (
        <ProblemAlert title="The files were not added" error={add.error} onClose={add.reset} />
      )}
    </Stack>
  );
}
