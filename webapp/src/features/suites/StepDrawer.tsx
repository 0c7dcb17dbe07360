import { Drawer, Stack, Table, Text } from '@mantine/core';
import type { SuiteCase } from '@/shared/api';
import { ScrollTable, UserText } from '@/shared/ui';

interface StepDrawerProps {
  /** Null if the drawer is closed. */
  item: SuiteCase | null;
  /** Names of the initial values. */
  parameters: readonly string[];
  onClose: () => void;
}

/** The steps of a sequence with their values. */
export function StepDrawer({ item, parameters, onClose }: StepDrawerProps) {
  return (
    <Drawer
      opened={item !== null}
      onClose={onClose}
      position="right"
      size="xl"
      title={item ? `Case ${item.no}: ${item.valid ? 'valid' : 'invalid'}` : ''}
      closeButtonProps={{ 'aria-label': 'Close' }}
    >
      {item && (
        <Stack gap="md">
          {parameters.length > 0 && (
            <Text size="sm">
              From the beginning:{' '}
              <UserText>
                {parameters
                  .map((name, index) => `${name} = ${item.values[index] ?? ''}`)
                  .join(', ')}
              </UserText>
            </Text>
          )}
          <ScrollTable label="Steps" minWidth={420}>
            <Table.Thead>
              <Table.Tr>
                <Table.Th ta="right">No</Table.Th>
                <Table.Th>Step</Table.Th>
                <Table.Th>Inputs</Table.Th>
                <Table.Th>Expected</Table.Th>
              </Table.Tr>
            </Table.Thead>
            <Table.Tbody>
              {item.steps.map((step, index) => (
                <Table.Tr key={index} data-class={step.valid ? 'valid' : 'invalid'}>
                  <Table.Td ta="right">{index + 1}</Table.Td>
                  <Table.Td>
                    <UserText>{step.name}</UserText>
                    {!step.valid && (
                      <Text size="xs" c="dimmed">
                        forbidden, or with an invalid value
                      </Text>
                    )}
                  </Table.Td>
                  <Values values={step.inputs} named />
                  <Values values={step.expected} named={Object.keys(step.expected).length > 1} />
                </Table.Tr>
              ))}
            </Table.Tbody>
          </ScrollTable>
        </Stack>
      )}
    </Drawer>
  );
}

function Values({ values, named }: { values: Record<string, string>; named: boolean }) {
  return (
    <Table.Td>
      {Object.entries(values).map(([name, value]) => (
        <Text key={name} size="xs" ff="monospace">
          <UserText>{named ? `${name} = ${value}` : value}</UserText>
        </Text>
      ))}
    </Table.Td>
  );
}
