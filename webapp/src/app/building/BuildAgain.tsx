import { Button } from '@mantine/core';
import { useNavigate } from '@tanstack/react-router';
import { useRequestBuild } from '@/features/builds';
import type { Build } from '@/shared/api';
import { buildAgain } from '@/shared/lib/buildAgain';
import { ProblemAlert } from '@/shared/ui';

/** Requests another build of the same suite with the same options, and opens it. */
export function BuildAgain({ build }: { build: Build }) {
  const request = useRequestBuild();
  const navigate = useNavigate();
  return (
    <>
      <Button
        variant="default"
        loading={request.isPending}
        onClick={() => {
          request.mutate(buildAgain(build), {
            onSuccess: ({ id }) =>
              void navigate({ to: '/builds/$buildId', params: { buildId: id } }),
          });
        }}
      >
        Build again
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
