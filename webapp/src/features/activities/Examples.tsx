import { Button, Group, Stack, Text } from '@mantine/core';
import { useNavigate } from '@tanstack/react-router';
import { useState } from 'react';
import { ProblemAlert } from '@/shared/ui';
import { useUploadActivity } from './queries';

/** Examples that the portal contains; `vite.config.ts` packs them. */
const EXAMPLES = [
  { name: 'ir-sensor-faulty', about: 'Infrared sensor in Java, with a fault' },
  { name: 'wall-approach', about: 'Mobile robot that stops before a wall, in Java' },
  { name: 'ir-sensor-python', about: 'Infrared sensor in Python' },
] as const;

/** Creates an activity from an example with one click. */
export function Examples() {
  const upload = useUploadActivity();
  const navigate = useNavigate();
  const [missing, setMissing] = useState<Error | null>(null);

  async function add(name: string) {
    setMissing(null);
    const answer = await fetch(`/assets/examples/${name}.zip`);
    if (!answer.ok) {
      setMissing(new Error(`The server answered ${answer.status}.`));
      return;
    }
    const { id } = await upload.mutateAsync(new File([await answer.blob()], `${name}.zip`));
    await navigate({ to: '/activities/$activityId', params: { activityId: id } });
  }

  const error = missing ?? upload.error;
  return (
    <Stack gap="xs">
      <Text size="sm" c="dimmed">
        Or begin with an example:
      </Text>
      <Group gap="sm">
        {EXAMPLES.map(({ name, about }) => (
          <Button
            key={name}
            variant="default"
            size="sm"
            disabled={upload.isPending}
            onClick={() => {
              add(name).catch((failure: unknown) => {
                // A rejected upload is shown below.
                if (failure instanceof TypeError) setMissing(failure);
              });
            }}
          >
            {about}
          </Button>
        ))}
      </Group>
      {error && <ProblemAlert title="The example was not added" error={error} />}
    </Stack>
  );
}
