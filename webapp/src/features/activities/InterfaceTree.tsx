import { Badge, Group, Stack, Table, Text } from '@mantine/core';
import type { ActivityDescription } from '@/shared/api';
import { Diagnostics, Loading, ProblemAlert, ScrollTable, Section, UserText } from '@/shared/ui';
import classes from './activities.module.css';
import { useDescription } from './queries';

type Interface = ActivityDescription['provided'][number];
type Method = Interface['methods'][number];
type Type = Method['returnType'];

/** The provided and required methods of a component with their resolved types. */
export function InterfaceTree({ activityId }: { activityId: string }) {
  const description = useDescription(activityId);
  if (description.isPending) return <Loading what="the interfaces" />;
  if (!description.data) {
    return <ProblemAlert title="The interfaces could not be read" error={description.error} />;
  }
  const { provided, required, world, warnings } = description.data;
  return (
    <Stack gap="xl">
      {warnings.length > 0 && <Diagnostics items={warnings} />}
      <Section title="Provided">
        <Interfaces interfaces={provided} none="The component provides no interfaces." />
      </Section>
      <Section title="Required">
        <Interfaces
          interfaces={required}
          none="The component requires no interfaces, so the test needs no stub."
        />
      </Section>
      <Section title="World">
        {world ? (
          <World world={world} />
        ) : (
          <Text c="dimmed">The activity needs no simulation.</Text>
        )}
      </Section>
    </Stack>
  );
}

function Interfaces({ interfaces, none }: { interfaces: readonly Interface[]; none: string }) {
  if (interfaces.length === 0) return <Text c="dimmed">{none}</Text>;
  return (
    <ul className={classes.tree}>
      {interfaces.map((item) => (
        <li key={item.name}>
          <details open>
            <summary>
              <strong>
                <UserText>{item.name}</UserText>
              </strong>{' '}
              <Text span size="sm" c="dimmed">
                <UserText>{item.source}</UserText>
              </Text>
            </summary>
            <ul className={classes.tree}>
              {item.methods.map((method) => (
                <li key={`${method.name}(${method.signature})`}>
                  <MethodNode method={method} />
                </li>
              ))}
            </ul>
          </details>
        </li>
      ))}
    </ul>
  );
}

function MethodNode({ method }: { method: Method }) {
  return (
    <details open={method.parameters.length > 0}>
      <summary>
        <code>
          <UserText>{`${method.returnType.spelling} ${method.name}(${method.signature})`}</UserText>
        </code>{' '}
        {method.callType !== 'BLOCKING' && (
          <Badge size="sm" variant="outline" color="gray">
            {method.callType.toLowerCase()}
          </Badge>
        )}
      </summary>
      <ul className={classes.tree}>
        {method.parameters.map(({ name, direction, type }) => (
          <li key={name}>
            <TypeNode name={`${direction.toLowerCase()} ${name}`} type={type} />
          </li>
        ))}
        <li>
          <TypeNode name="returns" type={method.returnType} />
        </li>
        {method.raises.length > 0 && (
          <li>
            raises <UserText>{method.raises.join(', ')}</UserText>
          </li>
        )}
      </ul>
    </details>
  );
}

function TypeNode({ name, type }: { name: string; type: Type }) {
  const line = (
    <>
      <UserText>{name}</UserText>:{' '}
      <code>
        <UserText>{type.spelling}</UserText>
      </code>
      {type.kind === 'unknown' && (
        <Text span size="sm" c="red">
          {' '}
          unknown type
        </Text>
      )}
      {type.literals.length > 0 && (
        <Text span size="sm" c="dimmed">
          {' '}
          <UserText>{type.literals.join(' | ')}</UserText>
        </Text>
      )}
    </>
  );
  if (
    type.members.length === 0 ||
    type.members.every(({ type: { members } }) => members.length === 0 && type.kind !== 'struct')
  ) {
    return <span>{line}</span>;
  }
  return (
    <details>
      <summary>{line}</summary>
      <ul className={classes.tree}>
        {type.members.map((member) => (
          <li key={member.name}>
            <TypeNode name={member.name} type={member.type} />
          </li>
        ))}
      </ul>
    </details>
  );
}

function World({ world }: { world: NonNullable<ActivityDescription['world']> }) {
  return (
    <Stack gap="sm">
      <Text size="sm" c="dimmed">
        <UserText>{world.path}</UserText>
      </Text>
      <ScrollTable label="Parameters of the world" minWidth={480}>
        <Table.Thead>
          <Table.Tr>
            <Table.Th>Parameter (TDSD)</Table.Th>
            <Table.Th>Unit</Table.Th>
            <Table.Th ta="right">From</Table.Th>
            <Table.Th ta="right">To</Table.Th>
            <Table.Th ta="right">Default</Table.Th>
          </Table.Tr>
        </Table.Thead>
        <Table.Tbody>
          {world.parameters.map((parameter) => (
            <Table.Tr key={parameter.name}>
              <Table.Td>
                <UserText>{parameter.name}</UserText>
              </Table.Td>
              <Table.Td>
                <UserText>{parameter.unit}</UserText>
              </Table.Td>
              <Table.Td ta="right">{parameter.min}</Table.Td>
              <Table.Td ta="right">{parameter.max}</Table.Td>
              <Table.Td ta="right">{parameter.defaultValue}</Table.Td>
            </Table.Tr>
          ))}
        </Table.Tbody>
      </ScrollTable>
      <Group gap="xs">
        <Text size="sm">Devices:</Text>
        {world.devices.map(({ name, kind }) => (
          <Badge key={name} variant="outline" color="gray" tt="none">
            <UserText>{`${name} (${kind})`}</UserText>
          </Badge>
        ))}
      </Group>
      {world.observations.length > 0 && (
        <Text size="sm">
          Observations: <UserText>{world.observations.join(', ')}</UserText>
        </Text>
      )}
    </Stack>
  );
}
