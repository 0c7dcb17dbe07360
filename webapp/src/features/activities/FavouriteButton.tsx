import { ActionIcon } from '@mantine/core';
import { useFavourites, type Favourite } from './favourites';

/** Marks an activity as a favourite. */
export function FavouriteButton({ activity: { id, name } }: { activity: Favourite }) {
  const { isFavourite, toggle } = useFavourites();
  const marked = isFavourite(id);
  return (
    <ActionIcon
      variant="subtle"
      size="sm"
      color={marked ? 'yellow' : 'gray'}
      aria-pressed={marked}
      aria-label={`Favourite: ${name}`}
      onClick={() => {
        toggle({ id, name });
      }}
    >
      <span aria-hidden>{marked ? '★' : '☆'}</span>
    </ActionIcon>
  );
}
