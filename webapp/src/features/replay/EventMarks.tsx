import { UserText } from '@/shared/ui';
import classes from './replay.module.css';

/** Something that happens in a case, on the time axis of its recording. */
export interface EventMark {
  kind: 'fault' | 'interval' | 'violation';
  /** Seconds of simulation time; a moment has no end. */
  from: number;
  to?: number | undefined;
  name: string;
  /** What it is, in words. */
  about: string;
}

interface EventMarksProps {
  events: readonly EventMark[];
  begin: number;
  end: number;
  onSeek: (time: number) => void;
}

/** Faults of devices, and intervals and violations of conditions, below the time axis: a row each. */
export function EventMarks({ events, begin, end, onSeek }: EventMarksProps) {
  const share = (time: number) =>
    end > begin ? Math.min(1, Math.max(0, (time - begin) / (end - begin))) * 100 : 0;
  return (
    <div className={classes.events} role="group" aria-label="Faults and conditions">
      {events.map((event, index) => {
        const from = share(event.from);
        const to = event.to === undefined ? from : share(event.to);
        return (
          <button
            key={index}
            type="button"
            className={classes.event}
            title={`${event.name}: ${event.about}`}
            aria-label={`${event.name}: ${event.about}`}
            onClick={() => {
              onSeek(Math.min(end, Math.max(begin, event.from)));
            }}
          >
            <span
              className={classes.span}
              data-kind={event.kind}
              style={{ left: `${from}%`, width: `${Math.max(0, to - from)}%` }}
            />
            <span className={classes.eventName} data-kind={event.kind}>
              <UserText>{event.name}</UserText>
            </span>
          </button>
        );
      })}
    </div>
  );
}
