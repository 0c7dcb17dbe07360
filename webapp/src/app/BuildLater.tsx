import { Button, Popover, Stack, Text, TextInput } from '@mantine/core';
import { useState, type SyntheticEvent } from 'react';
import { useReserveBuild } from '@/features/schedules';
import { formatInstant } from '@/shared/lib/format';
import { ProblemAlert, RouteLink } from '@/shared/ui';

/** Reserves a build at a time to come. */
export function BuildLater({ suiteId }: { suiteId: string }) {
  const reserve = useReserveBuild();
  const [at, setAt] = useState('');
  const zone = Intl.DateTimeFormat().resolvedOptions().timeZone;

  function submit(event: SyntheticEvent) {
    event.preventDefault();
    const time = new Date(at);
    if (!Number.isNaN(time.getTime())) reserve.mutate({ suiteId, at: withOffset(time) });
  }

  return (
    <Popover width={320} position="bottom-end" trapFocus withRoles>
      <Popover.Target>
        <Button variant="default">Build later</Button>
      </Popover.Target>
      <Popover.Dropdown aria-label="Build at a time to come">
        <form onSubmit={submit}>
          <Stack gap="sm">
            <TextInput
              type="datetime-local"
              label="At"
              description={`Time zone ${zone}`}
              required
              value={at}
              onChange={(event) => {
                setAt(event.currentTarget.value);
              }}
            />
            <Button type="submit" loading={reserve.isPending}>
              Reserve
            </Button>
            {reserve.isSuccess && (
              <Text size="sm" role="status">
                Reserved for {formatInstant(reserve.data.next ?? reserve.variables.at)}.{' '}
                <RouteLink to="/schedules" underline="always" size="sm">
                  All schedules
                </RouteLink>
              </Text>
            )}
            {reserve.isError && <ProblemAlert title="It was not reserved" error={reserve.error} />}
          </Stack>
        </form>
      </Popover.Dropdown>
    </Popover>
  );
}

/** As the clock on the wall shows it, with the zone that it is in. */
function withOffset(time: Date): string {
  const minutes = -time.getTimezoneOffset();
  const two = (value: number) => String(Math.floor(Math.abs(value))).padStart(2, '0');
  const wall = new Date(time.getTime() + minutes * 60_000).toISOString().slice(0, 19);
  return `${wall}${minutes < 0 ? '-' : '+'}${two(minutes / 60)}:${two(minutes % 60)}`;
}
