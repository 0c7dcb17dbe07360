import { Table, Text } from '@mantine/core';
import { plural } from '@/shared/lib/format';
import { ScrollTable, UserText } from '@/shared/ui';
import { readingsIn, spreadFrames, type Recording } from './recording';
import classes from './replay.module.css';

/** More rows than anybody reads; what is between two of them moves with the slider. */
const MOST_ROWS = 100;

/** What the devices read, and the world shows, in a frame. */
export function Readings({ recording, frame }: { recording: Recording; frame: number }) {
  const values = readingsIn(recording, frame);
  if (values.length === 0) {
    return (
      <Text size="sm" c="dimmed">
        The world has no device that reads numbers.
      </Text>
    );
  }
  return (
    <dl className={classes.readings} aria-label="Readings at the time shown">
      {recording.columns.map((name, index) => (
        <div key={name}>
          <dt>
            <UserText>{name}</UserText>
          </dt>
          <dd>{formatReading(values[index])}</dd>
        </div>
      ))}
    </dl>
  );
}

/** The recording in numbers: for those who do not see it, and for those who want to know exactly. */
export function ReadingsTable({ recording }: { recording: Recording }) {
  const frames = spreadFrames(recording, MOST_ROWS);
  const [begin] = recording.times;
  return (
    <details className={classes.details}>
      <summary>
        Readings over time as a table ({plural(recording.times.length, 'frame')}
        {frames.length < recording.times.length && `, ${frames.length} of them shown`})
      </summary>
      <ScrollTable label="Readings over time" minWidth={120 + recording.columns.length * 110}>
        <Table.Thead>
          <Table.Tr>
            <Table.Th ta="right">Time (s)</Table.Th>
            {recording.columns.map((name) => (
              <Table.Th key={name} ta="right">
                <UserText>{name}</UserText>
              </Table.Th>
            ))}
          </Table.Tr>
        </Table.Thead>
        <Table.Tbody>
          {frames.map((frame) => (
            <Table.Tr key={frame}>
              <Table.Td ta="right">
                {((recording.times[frame] ?? 0) - (begin ?? 0)).toFixed(3)}
              </Table.Td>
              {readingsIn(recording, frame).map((value, index) => (
                <Table.Td key={index} ta="right">
                  {formatReading(value)}
                </Table.Td>
              ))}
            </Table.Tr>
          ))}
        </Table.Tbody>
      </ScrollTable>
    </details>
  );
}

/** As many digits as a recording keeps (32-bit floats). */
function formatReading(value: number | undefined): string {
  return value === undefined ? '–' : String(Number(value.toPrecision(6)));
}
