import { Stack, Text, Title } from '@mantine/core';
import type { ErrorComponentProps } from '@tanstack/react-router';
import { ProblemAlert, RouteLink } from '@/shared/ui';

export function NotFound() {
  return (
    <Stack gap="sm">
      <title>Page not found · SITAF</title>
      <Title order={1}>Page not found</Title>
      <Text>
        The address is wrong, or the page was deleted.{' '}
        <RouteLink to="/" underline="always">
          Home
        </RouteLink>
      </Text>
    </Stack>
  );
}

/** Replaces a page that failed to render. */
export function PageError({ error }: ErrorComponentProps) {
  return (
    <ProblemAlert
      title="This page could not be shown"
      error={error instanceof Error ? error : new Error(String(error))}
    />
  );
}
