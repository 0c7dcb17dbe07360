import { Button, Group } from '@mantine/core';
import type { Schedule } from '@/shared/api';
import type { useScheduleAction, ScheduleAction } from './queries';
import { titleOf } from './words';

interface ScheduleActionsProps {
  schedule: Schedule;
  act: ReturnType<typeof useScheduleAction>;
  size?: string;
  onDeleted?: () => void;
}

/** Pauses, resumes, runs or deletes a schedule. */
export function ScheduleActions({
  schedule,
  act,
  size = 'compact-xs',
  onDeleted,
}: ScheduleActionsProps) {
  const action = (name: ScheduleAction, label: string) => (
    <Button
      size={size}
      variant="default"
      aria-label={`${label}: ${titleOf(schedule)}`}
      disabled={act.isPending}
      onClick={() => {
        act.mutate(
          { id: schedule.id, action: name },
          { onSuccess: () => (name === 'delete' ? onDeleted?.() : undefined) },
        );
      }}
    >
      {label}
    </Button>
  );
  return (
    <Group gap="xs" justify="flex-end" wrap="nowrap">
      {schedule.paused ? action('resume', 'Resume') : schedule.next && action('pause', 'Pause')}
      {action('run', 'Run now')}
      {action('delete', 'Delete')}
    </Group>
  );
}
