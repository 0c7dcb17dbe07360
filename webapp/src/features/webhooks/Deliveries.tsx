import { Table, Text } from '@mantine/core';
import type { WebhookDelivery } from '@/shared/api';
import { Age, Loading, ProblemAlert, RouteLink, ScrollTable, UserText } from '@/shared/ui';
import { useDeliveries } from './queries';

const STATES: Record<WebhookDelivery['state'], string> = {
  WAITING: 'Waiting',
  DELIVERED: 'Delivered',
  GIVEN_UP: 'Failed',
};

/** The latest messages of a webhook, and what the receiver answered. */
export function Deliveries({ webhookId }: { webhookId: string }) {
  const deliveries = useDeliveries(webhookId);
  if (deliveries.isPending) return <Loading what="deliveries" />;
  if (!deliveries.data) {
    return <ProblemAlert title="The deliveries could not be read" error={deliveries.error} />;
  }
  if (deliveries.data.items.length === 0) {
    return <Text c="dimmed">Nothing was sent yet.</Text>;
  }
  return (
    <ScrollTable label="Deliveries" minWidth={640}>
      <Table.Thead>
        <Table.Tr>
          <Table.Th>Created</Table.Th>
          <Table.Th>Event</Table.Th>
          <Table.Th>Of</Table.Th>
          <Table.Th>State</Table.Th>
          <Table.Th>Attempts</Table.Th>
          <Table.Th>Last answer</Table.Th>
        </Table.Tr>
      </Table.Thead>
      <Table.Tbody>
        {deliveries.data.items.map((delivery) => (
          <Table.Tr key={delivery.id}>
            <Table.Td>
              <Age at={delivery.created} />
            </Table.Td>
            <Table.Td>{delivery.event}</Table.Td>
            <Table.Td>
              {delivery.buildId === undefined ? (
                delivery.commit?.slice(0, 10)
              ) : (
                <RouteLink to="/builds/$buildId" params={{ buildId: delivery.buildId }}>
                  Build
                </RouteLink>
              )}
            </Table.Td>
            <Table.Td>{STATES[delivery.state]}</Table.Td>
            <Table.Td>{delivery.tries}</Table.Td>
            <Table.Td>
              {delivery.lastAnswer !== undefined && <UserText>{delivery.lastAnswer}</UserText>}
            </Table.Td>
          </Table.Tr>
        ))}
      </Table.Tbody>
    </ScrollTable>
  );
}
