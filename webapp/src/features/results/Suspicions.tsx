import { Alert, List } from '@mantine/core';
import { UserText } from '@/shared/ui';

/** The reasons why the verdicts of a result cannot be trusted, if any. */
export function Suspicions({ reasons }: { reasons: readonly string[] }) {
  if (reasons.length === 0) return null;
  return (
    <Alert color="red" title="Suspect: the verdicts cannot be trusted" mb="sm">
      <List size="sm">
        {reasons.map((reason) => (
          <List.Item key={reason}>
            <UserText>{reason}</UserText>
          </List.Item>
        ))}
      </List>
    </Alert>
  );
}
