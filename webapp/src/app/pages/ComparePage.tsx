import { Stack, Text, Title } from '@mantine/core';
import { getRouteApi } from '@tanstack/react-router';
import { NotFound } from '@/app/NotFound';
import { fromIndex, toIndex, withoutAbsent, type CompareSearch } from '@/app/search';
import { useBuild } from '@/features/builds';
import { ValueDifferences } from '@/features/comparison';
import { ResultComparison } from '@/features/history';
import { ReplayPair } from '@/features/replay';
import { ResultProvenance, useResult } from '@/features/results';
import { callTime, useSignals } from '@/features/signals';
import { shortCommit } from '@/shared/lib/commits';
import { formatInstant } from '@/shared/lib/format';
import { Loading, RouteLink, Section, UserText } from '@/shared/ui';

const route = getRouteApi('/builds/$buildId/compare');

/** Compares the results of two builds: values, verdicts and times. */
export function ComparePage() {
  const { buildId } = route.useParams();
  const search = route.useSearch();
  const navigate = route.useNavigate();
  const { with: other } = search;
  if (!other) return <NotFound />;
  const show = (shown: CompareSearch) => void navigate({ search: shown, resetScroll: false });
  return (
    <Stack gap="xl">
      <title>Comparison · SITAF</title>
      <div>
        <Title order={1} size="h2">
          Comparison of two builds
        </Title>
        <Text>
          <BuildName buildId={buildId} /> compared with <BuildName buildId={other} />
        </Text>
      </div>
      <ValueDifferences
        buildId={buildId}
        other={other}
        group={search.group}
        page={toIndex(search.page)}
        onGroup={(group) => {
          show(withoutAbsent<CompareSearch>({ with: other, group }));
        }}
        onPage={(page) => {
          show(withoutAbsent<CompareSearch>({ ...search, page: fromIndex(page) }));
        }}
        onReplays={({ no, baseNo, at }) => {
          show(withoutAbsent<CompareSearch>({ ...search, case: no, other: baseNo, at }));
        }}
      />
      {search.case !== undefined && (
        <Replays
          buildId={buildId}
          other={other}
          no={search.case}
          otherNo={search.other ?? search.case}
          at={search.at}
        />
      )}
      <ResultComparison buildId={buildId} other={other} />
      <Executed title="This build" buildId={buildId} />
      <Executed title="The other build" buildId={other} />
    </Stack>
  );
}

function BuildName({ buildId }: { buildId: string }) {
  const build = useBuild(buildId);
  return (
    <RouteLink to="/builds/$buildId" params={{ buildId }} underline="always">
      {build.data ? (
        <UserText>
          {[
            build.data.model,
            formatInstant(build.data.created),
            build.data.commit && `commit ${shortCommit(build.data.commit)}`,
          ]
            .filter(Boolean)
            .join(', ')}
        </UserText>
      ) : (
        buildId
      )}
    </RouteLink>
  );
}

function Replays({
  buildId,
  other,
  no,
  otherNo,
  at,
}: {
  buildId: string;
  other: string;
  no: number;
  otherNo: number;
  at: number | undefined;
}) {
  const signals = useSignals(buildId, no);
  return (
    <Section title={`Case ${no} in both builds`}>
      {signals.isPending ? (
        <Loading what="the recordings" />
      ) : (
        <ReplayPair
          base={{ buildId: other, caseNo: otherNo, label: 'Before' }}
          now={{ buildId, caseNo: no, label: 'Now' }}
          divergesAt={(recording) =>
            at === undefined ? undefined : callTime(signals.data ?? null, recording) + at
          }
        />
      )}
    </Section>
  );
}

function Executed({ title, buildId }: { title: string; buildId: string }) {
  const result = useResult(buildId);
  return (
    <details>
      <summary>{title}: what was executed</summary>
      {result.data && <ResultProvenance provenance={result.data.provenance} />}
    </details>
  );
}
