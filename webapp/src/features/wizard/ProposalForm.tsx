import { Button, Group, Stack, Text } from '@mantine/core';
import type { ReactNode } from 'react';
import { ApiError, type Activity } from '@/shared/api';
import { ProblemAlert } from '@/shared/ui';
import { bytesOf, type ProposalRequest } from './proposal';
import { ProposedActivity } from './ProposedActivity';
import { useCreateActivity, usePropose } from './queries';

interface ProposalFormProps {
  /** Undefined until all fields are filled. */
  request: ProposalRequest | undefined;
  onCreated: (activity: Activity) => void;
  /** The package holds several nodes. */
  onNodes?: (nodes: readonly string[]) => void;
  /** The fields of the request. */
  children: ReactNode;
}

/** Requests a proposal, shows it, and creates the activity if a person agrees. */
export function ProposalForm({ request, onCreated, onNodes, children }: ProposalFormProps) {
  const propose = usePropose();
  const create = useCreateActivity();
  // A proposal for other fields than the present ones is not shown.
  const proposal =
    propose.data && sameRequest(propose.variables, request) ? propose.data : undefined;
  const severalNodes = propose.error instanceof ApiError && propose.error.nodes.length > 0;
  return (
    <Stack gap="lg">
      <form
        onSubmit={(event) => {
          event.preventDefault();
          if (!request) return;
          create.reset();
          propose.mutate(request, {
            onError: (error) => {
              if (error instanceof ApiError && error.nodes.length > 0) onNodes?.(error.nodes);
            },
          });
        }}
      >
        <Stack gap="md">
          {children}
          {propose.isError && !severalNodes && (
            <ProblemAlert
              title="No activity was proposed"
              error={propose.error}
              onClose={propose.reset}
            />
          )}
          <div>
            <Button
              type="submit"
              variant={proposal ? 'default' : 'filled'}
              disabled={!request}
              loading={propose.isPending}
            >
              Propose activity
            </Button>
          </div>
          <Text size="sm" role="status">
            {proposal && 'The activity is proposed below. Nothing is stored yet.'}
          </Text>
        </Stack>
      </form>
      {proposal && (
        <>
          <ProposedActivity proposal={proposal} />
          {create.isError && (
            <ProblemAlert
              title="The activity was not created"
              error={create.error}
              onClose={create.reset}
            />
          )}
          <Group justify="flex-end">
            <Button
              loading={create.isPending}
              onClick={() => {
                create.mutate(() => Promise.resolve(bytesOf(proposal.archive)), {
                  onSuccess: onCreated,
                });
              }}
            >
              Create activity
            </Button>
          </Group>
        </>
      )}
    </Stack>
  );
}

function sameRequest(a: ProposalRequest, b: ProposalRequest | undefined): boolean {
  return a.files === b?.files && JSON.stringify(a.query) === JSON.stringify(b.query);
}
