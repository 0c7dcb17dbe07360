import { Stack, Title } from '@mantine/core';
import { useNavigate } from '@tanstack/react-router';
import { NewFromGit } from '@/features/git';
import { BeginActivity } from '@/features/wizard';
import { Section } from '@/shared/ui';

export function NewActivityPage() {
  const navigate = useNavigate();
  return (
    <Stack gap="lg" maw={800}>
      <title>New activity · SITAF</title>
      <Title order={1} size="h2">
        New test activity
      </Title>
      <BeginActivity
        onCreated={({ activity, hasModels }) =>
          void navigate({
            to: '/activities/$activityId',
            params: { activityId: activity.id },
            search: { tab: hasModels ? 'overview' : 'files' },
          })
        }
      />
      <Section title="From a Git repository">
        <NewFromGit
          onCreated={(id) =>
            void navigate({
              to: '/activities/$activityId',
              params: { activityId: id },
              search: { tab: 'commits' },
            })
          }
        />
      </Section>
    </Stack>
  );
}
