import { Button } from '@mantine/core';
import type { Activity, ActivityModel } from '@/shared/api';
import type { StartBuild } from './useStartBuild';

interface BuildNowProps {
  activity: Activity;
  model: ActivityModel;
  start: StartBuild;
}

export function BuildNow({ activity, model, start }: BuildNowProps) {
  const mine =
    start.isPending &&
    start.variables.activityId === activity.id &&
    start.variables.model === model.name;
  return (
    <Button
      size="xs"
      aria-label={`Build now: ${activity.name} ${model.name}`}
      disabled={start.isPending}
      loading={mine}
      onClick={() => {
        start.mutate({ activityId: activity.id, model: model.name });
      }}
    >
      Build now
    </Button>
  );
}
