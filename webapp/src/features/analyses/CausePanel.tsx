import { Anchor, Button, Group, Paper, Stack, Text } from '@mantine/core';
import { useState, type ReactNode } from 'react';
import type { Build, BuildAnalysis, Explanation } from '@/shared/api';
import { ProblemAlert, Section, UserText } from '@/shared/ui';
import { AnalysisButton, AnalysisProgress } from './AnalysisProgress';
import { BoundaryLine } from './BoundaryLine';
import { FailingRegion } from './FailingRegion';
import { isEnded, useAnalysis, useRunSimplest } from './queries';
import { groupsOf, regionOf, type CauseGroup, type ExecutedCase } from './region';

interface CausePanelProps {
  build: Build;
  /** The executed cases of the build, as far as they are loaded. */
  cases: readonly ExecutedCase[];
  caseLink: (no: number) => ReactNode;
  /** Opens a build that was requested. */
  onBuild: (id: string) => void;
}

/** The causes of the failures of a build, and the button that requests them. */
export function CausePanel({ build, cases, caseLink, onBuild }: CausePanelProps) {
  const analysis = useAnalysis(build.id, 'explanation');
  const { summary } = build;
  const failed = summary ? summary.fail + summary.error : 0;
  if (failed === 0 || build.suspicions.length > 0) return null;
  const latest = analysis.data ?? undefined;
  return (
    <Section
      title="Causes"
      actions={
        analysis.isSuccess &&
        (!latest || isEnded(latest)) && (
          <AnalysisButton
            buildId={build.id}
            kind="explanation"
            label={latest ? 'Explain again' : 'Explain'}
          />
        )
      }
    >
      {analysis.isError && (
        <ProblemAlert title="The causes could not be read" error={analysis.error} />
      )}
      {analysis.isSuccess && !latest && (
        <Text size="sm" c="dimmed">
          {`Explain searches the smallest sets of values that fail, with further cases on an agent.`}
        </Text>
      )}
      {latest && <AnalysisProgress buildId={build.id} kind="explanation" analysis={latest} />}
      {latest?.explanation && (
        <Causes
          build={build}
          analysis={latest}
          explanation={latest.explanation}
          cases={cases}
          caseLink={caseLink}
          onBuild={onBuild}
        />
      )}
    </Section>
  );
}

interface CausesProps extends CausePanelProps {
  analysis: BuildAnalysis;
  explanation: Explanation;
}

/** A reader looks at the first causes; drawing hundreds of them takes seconds. */
const SHOWN_CAUSES = 10;
const MORE_CAUSES = 50;

function Causes({ build, explanation, cases, caseLink, onBuild }: CausesProps) {
  const { causes, executions, unexplained } = explanation;
  const [shownCauses, setShownCauses] = useState(SHOWN_CAUSES);
  const groups = groupsOf(causes);
  const left = groups.length - shownCauses;
  return (
    <Stack gap="md">
      {groups.slice(0, shownCauses).map((group) => (
        <CauseDetails
          key={group.position}
          build={build}
          group={group}
          explanation={explanation}
          cases={cases}
          caseLink={caseLink}
          onBuild={onBuild}
        />
      ))}
      {left > 0 && (
        <Group gap="sm">
          <Button
            variant="default"
            size="xs"
            onClick={() => {
              setShownCauses(shownCauses + MORE_CAUSES);
            }}
          >
            {`Show ${Math.min(left, MORE_CAUSES)} more causes`}
          </Button>
          <Text size="sm" c="dimmed">
            {`${shownCauses} of ${groups.length} are shown.`}
          </Text>
        </Group>
      )}
      {unexplained.length > 0 && (
        <Text size="sm">
          Not explained: <CaseNumbers cases={unexplained} caseLink={caseLink} />. The failures are
          not reproducible, or too many further cases are needed.
        </Text>
      )}
      <Text size="sm" c="dimmed">
        {executions === 1 ? '1 further case was' : `${executions} further cases were`} executed.
      </Text>
    </Stack>
  );
}

interface CauseDetailsProps extends CausePanelProps {
  group: CauseGroup;
  explanation: Explanation;
}

function CauseDetails({ build, group, explanation, cases, caseLink, onBuild }: CauseDetailsProps) {
  const { first, position } = group;
  const run = useRunSimplest(build.id);
  const { boundary } = first;
  const input = explanation.inputs.find(({ name }) => name === boundary?.parameter);
  const region = regionOf(first, explanation, cases);
  const bundle = `/api/v1/builds/${encodeURIComponent(build.id)}/explanation/causes/${position}/bundle`;
  return (
    <Paper withBorder p="md" role="group" aria-label={`Cause ${position}`}>
      <Stack gap="xs">
        <Text fw={600}>
          <UserText>{capitalized(first.sentence)}</UserText>
        </Text>
        <Text size="sm">
          {`${first.verdict} in ${group.cases.length === 1 ? 'case ' : `${group.cases.length} cases: `}`}
          <CaseNumbers cases={group.cases} caseLink={caseLink} />
        </Text>
        {first.message !== '' && (
          <Text size="sm">
            <UserText>{first.message}</UserText>
          </Text>
        )}
        {first.simplest.length > 0 && (
          <Text size="sm">
            {first.steps.length > 0 ? 'Set before the first step: ' : 'Simplest case: '}
            <UserText>
              {first.simplest.map(({ name, literal }) => `${name} = ${shown(literal)}`).join(', ')}
            </UserText>
          </Text>
        )}
        {boundary && input && <BoundaryLine boundary={boundary} input={input} />}
        {region && <FailingRegion region={region} />}
        {first.record.length > 0 && (
          <Group gap="md">
            <Button
              variant="default"
              size="xs"
              loading={run.isPending}
              onClick={() => {
                run.mutate(position, {
                  onSuccess: ({ id }) => {
                    onBuild(id);
                  },
                });
              }}
            >
              Run again
            </Button>
            <Anchor size="sm" href={bundle} download={`cause-${position}.zip`}>
              Download bundle
            </Anchor>
          </Group>
        )}
        {run.isError && (
          <ProblemAlert title="The case was not requested" error={run.error} onClose={run.reset} />
        )}
      </Stack>
    </Paper>
  );
}

const SHOWN_CASES = 20;

function CaseNumbers({
  cases,
  caseLink,
}: {
  cases: readonly number[];
  caseLink: (no: number) => ReactNode;
}) {
  return (
    <>
      {cases.slice(0, SHOWN_CASES).map((no, index) => (
        <span key={no}>
          {index > 0 && ', '}
          {caseLink(no)}
        </span>
      ))}
      {cases.length > SHOWN_CASES && ` and ${cases.length - SHOWN_CASES} more`}
    </>
  );
}

function capitalized(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}

function shown(literal: string): string {
  return literal === '' ? '""' : literal;
}
