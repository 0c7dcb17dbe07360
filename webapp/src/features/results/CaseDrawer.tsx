import { Drawer, Stack, Text } from '@mantine/core';
import type { ReactNode } from 'react';
import type { ResultCase, ResultParameter } from '@/shared/api';
import { VERDICT_LABELS } from '@/shared/lib/verdicts';
import { UserText } from '@/shared/ui';
import { CaseFacts, type Trajectory } from './CaseFacts';
import { RelationRuns } from './RelationRuns';
import { StepList } from './StepList';
import classes from './results.module.css';

interface CaseDrawerProps {
  item: ResultCase | null;
  parameters: readonly ResultParameter[];
  onClose: () => void;
  /** More details of a case, provided by the app. */
  details?: (item: ResultCase) => ReactNode;
  momentLink?: ((item: ResultCase, trajectory: Trajectory) => ReactNode) | undefined;
}

/** All data of a case. */
export function CaseDrawer({ item, parameters, onClose, details, momentLink }: CaseDrawerProps) {
  return (
    <Drawer
      opened={item !== null}
      onClose={onClose}
      position="right"
      size={item && item.steps.length > 0 ? 'xl' : 'lg'}
      title={item ? `Case ${item.no}: ${VERDICT_LABELS[item.verdict].label}` : ''}
      closeButtonProps={{ 'aria-label': 'Close' }}
    >
      {item && (
        <Stack gap="md">
          {item.message && (
            <Text className={classes.whole} role="note">
              <UserText>{item.message}</UserText>
            </Text>
          )}
          <StepList steps={item.steps} />
          <CaseFacts item={item} parameters={parameters} momentLink={momentLink} />
          <RelationRuns item={item} parameters={parameters} />
          {details?.(item)}
        </Stack>
      )}
    </Drawer>
  );
}
