import type { ReactNode } from 'react';
import type { ResultCase, ResultParameter } from '@/shared/api';
import { formatCount, formatTime, plural } from '@/shared/lib/format';
import { VERDICT_LABELS } from '@/shared/lib/verdicts';
import { UserText } from '@/shared/ui';
import { CaseValues } from './CaseValues';
import classes from './results.module.css';

export type Trajectory = ResultCase['trajectories'][number];

interface CaseFactsProps {
  item: ResultCase;
  parameters: readonly ResultParameter[];
  /** A link to the moment when a trajectory condition was violated. */
  momentLink?: ((item: ResultCase, trajectory: Trajectory) => ReactNode) | undefined;
}

/** The inputs of a case, its expected and actual outputs, and its times. */
export function CaseFacts({ item, parameters, momentLink }: CaseFactsProps) {
  return (
    <>
      <CaseValues item={item} parameters={parameters} />
      <dl className={classes.facts}>
        {item.trajectories.map((trajectory) => (
          <Fact
            key={`t ${trajectory.name}`}
            name={`Condition over time: ${trajectory.name}`}
            value={describe(trajectory)}
            more={trajectory.verdict === 'FAIL' && momentLink?.(item, trajectory)}
          />
        ))}
        {item.repeated && <RepeatedFacts repeated={item.repeated} />}
        <Fact
          name={`Time in the component${item.repeated ? ', first call' : ''}`}
          value={formatTime(item.processingTimeUs)}
        />
        <Fact name="Time in virtual hardware" value={formatTime(item.hardwareUs)} />
        <Fact name="Time in stubs" value={formatTime(item.stubUs)} />
        {item.devices && <DeviceFacts devices={item.devices} />}
      </dl>
    </>
  );
}

/** The median of the repeated calls with its interval, and whether a call differs. */
function RepeatedFacts({ repeated }: { repeated: NonNullable<ResultCase['repeated']> }) {
  const { calls, warmUp, medianUs, lowUs, highUs, differs } = repeated;
  return (
    <>
      <Fact
        name={`Median of ${plural(calls, 'repeated call')} after ${plural(warmUp, 'call')} to warm up`}
        value={formatTime(medianUs)}
      />
      {lowUs !== undefined && highUs !== undefined && (
        <Fact
          name="95 % interval of the median"
          value={`${formatTime(lowUs)} to ${formatTime(highUs)}`}
        />
      )}
      {differs && <Fact name="Repeated calls differ" value={differs} />}
    </>
  );
}

/** What serves the devices, how late their time was, and what did not work. */
function DeviceFacts({ devices }: { devices: NonNullable<ResultCase['devices']> }) {
  return (
    <>
      <Fact name="Devices" value={devices.devices.join(', ')} />
      <Fact
        name="Jitter of the devices' time"
        value={`${milliseconds(devices.maxJitterMs)} at most, ${milliseconds(devices.meanJitterMs)} on average, ${plural(devices.missedDeadlines, 'missed deadline')}`}
      />
      {devices.readings > 0 && (
        <Fact
          name="Readings of real devices"
          value={`${formatCount(devices.readings)}, at most ${milliseconds(devices.maxAgeMs)} old, ${formatCount(devices.staleReadings)} too old`}
        />
      )}
      <Fact
        name="Safety of the devices"
        value={`${plural(devices.refusedCommands, 'command')} refused, ${plural(devices.safeStops, 'safe stop')}`}
      />
      {devices.faults.length > 0 && (
        <Fact name="Faults of the devices" value={devices.faults.join('; ')} />
      )}
    </>
  );
}

function milliseconds(value: number): string {
  return formatTime(value * 1000);
}

function Fact({ name, value, more }: { name: string; value: string; more?: ReactNode }) {
  return (
    <div>
      <dt>
        <UserText>{name}</UserText>
      </dt>
      <dd>
        <UserText>{value}</UserText> {more}
      </dd>
    </div>
  );
}

/** The verdict, when it was decided, and by how much. */
function describe({ verdict, at, margin }: Trajectory): string {
  if (at === undefined || margin === undefined) return VERDICT_LABELS[verdict].label;
  return `${VERDICT_LABELS[verdict].label} at ${short(at)} s, margin ${short(Number(margin))}`;
}

function short(value: number): string {
  return String(Number(value.toPrecision(6)));
}
