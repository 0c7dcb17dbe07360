import type { ReactNode } from 'react';
import type { ResultCase, ResultParameter } from '@/shared/api';
import { formatTime, plural } from '@/shared/lib/format';
import { UserText } from '@/shared/ui';
import { differenceOf } from './difference';
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
    <dl className={classes.facts}>
      {parameters.map((parameter, index) => (
        <Fact
          key={parameter.name}
          name={`${parameter.name} (${parameter.type})`}
          value={item.values[index] ?? ''}
        />
      ))}
      {entriesOf(item.expected).map(([name, value]) => (
        <Fact key={`e ${name}`} name={`Expected ${name}`} value={value} />
      ))}
      {entriesOf(item.actual).map(([name, value]) => (
        <Fact key={`a ${name}`} name={`Actual ${name}`} value={value} />
      ))}
      {entriesOf(item.actual).map(([name, value]) => {
        const difference = differenceOf(item.expected?.[name], value);
        return (
          difference !== null && (
            <Fact key={`d ${name}`} name={`Actual − expected ${name}`} value={difference} />
          )
        );
      })}
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
        name={`Time in the component${item.repeated ? ', first call' : ''} (µs)`}
        value={formatTime(item.processingTimeUs)}
      />
      <Fact name="Time in virtual hardware (µs)" value={formatTime(item.hardwareUs)} />
      <Fact name="Time in stubs (µs)" value={formatTime(item.stubUs)} />
    </dl>
  );
}

/** The median of the repeated calls with its interval, and whether a call differs. */
function RepeatedFacts({ repeated }: { repeated: NonNullable<ResultCase['repeated']> }) {
  const { calls, warmUp, medianUs, lowUs, highUs, differs } = repeated;
  return (
    <>
      <Fact
        name={`Median of ${plural(calls, 'repeated call')} after ${plural(warmUp, 'call')} to warm up (µs)`}
        value={formatTime(medianUs)}
      />
      {lowUs !== undefined && highUs !== undefined && (
        <Fact
          name="95 % interval of the median (µs)"
          value={`${formatTime(lowUs)} to ${formatTime(highUs)}`}
        />
      )}
      {differs && <Fact name="Repeated calls differ" value={differs} />}
    </>
  );
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
  if (at === undefined || margin === undefined) return verdict;
  return `${verdict} at ${at.toString()} s, margin ${margin}`;
}

function entriesOf(outputs: Record<string, string> | null | undefined): [string, string][] {
  return Object.entries(outputs ?? {});
}
