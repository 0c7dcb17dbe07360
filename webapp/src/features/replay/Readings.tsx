import { Table, Text } from '@mantine/core';
import { plural } from '@/shared/lib/format';
import { ScrollTable, UserText } from '@/shared/ui';
import { readingsIn, spreadFrames, type Recording } from './recording';
import classes from './replay.module.css';

/** Maximum number of rows; the slider shows the frames between them. */
const MAX_ROWS = 100;

/** The readings of the devices and the observations in a frame. */
export function Readings({ recording, frame }: { recording: Recording; frame: number }) {
  const values = readingsIn(recording, frame);
  if (values.length === 0) {
    return (
      <Text size="sm" c="dimmed">
        The world has no devices with numeric readings.
      </Text>
    );
  }
  return (
    <dl className={classes.readings} aria-label="Current readings">
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

/** The readings over time as a table, also for screen readers. */
export function ReadingsTable({ recording }: { recording: Recording }) {
  const frames = spreadFrames(recording, MAX_ROWS);
  const [begin] = recording.times;
  return (
    <details className={classes.details}>
      <summary>
        Table of readings ({plural(recording.times.length, 'frame')}
        {frames.length < recording.times.length && `, ${frames.length} shown`})
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

/** Six digits: recordings hold 32-bit floats. */
function formatReading(value: number | undefined): string {
  return value === undefined ? '–' : String(Number(value.toPrecision(6)));
}
