import { Button, FileButton, Group, Loader, Stack, Text } from '@mantine/core';
import { useEffect, useState, type DragEvent } from 'react';
import { plural } from '@/shared/lib/format';
import { ProblemAlert, RouteLink, UserText } from '@/shared/ui';
import { useUploadActivity } from './queries';
import classes from './UploadActivity.module.css';

/** Uploads the zip file of an activity and shows the problems that the server reports. */
export function UploadActivity() {
  const upload = useUploadActivity();
  const [over, setOver] = useState(false);
  const [tooMany, setTooMany] = useState(false);
  usePreventDropOutside();

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
            <Text fw={600}>Upload a zip file</Text>
            <Text size="sm" c="dimmed">
              Drop it here or choose a file. It contains activity.yaml, interfaces, test models,
              component and world.
            </Text>
          </div>
          <Group gap="sm">
            {upload.isPending && <Loader size="sm" aria-hidden />}
            <FileButton
              accept=".zip,application/zip"
              disabled={upload.isPending}
              inputProps={{ 'aria-label': 'Zip file of an activity' }}
              // Reset, so that the same file can be chosen again after it was fixed.
              key={upload.submittedAt}
              onChange={(zip) => {
                if (zip) take([zip]);
              }}
            >
              {(props) => (
                <Button {...props} variant="default">
                  Choose file…
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
            was uploaded with {plural(upload.data.models.length, 'test model')}.
          </Text>
        )}
        {tooMany && <Text size="sm">Upload one zip file at a time.</Text>}
      </div>
      {upload.isError && (
        <ProblemAlert
          title={`${upload.variables.name} was not uploaded`}
          error={upload.error}
          onClose={upload.reset}
        />
      )}
    </Stack>
  );
}

/** A file dropped outside the upload zone must not replace the page. */
function usePreventDropOutside() {
  useEffect(() => {
    const prevent = (event: Event) => {
      event.preventDefault();
    };
    window.addEventListener('dragover', prevent);
    window.addEventListener('drop', prevent);
    return () => {
      window.removeEventListener('dragover', prevent);
      window.removeEventListener('drop', prevent);
    };
  }, []);
}
