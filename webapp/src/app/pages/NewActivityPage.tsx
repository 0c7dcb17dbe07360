import { Stack, Title } from '@mantine/core';
import { useNavigate } from '@tanstack/react-router';
import { Wizard } from '@/features/wizard';

export function NewActivityPage() {
  const navigate = useNavigate();
  return (
    <Stack gap="lg">
      <title>New activity · SITAF</title>
      <Title order={1} size="h2">
        New test activity
      </Title>
      <Wizard
        onCreated={({ id }) =>
          void navigate({
            to: '/activities/$activityId',
            params: { activityId: id },
            search: { tab: 'files' },
          })
        }
      />
    </Stack>
  );
}
