import { Button, Checkbox, Group, Stack, Table, Text, TextInput } from '@mantine/core';
import { useState } from 'react';
import type { Webhook, WebhookEvent } from '@/shared/api';
import { Age, Loading, ProblemAlert, ScrollTable, SecretForm, UserText } from '@/shared/ui';
import { Deliveries } from './Deliveries';
import { useAddWebhook, useDeleteWebhook, useWebhooks, WEBHOOK_EVENTS } from './queries';

const EVENT_LABELS: Record<WebhookEvent, string> = {
  'build.finished': 'A build has ended',
  'commit.started': 'The tests of a commit have started',
  'commit.finished': 'The tests of a commit have ended, with the differences',
};

/** URLs of other systems that are called when builds and commits end, for administrators. */
export function Webhooks() {
  const webhooks = useWebhooks();
  const add = useAddWebhook();
  const remove = useDeleteWebhook();
  const [url, setUrl] = useState('');
  const [activity, setActivity] = useState('');
  const [events, setEvents] = useState<WebhookEvent[]>([...WEBHOOK_EVENTS]);
  const [shown, setShown] = useState<string>();
  if (webhooks.isPending) return <Loading what="webhooks" />;
  if (!webhooks.data) {
    return <ProblemAlert title="The webhooks could not be read" error={webhooks.error} />;
  }

  const deleteWebhook = (webhook: Webhook) => {
    remove.mutate(webhook.id, {
      onSuccess: () => {
        if (add.data?.webhook.id === webhook.id) add.reset();
        if (shown === webhook.id) setShown(undefined);
      },
    });
  };

  return (
    <Stack gap="sm">
      <Text c="dimmed">
        Another system, for example a bot or a CI server, gets a signed message of each event. Its
        host must be in the setting <code>sitaf.webhooks.allowed-hosts</code> of the server.
      </Text>
      <SecretForm
        issue={add}
        variables={{ url, ...(activity !== '' && { activity }), events }}
        action="Create webhook"
        failed="The webhook was not created"
        secretOf={({ webhook, secret }) => ({
          title: `Secret of the webhook to ${webhook.url}`,
          secret,
          instructions: (
            <Text size="sm">
              The header <code>Sitaf-Signature</code> is <code>t=SECONDS,v1=HEX</code>, where HEX is
              the HMAC-SHA-256 of <code>SECONDS.BODY</code> with this secret.
            </Text>
          ),
        })}
      >
        <TextInput
          label="URL"
          type="url"
          required
          w={340}
          value={url}
          onChange={(event) => {
            setUrl(event.currentTarget.value);
          }}
        />
        <TextInput
          label="Activity"
          placeholder="All"
          value={activity}
          onChange={(event) => {
            setActivity(event.currentTarget.value);
          }}
        />
        <Checkbox.Group
          label="Events"
          value={events}
          onChange={(values) => {
            setEvents(WEBHOOK_EVENTS.filter((event) => values.includes(event)));
          }}
        >
          <Stack gap={4}>
            {WEBHOOK_EVENTS.map((event) => (
              <Checkbox key={event} value={event} label={EVENT_LABELS[event]} />
            ))}
          </Stack>
        </Checkbox.Group>
      </SecretForm>
      {remove.isError && (
        <ProblemAlert
          title="The webhook was not deleted"
          error={remove.error}
          onClose={remove.reset}
        />
      )}
      {webhooks.data.items.length === 0 ? (
        <Text c="dimmed">No webhooks yet.</Text>
      ) : (
        <ScrollTable label="Webhooks" minWidth={640}>
          <Table.Thead>
            <Table.Tr>
              <Table.Th>URL</Table.Th>
              <Table.Th>Activity</Table.Th>
              <Table.Th>Events</Table.Th>
              <Table.Th>Created</Table.Th>
              <Table.Th aria-label="Actions" />
            </Table.Tr>
          </Table.Thead>
          <Table.Tbody>
            {webhooks.data.items.map((webhook) => (
              <Table.Tr key={webhook.id}>
                <Table.Td>
                  <UserText>{webhook.url}</UserText>
                </Table.Td>
                <Table.Td>
                  {webhook.activity === undefined ? 'All' : <UserText>{webhook.activity}</UserText>}
                </Table.Td>
                <Table.Td>{webhook.events.join(', ')}</Table.Td>
                <Table.Td>
                  <Age at={webhook.created} />
                </Table.Td>
                <Table.Td>
                  <Group gap="xs" justify="end" wrap="nowrap">
                    <Button
                      size="compact-xs"
                      variant="default"
                      aria-label={`Deliveries to ${webhook.url}`}
                      aria-expanded={shown === webhook.id}
                      onClick={() => {
                        setShown(shown === webhook.id ? undefined : webhook.id);
                      }}
                    >
                      Deliveries
                    </Button>
                    <Button
                      size="compact-xs"
                      variant="default"
                      aria-label={`Delete the webhook to ${webhook.url}`}
                      onClick={() => {
                        deleteWebhook(webhook);
                      }}
                    >
                      Delete
                    </Button>
                  </Group>
                </Table.Td>
              </Table.Tr>
            ))}
          </Table.Tbody>
        </ScrollTable>
      )}
      {shown !== undefined && <Deliveries key={shown} webhookId={shown} />}
    </Stack>
  );
}
