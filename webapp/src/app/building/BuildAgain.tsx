import { Button, Group } from '@mantine/core';
import { useNavigate } from '@tanstack/react-router';
import { useRequestBuild } from '@/features/builds';
import type { Build, BuildRequest } from '@/shared/api';
import { buildAgain, buildCaseAgain, buildFailedAgain } from '@/shared/lib/buildAgain';
import { ProblemAlert } from '@/shared/ui';

/** Requests another build of the same suite with the same options, whole or of what failed. */
export function BuildAgain({ build }: { build: Build }) {
  const { summary } = build;
  return (
    <Group gap="sm">
      {summary && summary.pass < summary.total && (
        <RequestButton label="Run failed cases again" requested={() => buildFailedAgain(build)} />
      )}
      <RequestButton label="Build again" requested={() => buildAgain(build)} />
    </Group>
  );
}

/** Requests a build of one case with the options of an earlier build, and opens it. */
export function RunCaseAgain({ build, no }: { build: Build; no: number }) {
  return (
    <RequestButton
      size="xs"
      label={`Run case ${no} again`}
      requested={() => buildCaseAgain(build, no)}
    />
  );
}

interface RequestButtonProps {
  label: string;
  requested: () => BuildRequest;
  size?: 'xs';
}

function RequestButton({ label, requested, size }: RequestButtonProps) {
  const request = useRequestBuild();
  const navigate = useNavigate();
  return (
    <>
      <Button
        variant="default"
        w="fit-content"
        {...(size && { size })}
        loading={request.isPending}
        onClick={() => {
          request.mutate(requested(), {
            onSuccess: ({ id }) =>
              void navigate({ to: '/builds/$buildId', params: { buildId: id } }),
          });
        }}
      >
        {label}
      </Button>
      {request.isError && (
        <ProblemAlert
          title="The build was not requested"
          error={request.error}
          onClose={request.reset}
        />
      )}
    </>
  );
}
