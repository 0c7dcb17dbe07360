import { Group } from '@mantine/core';
import { RouteLink, Section, UserText } from '@/shared/ui';
import { useFavourites } from './favourites';

/** Links to the favourites; nothing if there are none. */
export function FavouriteList() {
  const { favourites } = useFavourites();
  if (favourites.length === 0) return null;
  return (
    <Section title="Favourites">
      <Group gap="md">
        {favourites.map(({ id, name }) => (
          <RouteLink key={id} to="/activities/$activityId" params={{ activityId: id }} size="sm">
            <UserText>{name}</UserText>
          </RouteLink>
        ))}
      </Group>
    </Section>
  );
}
