import { Box, Group, Stack, Table, Text } from '@mantine/core';
import type { ReactNode } from 'react';
import type { Activity, ActivityModel } from '@/shared/api';
import { Age, Loading, Pager, ProblemAlert, RouteLink, ScrollTable, UserText } from '@/shared/ui';
import { Examples } from './Examples';
import { FavouriteButton } from './FavouriteButton';
import { ACTIVITIES_PER_PAGE, useActivities } from './queries';
import { TagLinks } from './Tags';

interface ActivityListProps {
  page: number;
  onPage: (page: number) => void;
  /** A part of the names; without it, all activities are listed. */
  search?: string | undefined;
  /** A tag of the activities. */
  tag?: string | undefined;
  /** The actions on a test model, provided by the app. */
  modelAction: (activity: Activity, model: ActivityModel) => ReactNode;
}

export function ActivityList({ page, onPage, search, tag, modelAction }: ActivityListProps) {
  const activities = useActivities(page, search, tag);
  if (activities.isPending) return <Loading what="activities" />;
  if (!activities.data) {
    return <ProblemAlert title="The activities could not be read" error={activities.error} />;
  }
  const { items, total } = activities.data;
  if (total === 0 && (search ?? tag)) return <Text c="dimmed">No activity matches.</Text>;
  if (total === 0) {
    return (
      <Stack gap="xs">
        <Text c="dimmed">No activities yet. Create one, or upload a zip file.</Text>
        <Examples />
      </Stack>
    );
  }
  return (
    <Stack gap="xs">
      <ScrollTable label="Activities" minWidth={720}>
        <Table.Thead>
          <Table.Tr>
            <Table.Th miw={200}>Activity</Table.Th>
            <Table.Th>Component</Table.Th>
            <Table.Th>Test models</Table.Th>
            <Table.Th>Last changed</Table.Th>
          </Table.Tr>
        </Table.Thead>
        <Table.Tbody>
          {items.map((activity) => (
            <ActivityRow key={activity.id} activity={activity} modelAction={modelAction} />
          ))}
        </Table.Tbody>
      </ScrollTable>
      <Pager
        label="Pages of activities"
        page={page}
        size={ACTIVITIES_PER_PAGE}
        total={total}
        onPage={onPage}
      />
    </Stack>
  );
}

function ActivityRow({
  activity,
  modelAction,
}: {
  activity: Activity;
  modelAction: ActivityListProps['modelAction'];
}) {
  return (
    <Table.Tr>
      <Table.Td>
        <Group gap={4} wrap="nowrap">
          <FavouriteButton activity={activity} />
          <RouteLink
            to="/activities/$activityId"
            params={{ activityId: activity.id }}
            fw={600}
            size="sm"
          >
            <UserText>{activity.name}</UserText>
          </RouteLink>
        </Group>
        {activity.description && (
          <Text size="sm" c="dimmed">
            <UserText>{activity.description}</UserText>
          </Text>
        )}
        {activity.tags.length > 0 && <TagLinks tags={activity.tags} />}
      </Table.Td>
      <Table.Td>
        <UserText>{activity.language}</UserText>
        {activity.componentClass && (
          <Text size="sm" c="dimmed">
            <UserText>{activity.componentClass}</UserText>
          </Text>
        )}
      </Table.Td>
      <Table.Td>
        <Stack gap={6}>
          {activity.models.map((model) => (
            <Group key={model.name} gap="sm" justify="space-between" wrap="nowrap">
              <UserText>{model.name}</UserText>
              <Box flex="none">{modelAction(activity, model)}</Box>
            </Group>
          ))}
        </Stack>
      </Table.Td>
      <Table.Td>
        <Age at={activity.updated} />
      </Table.Td>
    </Table.Tr>
  );
}
