import { Anchor, Group, SegmentedControl, Stack } from '@mantine/core';
import type { ResultSummary as Summary, Verdict } from '@/shared/api';
import { formatCount } from '@/shared/lib/format';
import { Loading, ProblemAlert, Section } from '@/shared/ui';
import { useResult } from './queries';
import { ResultSummary } from './ResultSummary';
import { ResultTable } from './ResultTable';
import { VERDICTS, VERDICT_WORDS, countOf } from './verdicts';

interface ResultViewProps {
  buildId: string;
  page: number;
  verdict?: Verdict | undefined;
  onShow: (shown: { page: number; verdict?: Verdict | undefined }) => void;
}

/** The result of a build: summary, and the table of its cases by verdict. */
export function ResultView({ buildId, page, verdict, onShow }: ResultViewProps) {
  const result = useResult(buildId);
  if (result.isPending) return <Loading what="the result" />;
  if (!result.data) {
    return <ProblemAlert title="The result could not be read" error={result.error} />;
  }
  const { summary, parameters } = result.data;
  return (
    <Stack gap="lg">
      <Section title="Result" actions={<Downloads buildId={buildId} />}>
        <ResultSummary summary={summary} />
      </Section>
      <Section
        title="Cases"
        actions={
          <VerdictFilter
            summary={summary}
            verdict={verdict}
            onVerdict={(next) => {
              onShow({ page: 0, verdict: next });
            }}
          />
        }
      >
        <ResultTable
          buildId={buildId}
          parameters={parameters}
          page={page}
          onPage={(next) => {
            onShow({ page: next, verdict });
          }}
          {...(verdict && { verdict })}
        />
      </Section>
    </Stack>
  );
}

function Downloads({ buildId }: { buildId: string }) {
  const result = `/api/v1/builds/${encodeURIComponent(buildId)}/result`;
  return (
    <Group gap="md">
      <Anchor size="sm" href={`${result}/document`} download={`result-${buildId}.xml`}>
        Result XML
      </Anchor>
      <Anchor size="sm" href={`${result}/junit`} download={`junit-${buildId}.xml`}>
        JUnit XML
      </Anchor>
    </Group>
  );
}

function VerdictFilter({
  summary,
  verdict,
  onVerdict,
}: {
  summary: Summary;
  verdict: Verdict | undefined;
  onVerdict: (verdict: Verdict | undefined) => void;
}) {
  return (
    <SegmentedControl
      aria-label="Cases shown"
      size="sm"
      value={verdict ?? 'ALL'}
      onChange={(value) => {
        onVerdict(VERDICTS.find((known) => known === value));
      }}
      data={[
        { value: 'ALL', label: `All ${formatCount(summary.total)}` },
        ...VERDICTS.map((known) => ({
          value: known,
          label: `${VERDICT_WORDS[known].label} ${formatCount(countOf(summary, known))}`,
        })),
      ]}
    />
  );
}
