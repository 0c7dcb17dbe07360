import { Button, Group, SegmentedControl, Stack, Text } from '@mantine/core';
import { useState } from 'react';
import { useActivity, useChangeFiles } from '@/features/activities';
import { useHarness } from '@/features/suites';
import type { Activity, HarnessFile, Suite } from '@/shared/api';
import { CodeEditor, Difference, Loading, ProblemAlert, UserText } from '@/shared/ui';
import classes from './Shell.module.css';

interface TestApplicationViewProps {
  suite: Suite;
  path?: string | undefined;
  onPath: (path: string) => void;
}

/** The generated sources. The user can replace the concrete test driver. */
export function TestApplicationView({ suite, path, onPath }: TestApplicationViewProps) {
  const activity = useActivity(suite.activityId);
  const harness = useHarness(suite.id, activity.data?.version ?? 0);
  if (harness.isPending || activity.isPending) return <Loading what="the test application" />;
  if (!harness.data || !activity.data) {
    return (
      <ProblemAlert
        title="The test application could not be generated"
        error={harness.error ?? activity.error ?? new Error('The server did not answer.')}
      />
    );
  }
  const files = harness.data;
  const shown =
    files.find((file) => file.path === path) ?? files.find((file) => file.editable) ?? files[0];
  return (
    <div className={classes.sources}>
      <nav aria-label="Sources of the test application">
        {files.map((file) => (
          <button
            key={file.path}
            type="button"
            className={classes.source}
            aria-current={file === shown}
            onClick={() => {
              onPath(file.path);
            }}
          >
            <UserText>{file.path.slice(file.path.lastIndexOf('/') + 1)}</UserText>
            <Text size="xs" c="dimmed">
              {file.generated != null ? 'modified' : file.editable ? 'editable' : 'generated'}
            </Text>
          </button>
        ))}
      </nav>
      {shown &&
        (shown.editable && shown.keptPath ? (
          <Driver
            key={shown.path}
            activity={activity.data}
            file={shown}
            keptPath={shown.keptPath}
          />
        ) : (
          <CodeEditor label={`Text of ${shown.path}`} path={shown.path} text={shown.content} />
        ))}
    </div>
  );
}

interface DriverProps {
  activity: Activity;
  file: HarnessFile;
  keptPath: string;
}

function Driver({ activity, file, keptPath }: DriverProps) {
  const save = useChangeFiles(activity.id);
  const [edited, setEdited] = useState<string>();
  const [view, setView] = useState('edit');
  const text = edited ?? file.content;
  const generated = file.generated ?? file.content;
  const modified = file.generated != null;
  const changed = edited !== undefined && edited !== file.content;

  function saveFile(content: string | undefined) {
    save.mutate(
      {
        changes: [{ path: keptPath, ...(content !== undefined && { content }) }],
        version: activity.version,
      },
      {
        onSuccess: () => {
          setEdited(undefined);
        },
      },
    );
  }

  return (
    <Stack gap="sm">
      <Group justify="space-between">
        <SegmentedControl
          aria-label="View"
          size="xs"
          value={view}
          onChange={setView}
          data={[
            { value: 'edit', label: 'Edit' },
            { value: 'difference', label: 'Compare with generated' },
          ]}
        />
        <Group gap="xs">
          <Button
            size="xs"
            variant="default"
            disabled={!modified}
            loading={save.isPending}
            onClick={() => {
              saveFile(undefined);
            }}
          >
            Restore generated version
          </Button>
          <Button
            size="xs"
            disabled={!changed}
            loading={save.isPending}
            onClick={() => {
              saveFile(edited);
            }}
          >
            Save
          </Button>
        </Group>
      </Group>
      <Text size="sm" c="dimmed">
        Saved in the activity as <UserText>{keptPath}</UserText>. It is never overwritten.
      </Text>
      {save.isError && (
        <ProblemAlert title="The driver was not saved" error={save.error} onClose={save.reset} />
      )}
      {view === 'edit' ? (
        <CodeEditor
          label={`Text of ${file.path}`}
          path={file.path}
          text={text}
          onChange={setEdited}
        />
      ) : (
        <Difference label="Concrete test driver" path={file.path} before={generated} now={text} />
      )}
    </Stack>
  );
}
