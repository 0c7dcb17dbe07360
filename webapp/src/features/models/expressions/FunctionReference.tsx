import { Code, Stack, Table, Text } from '@mantine/core';
import { ScrollTable, Section } from '@/shared/ui';

const GROUPS: readonly { title: string; functions: string; note: string }[] = [
  {
    title: 'Names',
    functions: 'pi e inf nan',
    note: 'and the constants and enumeration literals of the interfaces, such as Spin_Result.TIMEOUT',
  },
  {
    title: 'Numbers',
    functions:
      'abs min max clamp(x, low, high) sign floor ceil round sqrt cbrt pow exp log log10 hypot is_finite is_nan',
    note: 'nan outside of the domain; the division of two whole numbers is whole',
  },
  {
    title: 'Angles',
    functions: 'sin cos tan asin acos atan atan2 sinh cosh tanh wrap_angle angle_difference(a, b)',
    note: 'in radians; wrap_angle gives (-pi, pi]',
  },
  {
    title: 'Comparison',
    functions: 'near(a, b, absolute) near(a, b, absolute, relative)',
    note: 'numbers, sequences and structs',
  },
  {
    title: 'Vectors and matrices',
    functions: 'sum mean norm dot cross is_sorted matmul transpose det identity(n)',
    note: 'a vector is a sequence, or a struct with x, y and z; a matrix is a sequence of rows',
  },
  {
    title: 'Quaternions',
    functions: 'qmul(a, b) qconj qnorm qrotate(q, v) qangle(q, p)',
    note: 'structs with x, y, z and w',
  },
  {
    title: 'Outcomes',
    functions: '"!error:NAME" "!error" "!any"',
    note: 'an expected exception, any exception, and a value that is not judged',
  },
];

/** The functions that expressions offer in addition to those of CEL. */
export function FunctionReference() {
  return (
    <Section title="Functions of expressions">
      <Stack gap="xs">
        <Text size="sm" c="dimmed">
          The preview checks every expression when it changes.
        </Text>
        <ScrollTable label="Functions of expressions" minWidth={600}>
          <Table.Tbody>
            {GROUPS.map(({ title, functions, note }) => (
              <Table.Tr key={title}>
                <Table.Th>{title}</Table.Th>
                <Table.Td>
                  <Code>{functions}</Code>
                </Table.Td>
                <Table.Td>{note}</Table.Td>
              </Table.Tr>
            ))}
          </Table.Tbody>
        </ScrollTable>
      </Stack>
    </Section>
  );
}
