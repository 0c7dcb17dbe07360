import {
  Button,
  Checkbox,
  FileButton,
  Group,
  Menu,
  NativeSelect,
  Popover,
  Stack,
} from '@mantine/core';
import { useEffect, useState } from 'react';
import type { Suite } from '@/shared/api';
import { Formula } from '@/shared/ui';
import type { ImportFormat } from './queries';
import type { Edits } from './useEdits';

interface GridToolsProps {
  suite: Suite;
  outputs: readonly string[];
  edits: Edits;
}

interface AllToolsProps extends GridToolsProps {
  /** Whether the cases are sequences; each step has its own expected values. */
  sequences: boolean;
}

const EXPORTS = [
  { label: 'CSV', path: 'cases.csv', ending: 'csv' },
  { label: 'JSON', path: 'cases.json', ending: 'json' },
  { label: 'XML', path: 'document', ending: 'xml' },
] as const;

/** Actions on all cases of a suite. */
export function GridTools({ suite, outputs, edits, sequences }: AllToolsProps) {
  useUndoKey(suite.undoable > 0, () => void edits.apply({ kind: 'undo' }));
  return (
    <Group gap="sm">
      {!sequences && <FillWithFormula suite={suite} outputs={outputs} edits={edits} />}
      <Button
        size="xs"
        variant="default"
        disabled={suite.undoable === 0 || edits.busy}
        title="Ctrl+Z outside text fields"
        onClick={() => void edits.apply({ kind: 'undo' })}
      >
        Undo
      </Button>
      <FileButton
        accept={sequences ? '.json,.xml' : '.csv,.json,.xml'}
        inputProps={{ 'aria-label': 'File with test cases' }}
        onChange={(file) => {
          const format = file && formatOf(file.name);
          if (!file || !format) return;
          void file.text().then((text) => edits.apply({ kind: 'import', format, text }));
        }}
      >
        {(props) => (
          <Button {...props} size="xs" variant="default">
            Import…
          </Button>
        )}
      </FileButton>
      <Menu position="bottom-start">
        <Menu.Target>
          <Button size="xs" variant="default">
            Export
          </Button>
        </Menu.Target>
        <Menu.Dropdown>
          {EXPORTS.map(({ label, path, ending }) => (
            <Menu.Item
              key={path}
              component="a"
              href={`/api/v1/suites/${encodeURIComponent(suite.id)}/${path}`}
              download={`${suite.name}.${ending}`}
            >
              {label}
            </Menu.Item>
          ))}
        </Menu.Dropdown>
      </Menu>
    </Group>
  );
}

function FillWithFormula({ suite, outputs, edits }: GridToolsProps) {
  const [opened, setOpened] = useState(false);
  const [expression, setExpression] = useState('');
  const [output, setOutput] = useState(outputs[0] ?? 'return');
  const [onlyEmpty, setOnlyEmpty] = useState(true);
  const words = [
    ...suite.parameters.map(({ name, type, realType }) => ({
      label: name,
      detail: `${type} ${realType}`,
    })),
    { label: 'valid', detail: 'true in cases without an invalid value' },
  ];
  return (
    <Popover
      opened={opened}
      onChange={setOpened}
      width={420}
      position="bottom-start"
      trapFocus
      withRoles
    >
      <Popover.Target>
        <Button
          size="xs"
          onClick={() => {
            setOpened(!opened);
          }}
        >
          Fill with formula
        </Button>
      </Popover.Target>
      <Popover.Dropdown aria-label="Fill expected values with a formula">
        <Stack gap="sm">
          {outputs.length > 1 && (
            <NativeSelect
              label="Output"
              data={[...outputs]}
              value={output}
              onChange={(event) => {
                setOutput(event.currentTarget.value);
              }}
            />
          )}
          <Formula
            label="Expected value"
            description="A CEL expression, such as: valid ? Distance : -1.0"
            text={expression}
            words={words}
            onChange={setExpression}
          />
          <Checkbox
            label="Only cases without an expected value"
            checked={onlyEmpty}
            onChange={(event) => {
              setOnlyEmpty(event.currentTarget.checked);
            }}
          />
          <Group>
            <Button
              size="xs"
              disabled={expression.trim() === ''}
              loading={edits.busy}
              onClick={() =>
                void edits
                  .apply({
                    kind: 'fill',
                    expression,
                    onlyEmpty,
                    ...(outputs.length > 1 && { output }),
                  })
                  .then((done) => {
                    if (done) setOpened(false);
                  })
              }
            >
              Fill
            </Button>
          </Group>
        </Stack>
      </Popover.Dropdown>
    </Popover>
  );
}

/** Ctrl+Z undoes the last change of the suite. Inside a text field, the browser handles it. */
function useUndoKey(enabled: boolean, undo: () => void) {
  useEffect(() => {
    const listen = (event: KeyboardEvent) => {
      const inField =
        event.target instanceof HTMLElement &&
        (event.target.matches('input, textarea, select') || event.target.isContentEditable);
      if (enabled && !inField && (event.ctrlKey || event.metaKey) && event.key === 'z') {
        event.preventDefault();
        undo();
      }
    };
    window.addEventListener('keydown', listen);
    return () => {
      window.removeEventListener('keydown', listen);
    };
  });
}

function formatOf(name: string): ImportFormat | undefined {
  return (['csv', 'json', 'xml'] as const).find((ending) => name.toLowerCase().endsWith(ending));
}
