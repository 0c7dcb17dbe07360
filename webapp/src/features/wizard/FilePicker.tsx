import { Button, FileButton, Group, Stack, Text } from '@mantine/core';
import { useRef, useState, type DragEvent } from 'react';
import { plural } from '@/shared/lib/format';
import { ProblemAlert, UserText } from '@/shared/ui';
import type { Files } from './draft';
import classes from './wizard.module.css';

interface FilePickerProps {
  label: string;
  description: string;
  files: Files;
  onFiles: (files: Files) => void;
  /** Whether a whole folder may be chosen. */
  folder?: boolean;
  /** Whether a single file is expected. */
  single?: boolean;
  /** Whether the name of a chosen folder is part of the paths. */
  whole?: boolean;
}

/** Selects files, folders and zip files with a dialog or by drag and drop. */
export function FilePicker({
  label,
  description,
  files,
  onFiles,
  folder = false,
  single = false,
  whole = false,
}: FilePickerProps) {
  const [over, setOver] = useState(false);
  const [error, setError] = useState<Error>();
  const folderInput = useRef<HTMLInputElement>(null);

  async function addFiles(given: readonly { path: string; file: File }[]) {
    if (given.length === 0) return;
    try {
      const { filesFrom } = await import('./archive');
      const added = await filesFrom(given, whole);
      setError(undefined);
      onFiles(single ? new Map([...added].slice(0, 1)) : new Map([...files, ...added]));
    } catch (cause) {
      setError(cause instanceof Error ? cause : new Error(String(cause)));
    }
  }

  function drop(event: DragEvent) {
    event.preventDefault();
    setOver(false);
    const entries = [...event.dataTransfer.items].flatMap((item) => item.webkitGetAsEntry() ?? []);
    if (entries.length > 0) {
      void Promise.all(entries.map(filesBelow)).then((found) => addFiles(found.flat()));
    } else {
      void addFiles([...event.dataTransfer.files].map((file) => ({ path: file.name, file })));
    }
  }

  return (
    <div
      className={classes.zone}
      role="group"
      aria-label={label}
      data-over={over || undefined}
      onDragOver={(event) => {
        event.preventDefault();
        setOver(true);
      }}
      onDragLeave={() => {
        setOver(false);
      }}
      onDrop={drop}
    >
      <Stack gap="xs">
        <Group justify="space-between">
          <div>
            <Text fw={600}>{label}</Text>
            <Text size="sm" c="dimmed">
              {description}
            </Text>
          </div>
          <Group gap="xs">
            <FileButton
              multiple
              inputProps={{ 'aria-label': `Files: ${label}` }}
              onChange={(chosen) =>
                void addFiles(chosen.map((file) => ({ path: file.name, file })))
              }
            >
              {(props) => (
                <Button {...props} size="xs" variant="default">
                  Choose files…
                </Button>
              )}
            </FileButton>
            {folder && (
              <>
                <input
                  ref={folderInput}
                  type="file"
                  hidden
                  multiple
                  // React does not know this attribute; all browsers support it.
                  {...{ webkitdirectory: '' }}
                  aria-label={`Folder: ${label}`}
                  onChange={(event) =>
                    void addFiles(
                      [...(event.currentTarget.files ?? [])].map((file) => ({
                        path: file.webkitRelativePath || file.name,
                        file,
                      })),
                    )
                  }
                />
                <Button size="xs" variant="default" onClick={() => folderInput.current?.click()}>
                  Choose folder…
                </Button>
              </>
            )}
          </Group>
        </Group>
        {error && <ProblemAlert title="The files could not be read" error={error} />}
        {files.size > 0 && (
          <ul className={classes.list} aria-label={`${label}: ${plural(files.size, 'file')}`}>
            {[...files.keys()].map((path) => (
              <li key={path}>
                <UserText>{path}</UserText>{' '}
                <Button
                  size="compact-xs"
                  variant="subtle"
                  aria-label={`Remove ${path}`}
                  onClick={() => {
                    onFiles(new Map([...files].filter(([other]) => other !== path)));
                  }}
                >
                  Remove
                </Button>
              </li>
            ))}
          </ul>
        )}
      </Stack>
    </div>
  );
}

/** All files of a dropped file or folder, with their paths relative to it. */
async function filesBelow(entry: FileSystemEntry): Promise<{ path: string; file: File }[]> {
  if (entry.isFile) {
    const file = await new Promise<File>((resolve, reject) => {
      (entry as FileSystemFileEntry).file(resolve, reject);
    });
    return [{ path: entry.fullPath.slice(1), file }];
  }
  const reader = (entry as FileSystemDirectoryEntry).createReader();
  const all: FileSystemEntry[] = [];
  for (;;) {
    // A reader returns the entries in batches; the last one is empty.
    const batch = await new Promise<FileSystemEntry[]>((resolve, reject) => {
      reader.readEntries(resolve, reject);
    });
    if (batch.length === 0) break;
    all.push(...batch);
  }
  return (await Promise.all(all.map(filesBelow))).flat();
}
