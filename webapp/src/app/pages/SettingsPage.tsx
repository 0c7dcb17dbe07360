import { Stack, Title } from '@mantine/core';
import { Tokens, Users } from '@/features/access';
import { useSession } from '@/features/session';
import { Webhooks } from '@/features/webhooks';
import { Section } from '@/shared/ui';

export function SettingsPage() {
  const session = useSession();
  return (
    <Stack gap="xl">
      <title>Settings · SITAF</title>
      <Title order={1} size="h2">
        Settings
      </Title>
      <Section title="Access tokens">
        <Tokens />
      </Section>
      {session.data?.role === 'ADMINISTRATOR' && (
        <>
          <Section title="Users">
            <Users />
          </Section>
          <Section title="Webhooks">
            <Webhooks />
          </Section>
        </>
      )}
    </Stack>
  );
}
