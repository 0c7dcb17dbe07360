import { Alert, Button, Code, Group, Stack, Text } from '@mantine/core';
import { useState } from 'react';
import type { GitSource } from '@/shared/api';
import { Age, ProblemAlert, SecretForm, UserText } from '@/shared/ui';
import {
  useCreateGitHook,
  useDeleteGitSource,
  useFetchGitSource,
  useSaveGitSource,
} from './queries';
import { draftOf, requestOf, SourceFields } from './SourceFields';

interface GitSettingsProps {
  activityId: string;
  /** Null: the activity does not come from Git. */
  source: GitSource | null;
}

/** The settings of an activity's Git source, and the state of the last fetch. */
export function GitSettings({ activityId, source }: GitSettingsProps) {
  const [draft, setDraft] = useState(() => draftOf(source));
  const save = useSaveGitSource(activityId);
  const remove = useDeleteGitSource(activityId);
  return (
    <Stack gap="sm">
      {source && <FetchState activityId={activityId} source={source} />}
      <form
        onSubmit={(event) => {
          event.preventDefault();
          save.mutate(
            { ...requestOf(draft), version: source?.version },
            {
              onSuccess: (saved) => {
                setDraft(draftOf(saved));
              },
            },
          );
        }}
      >
        <Stack gap="sm">
          <SourceFields
            draft={draft}
            onDraft={setDraft}
            stored={source !== null && source.credential === draft.credential}
            storedForgeToken={source?.hasForgeToken ?? false}
          />
          <Group>
            <Button type="submit" loading={save.isPending}>
              Save Git source
            </Button>
            {source && (
              <Button
                variant="default"
                loading={remove.isPending}
                onClick={() => {
                  remove.mutate();
                }}
              >
                Remove Git source
              </Button>
            )}
          </Group>
        </Stack>
      </form>
      {save.isError && (
        <ProblemAlert
          title="The Git source was not saved"
          error={save.error}
          onClose={save.reset}
        />
      )}
      {remove.isError && (
        <ProblemAlert
          title="The Git source was not removed"
          error={remove.error}
          onClose={remove.reset}
        />
      )}
      {source && <Hook activityId={activityId} source={source} />}
    </Stack>
  );
}

function FetchState({ activityId, source }: { activityId: string; source: GitSource }) {
  const fetch = useFetchGitSource(activityId);
  return (
    <Stack gap="xs">
      {source.problem && (
        <Alert role="alert" color="red" variant="outline" title="The branch could not be fetched">
          <UserText>{source.problem}</UserText>
        </Alert>
      )}
      <Group>
        <Text size="sm" c="dimmed">
          {source.fetched ? (
            <>
              Last fetched <Age at={source.fetched} />
            </>
          ) : (
            'Not fetched yet'
          )}
        </Text>
        <Button
          size="compact-sm"
          variant="default"
          loading={fetch.isPending}
          onClick={() => {
            fetch.mutate();
          }}
        >
          Fetch now
        </Button>
      </Group>
    </Stack>
  );
}

/** Without messages of the forge, new commits are found by polling. */
function Hook({ activityId, source }: { activityId: string; source: GitSource }) {
  const create = useCreateGitHook(activityId);
  return (
    <Stack gap="xs">
      <Text size="sm" c="dimmed">
        {source.hasHook
          ? 'A webhook of the forge reports pushes and requests at once.'
          : 'With a webhook the forge reports pushes and requests at once.'}
      </Text>
      <SecretForm
        issue={create}
        variables={undefined}
        action={source.hasHook ? 'Replace webhook secret' : 'Create webhook secret'}
        failed="The secret was not created"
        secretOf={({ path, secret }) => ({
          title: 'Webhook secret',
          secret,
          instructions: (
            <Text size="sm">
              Payload URL: <Code>{`${window.location.origin}${path}`}</Code>, content type
              application/json, events: push, and pull or merge requests.
            </Text>
          ),
        })}
      >
        {null}
      </SecretForm>
    </Stack>
  );
}
