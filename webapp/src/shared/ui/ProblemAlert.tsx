import { Alert, Stack, Text } from '@mantine/core';
import { ApiError } from '@/shared/api';
import { Diagnostics } from './Diagnostics';
import { UserText } from './UserText';

interface ProblemAlertProps {
  /** A sentence such as "The build was not requested". */
  title: string;
  error: Error;
  onClose?: () => void;
}

/** A failed request, with the message and the diagnostics of the server. */
export function ProblemAlert({ title, error, onClose }: ProblemAlertProps) {
  const diagnostics = error instanceof ApiError ? error.diagnostics : [];
  // The detail of a problem repeats its diagnostics, which are shown as a list.
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
