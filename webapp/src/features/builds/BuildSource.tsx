import { Text } from '@mantine/core';
import type { Build } from '@/shared/api';
import { shortCommit } from '@/shared/lib/commits';
import { UserText } from '@/shared/ui';

/** The commit and the labels of a build; nothing if there are none. */
export function BuildSource({ build: { commit, buildLabels } }: { build: Build }) {
  const labels = Object.entries(buildLabels).map(([key, value]) => `${key}=${value}`);
  const facts = [commit && `commit ${shortCommit(commit)}`, ...labels].filter(Boolean);
  if (facts.length === 0) return null;
  return (
    <Text size="xs" c="dimmed" title={commit}>
      <UserText>{facts.join(', ')}</UserText>
    </Text>
  );
}
