import { Drawer, Stack, Text } from '@mantine/core';
import type { ReactNode } from 'react';
import type { ResultCase, ResultParameter } from '@/shared/api';
import { formatTime } from '@/shared/lib/format';
import { VERDICT_WORDS } from '@/shared/lib/verdicts';
import { UserText } from '@/shared/ui';
import { differenceOf } from './difference';
import classes from './results.module.css';

interface CaseDrawerProps {
  item: ResultCase | null;
  parameters: readonly ResultParameter[];
  onClose: () => void;
  /** What else can be done with a case; the app knows. */
  actions?: (item: ResultCase) => ReactNode;
  /** What else there is to see of a case, below its values. */
  details?: (item: ResultCase) => ReactNode;
}

/** All of a case, nothing cut. */
export function CaseDrawer({ item, parameters, onClose, actions, details }: CaseDrawerProps) {
  return (
    <Drawer
      opened={item !== null}
      onClose={onClose}
      position="right"
      size="lg"
      title={item ? `Case ${item.no}: ${VERDICT_WORDS[item.verdict].label}` : ''}
      closeButtonProps={{ 'aria-label': 'Close' }}
    >
      {item && (
        <Stack gap="md">
          {actions?.(item)}
          {item.message && (
            <Text className={classes.whole} role="note">
              <UserText>{item.message}</UserText>
            </Text>
          )}
          <dl className={classes.facts}>
            {parameters.map((parameter, index) => (
              <Fact
                key={parameter.name}
                name={`${parameter.name} (${parameter.type})`}
                value={item.values[index] ?? ''}
              />
            ))}
            {entriesOf(item.expected).map(([name, value]) => (
              <Fact key={`e ${name}`} name={`Expected ${name}`} value={value} />
            ))}
            {entriesOf(item.actual).map(([name, value]) => (
              <Fact key={`a ${name}`} name={`Measured ${name}`} value={value} />
            ))}
            <Fact
              name="Measured less expected"
              value={differenceOf(item.expected, item.actual) ?? '–'}
            />
            <Fact name="Time of the component (µs)" value={formatTime(item.processingTimeUs)} />
            <Fact name="In virtual hardware (µs)" value={formatTime(item.hardwareUs)} />
            <Fact name="In stubs (µs)" value={formatTime(item.stubUs)} />
          </dl>
          {details?.(item)}
        </Stack>
      )}
    </Drawer>
  );
}

function Fact({ name, value }: { name: string; value: string }) {
  return (
    <div>
      <dt>
        <UserText>{name}</UserText>
      </dt>
      <dd>
        <UserText>{value}</UserText>
      </dd>
    </div>
  );
}

function entriesOf(outputs: Record<string, string> | null | undefined): [string, string][] {
  return Object.entries(outputs ?? {});
}
