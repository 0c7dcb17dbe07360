import { Button, FileButton, Group, Loader, Stack, Text } from '@mantine/core';
import { useEffect, useState, type DragEvent } from 'react';
import { plural } from '@/shared/lib/format';
import { ProblemAlert, RouteLink, UserText } from '@/shared/ui';
import { useUploadActivity } from './queries';
import classes from './UploadActivity.module.css';

/** Takes the zip of an activity, chosen or dropped, and shows what the server finds wrong with it. */
export function UploadActivity() {
  const upload = useUploadActivity();
  const [over, setOver] = useState(false);
  const [tooMany, setTooMany] = useState(false);
  useStrayDropGuard();

  function take(files: readonly File[]) {
    const [zip] = files;
    setTooMany(files.length > 1);
    if (zip && files.length === 1 && !upload.isPending) upload.mutate(zip);
  }

  function drop(event: DragEvent) {
    event.preventDefault();
    setOver(false);
    take([...event.dataTransfer.files]);
  }

  return (
    <Stack gap="xs">
      <div
        className={classes.zone}
        role="group"
        aria-label="Upload an activity"
        data-over={over || undefined}
        onDragEnter={() => {
          setOver(true);
        }}
        onDragOver={(event) => {
          event.preventDefault();
          setOver(true);
        }}
        onDragLeave={() => {
          setOver(false);
        }}
        onDrop={drop}
      >
        <Group justify="space-between" gap="sm">
          <div>
            <Text fw={600}>Drop the zip of an activity here</Text>
            <Text size="sm" c="dimmed">
              activity.yaml with its interfaces, test models, component and world
            </Text>
          </div>
          <Group gap="sm">
            {upload.isPending && <Loader size="sm" aria-hidden />}
            <FileButton
              accept=".zip,application/zip"
              disabled={upload.isPending}
              inputProps={{ 'aria-label': 'Zip of an activity' }}
              // Reset, so that the same file can be chosen again once it is mended.
              key={upload.submittedAt}
              onChange={(zip) => {
                if (zip) take([zip]);
              }}
            >
              {(props) => (
                <Button {...props} variant="default">
                  Choose zip…
                </Button>
              )}
            </FileButton>
          </Group>
        </Group>
      </div>
      <div role="status">
        {upload.isPending && <Text size="sm">Uploading {upload.variables.name}…</Text>}
        {upload.isSuccess && !tooMany && (
          <Text size="sm">
            <RouteLink
              to="/activities/$activityId"
              params={{ activityId: upload.data.id }}
              underline="always"
              inherit
            >
              <UserText>{upload.data.name}</UserText>
            </RouteLink>{' '}
            is here, with {plural(upload.data.models.length, 'test model')}.
          </Text>
        )}
        {tooMany && <Text size="sm">One zip at a time: an activity is one zip.</Text>}
      </div>
      {upload.isError && (
        <ProblemAlert
          title={`${upload.variables.name} was not taken`}
          error={upload.error}
          onClose={upload.reset}
        />
      )}
    </Stack>
  );
}

/** A file dropped beside the zone must not replace the portal in the browser's tab. */
function useStrayDropGuard() {
  useEffect(() => {
    const refuse = (event: Event) => {
      event.preventDefault();
    };
    window.addEventListener('dragover', refuse);
    window.addEventListener('drop', refuse);
    return () => {
      window.removeEventListener('dragover', refuse);
      window.removeEventListener('drop', refuse);
    };
  }, []);
}
