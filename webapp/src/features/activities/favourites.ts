import { useLocalStorage } from '@mantine/hooks';

/** An activity that the user has marked. */
export interface Favourite {
  id: string;
  name: string;
}

const MAX_FAVOURITES = 50;

/** The marked activities by name, kept in this browser. */
export function useFavourites() {
  const [favourites, setFavourites] = useLocalStorage<Favourite[]>({
    key: 'sitaf-favourites',
    defaultValue: [],
    deserialize: readFavourites,
  });
  return {
    favourites,
    isFavourite: (id: string) => favourites.some((known) => known.id === id),
    toggle: ({ id, name }: Favourite) => {
      const others = favourites.filter((known) => known.id !== id);
      setFavourites(
        others.length < favourites.length
          ? others
          : [...others, { id, name }]
              .slice(-MAX_FAVOURITES)
              .toSorted((a, b) => a.name.localeCompare(b.name)),
      );
    },
  };
}

/** Damaged entries of the browser's store are ignored. */
function readFavourites(text: string | undefined): Favourite[] {
  try {
    const stored: unknown = JSON.parse(text ?? '[]');
    return Array.isArray(stored) ? stored.filter(isFavourite) : [];
  } catch {
    return [];
  }
}

function isFavourite(entry: unknown): entry is Favourite {
  return (
    typeof entry === 'object' &&
    entry !== null &&
    'id' in entry &&
    typeof entry.id === 'string' &&
    'name' in entry &&
    typeof entry.name === 'string'
  );
}
