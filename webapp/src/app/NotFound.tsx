import { Stack, Text, Title } from '@mantine/core';
import type { ErrorComponentProps } from '@tanstack/react-router';
import { ProblemAlert, RouteLink } from '@/shared/ui';

export function NotFound() {
  return (
    <Stack gap="sm">
      <title>No such page · SITAF</title>
      <Title order={1}>No such page</Title>
      <Text>
        The address is wrong, or the page is gone.{' '}
        <RouteLink to="/" underline="always">
          To the activities
        </RouteLink>
      </Text>
    </Stack>
  );
}

/** A page that broke; the rest of the portal stands. */
export function PageError({ error }: ErrorComponentProps) {
  return (
    <ProblemAlert
      title="This page could not be shown"
      error={error instanceof Error ? error : new Error(String(error))}
    />
  );
}
