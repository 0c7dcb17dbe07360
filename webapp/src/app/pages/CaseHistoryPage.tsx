import { Group, NumberInput, Stack, Title } from '@mantine/core';
import { getRouteApi } from '@tanstack/react-router';
import { useState } from 'react';
import { fromIndex, toIndex, withoutAbsent, type CaseHistorySearch } from '@/app/search';
import { useActivity } from '@/features/activities';
import { CaseHistory } from '@/features/history';
import { Breadcrumb, RouteLink, UserText } from '@/shared/ui';

const route = getRouteApi('/activities/$activityId/history/$model');

/** What a case did in all commits of a branch, or in all builds. */
export function CaseHistoryPage() {
  const { activityId, model } = route.useParams();
  const shown = route.useSearch();
  const navigate = route.useNavigate();
  const activity = useActivity(activityId);
  const no = shown.case ?? 1;
  const show = (changes: { [K in keyof CaseHistorySearch]: CaseHistorySearch[K] | undefined }) =>
    void navigate({
      search: withoutAbsent<CaseHistorySearch>({ ...shown, page: undefined, ...changes }),
      resetScroll: false,
    });
  return (
    <Stack gap="lg">
      <title>{`History of case ${no} · ${model} · SITAF`}</title>
      <Group justify="space-between" align="end">
        <div>
          <Breadcrumb>
            <RouteLink to="/activities">All activities</RouteLink>
            <RouteLink to="/activities/$activityId" params={{ activityId }}>
              <UserText>{activity.data?.name ?? activityId}</UserText>
            </RouteLink>
            {shown.build && (
              <RouteLink to="/builds/$buildId" params={{ buildId: shown.build }}>
                <UserText>{model}</UserText>
              </RouteLink>
            )}
          </Breadcrumb>
          <Title order={1} size="h3">
            <UserText>{`History of case ${no} of ${model}`}</UserText>
          </Title>
        </div>
        <CaseNumber
          key={no}
          no={no}
          onCase={(next) => {
            show({ case: next });
          }}
        />
      </Group>
      <CaseHistory
        testCase={{ activityId, model, no, build: shown.build, by: shown.points }}
        page={toIndex(shown.page)}
        onPage={(page) => {
          show({ page: fromIndex(page) });
        }}
        onPoints={(points) => {
          show({ points });
        }}
      />
    </Stack>
  );
}

/** Shows another case when the number is complete, not with each digit. */
function CaseNumber({ no, onCase }: { no: number; onCase: (no: number) => void }) {
  const [entered, setEntered] = useState<number | string>(no);
  const use = () => {
    const next = Number(entered);
    if (Number.isSafeInteger(next) && next >= 1 && next !== no) onCase(next);
  };
  return (
    <NumberInput
      label="Case"
      w={110}
      min={1}
      allowDecimal={false}
      value={entered}
      onChange={setEntered}
      onBlur={use}
      onKeyDown={({ key }) => {
        if (key === 'Enter') use();
      }}
    />
  );
}
