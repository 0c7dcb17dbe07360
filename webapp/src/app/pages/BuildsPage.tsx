import { Stack, Title } from '@mantine/core';
import { getRouteApi } from '@tanstack/react-router';
import { fromIndex, toIndex, withoutAbsent, type ListSearch } from '@/app/search';
import { BuildList } from '@/features/builds';

const route = getRouteApi('/builds');

export function BuildsPage() {
  const { page } = route.useSearch();
  const navigate = route.useNavigate();
  return (
    <Stack gap="lg">
      <title>Builds · SITAF</title>
      <Title order={1} size="h2">
        Builds
      </Title>
      <BuildList
        page={toIndex(page)}
        onPage={(index) =>
          void navigate({
            search: withoutAbsent<ListSearch>({ page: fromIndex(index) }),
            resetScroll: false,
          })
        }
      />
    </Stack>
  );
}
