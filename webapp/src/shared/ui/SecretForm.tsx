import { Alert, Button, Code, Group, Text } from '@mantine/core';
import type { UseMutationResult } from '@tanstack/react-query';
import type { ReactNode } from 'react';
import { ProblemAlert } from './ProblemAlert';

interface SecretFormProps<Issued, Variables> {
  /** The request. */
  issue: UseMutationResult<Issued, Error, Variables>;
  /** The variables of the request, from the fields. */
  variables: Variables;
  /** Label of the button. */
  action: string;
  /** Title of the error message. */
  failed: string;
  secretOf: (issued: Issued) => {
    title: string;
    secret: string;
    /** How to use the secret. */
    instructions?: ReactNode;
  };
  /** The fields. */
  children: ReactNode;
}

/** A form that creates something with a secret, which is shown only once. */
export function SecretForm<Issued, Variables>(props: SecretFormProps<Issued, Variables>) {
  const { issue, variables, action, failed, secretOf, children } = props;
  const issued = issue.isSuccess ? secretOf(issue.data) : undefined;
  return (
    <>
      <form
        onSubmit={(event) => {
          event.preventDefault();
          issue.mutate(variables);
        }}
      >
        <Group align="end">
          {children}
          <Button type="submit" loading={issue.isPending}>
            {action}
          </Button>
        </Group>
      </form>
      {issued && (
        <Alert
          role="status"
          color="petrol"
          variant="outline"
          title={issued.title}
          style={{ overflowWrap: 'anywhere' }}
        >
          <Code block>{issued.secret}</Code>
          <Text size="sm">Copy it now. It is not shown again.</Text>
          {issued.instructions}
        </Alert>
      )}
      {issue.isError && <ProblemAlert title={failed} error={issue.error} onClose={issue.reset} />}
    </>
  );
}
