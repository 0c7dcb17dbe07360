import { Alert, Button, Group, Loader, Text } from '@mantine/core';
import type { BuildAnalysis } from '@/shared/api';
import { ProblemAlert, UserText } from '@/shared/ui';
import {
  isEnded,
  useCancelAnalysis,
  useRequestAnalysis,
  type AnalysisKind,
  type RequestedKind,
} from './queries';

interface AnalysisButtonProps {
  buildId: string;
  kind: RequestedKind;
  label: string;
}

/** Requests an analysis of a build. */
export function AnalysisButton({ buildId, kind, label }: AnalysisButtonProps) {
  const request = useRequestAnalysis(buildId, kind);
  return (
    <>
      <Button
        variant="default"
        size="xs"
        loading={request.isPending}
        onClick={() => {
          request.mutate();
        }}
      >
        {label}
      </Button>
      {request.isError && (
        <ProblemAlert
          title="The analysis was not requested"
          error={request.error}
          onClose={request.reset}
        />
      )}
    </>
  );
}

interface AnalysisProgressProps {
  buildId: string;
  kind: AnalysisKind;
  analysis: BuildAnalysis;
}

/** How far an analysis is, or why it has no report; nothing if it has one. */
export function AnalysisProgress({ buildId, kind, analysis }: AnalysisProgressProps) {
  const cancel = useCancelAnalysis(buildId, kind);
  const { id, state, executed, maxCases, waitingFor, failure } = analysis;
  if (state === 'DONE') return null;
  if (isEnded(analysis)) {
    return (
      <Alert
        color={state === 'FAILED' ? 'red' : 'gray'}
        variant="outline"
        title={state === 'FAILED' ? 'Could not run' : 'Cancelled'}
      >
        {failure !== undefined && <UserText>{failure}</UserText>}
      </Alert>
    );
  }
  return (
    <Group gap="md">
      <Loader size="xs" />
      <Text size="sm" role="status">
        {waitingFor !== undefined ? (
          <>
            Waiting: <UserText>{waitingFor}</UserText>
          </>
        ) : (
          `${executed} of at most ${maxCases} further cases executed`
        )}
      </Text>
      <Button
        variant="default"
        size="xs"
        loading={cancel.isPending}
        onClick={() => {
          cancel.mutate(id);
        }}
      >
        Cancel
      </Button>
      {cancel.isError && (
        <ProblemAlert
          title="The analysis was not cancelled"
          error={cancel.error}
          onClose={cancel.reset}
        />
      )}
    </Group>
  );
}
