import { Group, Stack, Text, Title } from '@mantine/core';
import { getRouteApi } from '@tanstack/react-router';
import { RunCaseAgain } from '@/app/building';
import { NotFound } from '@/app/NotFound';
import { CaseLog, useBuild } from '@/features/builds';
import { CaseReplay, RelationReplays, useRecordedCases, type StepMark } from '@/features/replay';
import { CaseFacts, RelationRuns, StepList, useResult, useCase } from '@/features/results';
import { callTime, SignalPlot, useSignals } from '@/features/signals';
import { useStateDiagram } from '@/features/states';
import { ApiError, type StepResult } from '@/shared/api';
import { decides } from '@/shared/lib/steps';
import { VERDICT_LABELS } from '@/shared/lib/verdicts';
import { Breadcrumb, Loading, ProblemAlert, RouteLink, Section, UserText } from '@/shared/ui';
import { eventsOf } from './caseEvents';
import { DebugCase } from './DebugCase';

const route = getRouteApi('/builds/$buildId/cases/$caseNo');

/** The 3D replay of a case with its signals and its result. */
export function ReplayPage() {
  const { buildId, caseNo } = route.useParams();
  const { at, condition } = route.useSearch();
  const navigate = route.useNavigate();
  const build = useBuild(buildId);
  const no = Number(caseNo);
  const done = build.data?.state === 'DONE';
  const item = useCase(buildId, done ? no : undefined);
  const result = useResult(buildId, done);
  const signals = useSignals(buildId, no);
  const steps = item.data?.steps ?? [];
  const diagram = useStateDiagram(buildId, steps.length > 0);
  if (!Number.isSafeInteger(no) || no < 1) return <NotFound />;
  if (build.isPending) return <Loading what="the build" />;
  if (!build.data) {
    return build.error instanceof ApiError && build.error.status === 404 ? (
      <NotFound />
    ) : (
      <ProblemAlert title="The build could not be read" error={build.error} />
    );
  }
  const { activityId, model, activityName } = build.data;
  return (
    <Stack gap="sm">
      <title>{`${item.data ? `${VERDICT_LABELS[item.data.verdict].sign} ` : ''}Case ${no} · ${model} · SITAF`}</title>
      <Group justify="space-between" align="end">
        <div>
          <Breadcrumb>
            <RouteLink to="/activities">All activities</RouteLink>
            <RouteLink to="/activities/$activityId" params={{ activityId }}>
              <UserText>{activityName}</UserText>
            </RouteLink>
            <RouteLink to="/builds/$buildId" params={{ buildId }}>
              <UserText>{model}</UserText>
            </RouteLink>
          </Breadcrumb>
          <Title order={1} size="h3">
            Case {no}
          </Title>
        </div>
        <Group gap="sm">
          {done && !build.data.parentId && (
            <RouteLink
              to="/activities/$activityId/history/$model"
              params={{ activityId, model }}
              search={{ build: buildId, case: no }}
              size="sm"
            >
              History of the case
            </RouteLink>
          )}
          {done && <RunCaseAgain build={build.data} no={no} />}
          <DebugCase build={build.data} no={no} />
          <Neighbours key={buildId} buildId={buildId} no={no} />
        </Group>
      </Group>
      <CaseReplay
        key={no}
        build={build.data}
        caseNo={no}
        verdict={item.data?.verdict}
        facts={
          done && (
            <Stack gap="sm" miw={0}>
              <CaseOfResult buildId={buildId} no={no} />
              <CaseLog buildId={buildId} no={no} />
            </Stack>
          )
        }
        events={(recording) =>
          eventsOf(
            item.data,
            result.data?.parameters ?? [],
            signals.data ?? null,
            callTime(signals.data ?? null, recording),
          )
        }
        loading={signals.isPending || (done && item.isPending)}
        startAt={(recording) =>
          at === undefined ? undefined : callTime(signals.data ?? null, recording) + at
        }
        marks={(recording) =>
          marksOf(
            steps,
            signals.data
              ? callTime(signals.data, recording)
              : (recording.times[0] ?? 0) + (diagram.data?.settleS ?? 0),
          )
        }
        plot={(recording, playback) => (
          <>
            {signals.error && (
              <ProblemAlert title="The signals could not be read" error={signals.error} />
            )}
            <SignalPlot
              signals={signals.data ?? null}
              readings={recording}
              results={item.data?.trajectories ?? []}
              playback={playback}
              condition={condition}
              at={at}
            />
          </>
        )}
        onRequested={({ id }) => {
          void navigate({ to: '/builds/$buildId', params: { buildId: id } });
        }}
      />
      <RelationReplays
        key={`relations ${no}`}
        buildId={buildId}
        caseNo={no}
        relations={(item.data?.relations ?? []).map(({ name, values }) =>
          values.length > 0 ? name : null,
        )}
      />
    </Stack>
  );
}

/** The executed steps on the time axis of the recording. */
function marksOf(steps: readonly StepResult[], begin: number): StepMark[] {
  return steps.flatMap((step, index) =>
    step.at === undefined
      ? []
      : {
          no: index + 1,
          time: begin + step.at,
          name: step.name,
          verdict: VERDICT_LABELS[step.verdict].label,
          tone: step.verdict === 'PASS' ? 'pass' : step.verdict === 'DONT' ? 'none' : 'fail',
          decides: decides(step),
        },
  );
}

function CaseOfResult({ buildId, no }: { buildId: string; no: number }) {
  const result = useResult(buildId);
  const item = useCase(buildId, no);
  if (!result.data || !item.data) {
    const error = result.error ?? item.error;
    return error && <ProblemAlert title="The case could not be read" error={error} />;
  }
  return (
    <Section title={`Result: ${VERDICT_LABELS[item.data.verdict].label}`}>
      {item.data.message && (
        <Text role="note" size="sm">
          <UserText>{item.data.message}</UserText>
        </Text>
      )}
      <StepList steps={item.data.steps} />
      <CaseFacts item={item.data} parameters={result.data.parameters} />
      <RelationRuns item={item.data} parameters={result.data.parameters} />
    </Section>
  );
}

/** Links to the previous and the next recorded case. */
function Neighbours({ buildId, no }: { buildId: string; no: number }) {
  const recorded = useRecordedCases(buildId);
  const numbers = recorded.data?.items.map(({ caseNo }) => caseNo) ?? [];
  const previous = numbers.filter((other) => other < no).at(-1);
  const next = numbers.find((other) => other > no);
  const link = (other: number | undefined, label: (number: number) => string) =>
    other === undefined ? null : (
      <RouteLink
        to="/builds/$buildId/cases/$caseNo"
        params={{ buildId, caseNo: String(other) }}
        size="sm"
      >
        {label(other)}
      </RouteLink>
    );
  return (
    <Group gap="md" component="nav" aria-label="Recorded cases">
      {link(previous, (number) => `← Case ${number}`)}
      {link(next, (number) => `Case ${number} →`)}
    </Group>
  );
}
