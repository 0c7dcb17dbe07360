import { Group, NativeSelect, Stack, Title } from '@mantine/core';
import { getRouteApi } from '@tanstack/react-router';
import { fromIndex, toIndex, withoutAbsent, type BuildsSearch } from '@/app/search';
import { BuildList } from '@/features/builds';
import { labelOfState, STATES } from '@/shared/lib/buildStates';
import { SearchField } from '@/shared/ui';

const route = getRouteApi('/builds');

export function BuildsPage() {
  const { page, search, state } = route.useSearch();
  const navigate = route.useNavigate();
  const show = (wanted: {
    page?: number | undefined;
    search?: string | undefined;
    state?: BuildsSearch['state'] | undefined;
  }) => void navigate({ search: withoutAbsent<BuildsSearch>(wanted), resetScroll: false });
  return (
    <Stack gap="md">
      <title>Builds · SITAF</title>
      <Group justify="space-between">
        <Title order={1} size="h3">
          Builds
        </Title>
        <Group gap="sm">
          <SearchField
            label="Search builds"
            value={search}
            onSearch={(text) => {
              show({ search: text, state });
            }}
          />
          <NativeSelect
            aria-label="State"
            size="sm"
            value={state ?? ''}
            data={[
              { value: '', label: 'All states' },
              ...STATES.map((known) => ({ value: known, label: labelOfState(known) })),
            ]}
            onChange={(event) => {
              const chosen = event.currentTarget.value;
              show({ search, state: STATES.find((known) => known === chosen) });
            }}
          />
        </Group>
      </Group>
      <BuildList
        page={toIndex(page)}
        filter={{ search, state }}
        onPage={(index) => {
          show({ page: fromIndex(index), search, state });
        }}
      />
    </Stack>
  );
}
