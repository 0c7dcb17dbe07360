import { Button, Stack } from '@mantine/core';
import { useState } from 'react';
import { UserText } from '@/shared/ui';
import { ReplayPair } from './ReplayPair';

interface RelationReplaysProps {
  buildId: string;
  caseNo: number;
  /** The names of the relations of the model, in its order; null for one without a second run. */
  relations: readonly (string | null)[];
}

/** For each relation of a case a button that shows the replays of both runs side by side. */
export function RelationReplays({ buildId, caseNo, relations }: RelationReplaysProps) {
  const [shown, setShown] = useState<number | null>(null);
  return relations.map((name, index) => {
    if (name === null) return null;
    const relation = index + 1;
    const open = shown === relation;
    return (
      <Stack key={name} gap="sm" align="stretch">
        <Button
          size="xs"
          variant="default"
          style={{ alignSelf: 'start' }}
          aria-expanded={open}
          onClick={() => {
            setShown(open ? null : relation);
          }}
        >
          <UserText>{`${open ? 'Hide' : 'Show'} both runs of “${name}”`}</UserText>
        </Button>
        {open && (
          <ReplayPair
            base={{ buildId, caseNo, label: 'First run' }}
            now={{ buildId, caseNo, relation, label: 'Second run' }}
          />
        )}
      </Stack>
    );
  });
}
