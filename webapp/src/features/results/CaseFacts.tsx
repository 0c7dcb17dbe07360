import type { ResultCase, ResultParameter } from '@/shared/api';
import { formatTime } from '@/shared/lib/format';
import { UserText } from '@/shared/ui';
import { differenceOf } from './difference';
import classes from './results.module.css';

interface CaseFactsProps {
  item: ResultCase;
  parameters: readonly ResultParameter[];
}

/** What a case was given, what was expected of it, and what came of it. */
export function CaseFacts({ item, parameters }: CaseFactsProps) {
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
        <Fact key={`a ${name}`} name={`Measured ${name}`} value={value} />
      ))}
      <Fact name="Measured less expected" value={differenceOf(item.expected, item.actual) ?? '–'} />
      <Fact name="Time of the component (µs)" value={formatTime(item.processingTimeUs)} />
      <Fact name="In virtual hardware (µs)" value={formatTime(item.hardwareUs)} />
      <Fact name="In stubs (µs)" value={formatTime(item.stubUs)} />
    </dl>
  );
}

function Fact({ name, value }: { name: string; value: string }) {
  return (
    <div>
      <dt>
        <UserText>{name}</UserText>
      </dt>
      <dd>
        <UserText>{value}</UserText>
      </dd>
    </div>
  );
}

function entriesOf(outputs: Record<string, string> | null | undefined): [string, string][] {
  return Object.entries(outputs ?? {});
}
