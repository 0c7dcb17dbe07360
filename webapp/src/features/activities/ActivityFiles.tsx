import { Button, Group, Stack, Text } from '@mantine/core';
import { useState, type ReactNode } from 'react';
import type { Activity } from '@/shared/api';
import { formatCount } from '@/shared/lib/format';
import { CodeEditor, ConfirmedButton, Loading, ProblemAlert, UserText } from '@/shared/ui';
import classes from './activities.module.css';
import { AddFiles } from './AddFiles';
import { useChangeFiles, useFileText } from './queries';

interface ActivityFilesProps {
  activity: Activity;
  path?: string | undefined;
  onPath: (path: string | undefined) => void;
  mayChange: boolean;
}

const TEXT =
  /\.(java|c|cc|cpp|cxx|h|hpp|hxx|idl|proto|py|xml|xsd|ya?ml|txt|md|json|csv|msg|srv|action|urdf|cfg|ini|toml|properties|cmake)$/i;

/** The files of an activity (Fig. 13(e)), and an editor for the selected file. */
export function ActivityFiles({ activity, path, onPath, mayChange }: ActivityFilesProps) {
  const selected =
    activity.files.find((file) => file.path === path) ??
    activity.files.find((file) => file.path === 'activity.yaml');
  // Here, not in the editor, which is gone when its file is.
  const removal = useChangeFiles(activity.id);
  return (
    <div className={classes.files}>
      <Stack gap="md">
        {mayChange && <AddFiles activity={activity} onPath={onPath} />}
        <nav aria-label="Files of the activity">
          {activity.files.map((file) => (
            <button
              key={file.path}
              type="button"
              className={classes.file}
              aria-current={file === selected}
              onClick={() => {
                onPath(file.path);
              }}
            >
              <UserText>{file.path}</UserText>{' '}
              <Text span size="xs" c="dimmed">
                {formatCount(file.size)}
              </Text>
            </button>
          ))}
        </nav>
      </Stack>
      <Stack gap="sm">
        {removal.isError && (
          <ProblemAlert
            title={`${removal.variables.changes[0]?.path ?? ''} was not deleted`}
            error={removal.error}
            onClose={removal.reset}
          />
        )}
        {selected && (
          <FileEditor
            key={selected.path}
            activity={activity}
            file={selected}
            remove={
              mayChange &&
              selected.path !== 'activity.yaml' && (
                <ConfirmedButton
                  size="xs"
                  label="Delete"
                  name={selected.path}
                  loading={removal.isPending}
                  onConfirm={() => {
                    removal.mutate(
                      { changes: [{ path: selected.path }], version: activity.version },
                      {
                        onSuccess: () => {
                          onPath(undefined);
                        },
                      },
                    );
                  }}
                />
              )
            }
          />
        )}
      </Stack>
    </div>
  );
}

interface FileEditorProps {
  activity: Activity;
  file: Activity['files'][number];
  /** A button that deletes the file, if it may be deleted. */
  remove: ReactNode;
}

function FileEditor({ activity, file, remove }: FileEditorProps) {
  const [initial] = useState({ version: activity.version, sha256: file.sha256 });
  const [base, setBase] = useState(initial);
  const [edited, setEdited] = useState<string>();
  const content = useFileText(activity.id, file.path, base.sha256);
  const save = useChangeFiles(activity.id);
  const address = `/api/v1/activities/${encodeURIComponent(activity.id)}/files/${file.path
    .split('/')
    .map(encodeURIComponent)
    .join('/')}`;
  if (!TEXT.test(file.path)) {
    return (
      <Stack gap="sm" align="start">
        <Text>
          This file is not a text file. <a href={address}>Download</a>
        </Text>
        {remove}
      </Stack>
    );
  }
  if (content.isPending) return <Loading what="the file" />;
  if (content.data === undefined) {
    return <ProblemAlert title="The file could not be read" error={content.error} />;
  }
  const changed = edited !== undefined && edited !== content.data;
  return (
    <Stack gap="sm">
      <Group justify="space-between">
        <Text fw={600}>
          <UserText>{file.path}</UserText>
          {changed && ' (unsaved changes)'}
        </Text>
        <Group gap="xs">
          {remove}
          <Button component="a" href={address} size="xs" variant="default">
            Download
          </Button>
          <Button
            size="xs"
            variant="default"
            disabled={!changed}
            onClick={() => {
              setEdited(undefined);
              save.reset();
            }}
          >
            Discard
          </Button>
          <Button
            size="xs"
            disabled={!changed}
            loading={save.isPending}
            onClick={() => {
              save.mutate(
                {
                  changes: [{ path: file.path, content: edited ?? '' }],
                  version: base.version,
                },
                {
                  onSuccess: (now) => {
                    const saved = now.files.find(({ path }) => path === file.path);
                    setBase({ version: now.version, sha256: saved?.sha256 ?? base.sha256 });
                    setEdited(undefined);
                  },
                },
              );
            }}
          >
            Save
          </Button>
        </Group>
      </Group>
      {base.version !== activity.version && !changed && (
        <Text size="sm" c="dimmed">
          The activity has changed since you opened this file.{' '}
          <Button
            size="compact-xs"
            variant="default"
            onClick={() => {
              setBase({ version: activity.version, sha256: file.sha256 });
            }}
          >
            Reload
          </Button>
        </Text>
      )}
      {save.isError && (
        <ProblemAlert
          title={`${file.path} was not saved`}
          error={save.error}
          onClose={save.reset}
        />
      )}
      <CodeEditor
        label={`Text of ${file.path}`}
        path={file.path}
        text={edited ?? content.data}
        onChange={setEdited}
      />
    </Stack>
  );
}
