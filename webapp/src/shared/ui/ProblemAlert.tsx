import { Alert, Stack, Text } from '@mantine/core';
import { ApiError } from '@/shared/api';
import { Diagnostics } from './Diagnostics';
import { UserText } from './UserText';

interface ProblemAlertProps {
  /** What was tried, as a sentence: "The upload was refused". */
  title: string;
  error: Error;
  onClose?: () => void;
}

/** A failed request: what was tried, what the server says, and where the input is wrong. */
export function ProblemAlert({ title, error, onClose }: ProblemAlertProps) {
  const diagnostics = error instanceof ApiError ? error.diagnostics : [];
  // The detail repeats the diagnostics in one text; in a list they are easier to read.
  const text = error instanceof ApiError && diagnostics.length > 0 ? error.title : error.message;
  return (
    <Alert
      role="alert"
      color="red"
      variant="outline"
      title={title}
      {...(onClose && { withCloseButton: true, closeButtonLabel: 'Dismiss', onClose })}
    >
      <Stack gap="xs">
        <Text size="sm">
          <UserText>{text}</UserText>
        </Text>
        {diagnostics.length > 0 && <Diagnostics items={diagnostics} />}
      </Stack>
    </Alert>
  );
}
