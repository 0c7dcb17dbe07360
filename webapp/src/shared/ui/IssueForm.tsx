import { Alert, Button, Code, Group, Text } from '@mantine/core';
import type { UseMutationResult } from '@tanstack/react-query';
import type { ReactNode } from 'react';
import { ProblemAlert } from './ProblemAlert';

interface IssueFormProps<Issued, Wish> {
  /** Asks the server. */
  issue: UseMutationResult<Issued, Error, Wish>;
  /** What is asked for, as the fields say it. */
  wish: Wish;
  /** On the button. */
  action: string;
  /** The title of a refusal. */
  refused: string;
  secretOf: (issued: Issued) => {
    title: string;
    secret: string;
    /** What to do with it. */
    use?: ReactNode;
  };
  /** The fields. */
  children: ReactNode;
}

/** Asks for something that comes with a secret, which the server tells this once. */
export function IssueForm<Issued, Wish>(props: IssueFormProps<Issued, Wish>) {
  const { issue, wish, action, refused, secretOf, children } = props;
  const issued = issue.isSuccess ? secretOf(issue.data) : undefined;
  return (
    <>
      <form
        onSubmit={(event) => {
          event.preventDefault();
          issue.mutate(wish);
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
        <Alert role="status" color="petrol" variant="outline" title={issued.title}>
          <Code block>{issued.secret}</Code>
          <Text size="sm">Keep it now: it is not shown again.</Text>
          {issued.use}
        </Alert>
      )}
      {issue.isError && <ProblemAlert title={refused} error={issue.error} onClose={issue.reset} />}
    </>
  );
}
