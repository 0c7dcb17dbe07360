import { Button, Checkbox, Group, TextInput } from '@mantine/core';
import { useState } from 'react';
import type { CallDraft } from '../document';

interface CallSettingsProps {
  call: CallDraft;
  onChange: (call: CallDraft) => void;
  onRemove: () => void;
}

/** The times around a call, shown on request. */
export function CallSettings({ call, onChange, onRemove }: CallSettingsProps) {
  const given = call.settle !== '' || call.runFor !== '' || call.overlap === 'true';
  const [shown, setShown] = useState(given);
  return (
    <>
      {shown && (
        <>
          <Group gap={6} wrap="nowrap" align="end">
            <TextInput
              size="xs"
              label="Before (s)"
              aria-label={`Before (s) ${call.name}`}
              placeholder="0"
              value={call.settle}
              onChange={(event) => {
                onChange({ ...call, settle: event.currentTarget.value });
              }}
            />
            <TextInput
              size="xs"
              label="After (s)"
              aria-label={`After (s) ${call.name}`}
              placeholder="0"
              value={call.runFor}
              onChange={(event) => {
                onChange({ ...call, runFor: event.currentTarget.value });
              }}
            />
          </Group>
          <Checkbox
            size="xs"
            label="The next step begins while it runs"
            aria-label={`The next step begins while it runs: ${call.name}`}
            checked={call.overlap === 'true'}
            onChange={(event) => {
              onChange({ ...call, overlap: event.currentTarget.checked ? 'true' : '' });
            }}
          />
        </>
      )}
      <Group gap={6}>
        {!shown && (
          <Button
            size="compact-xs"
            variant="subtle"
            aria-label={`Times of ${call.name}`}
            onClick={() => {
              setShown(true);
            }}
          >
            Times
          </Button>
        )}
        <Button
          size="compact-xs"
          variant="subtle"
          aria-label={`Remove call ${call.name}`}
          onClick={onRemove}
        >
          Remove
        </Button>
      </Group>
    </>
  );
}
