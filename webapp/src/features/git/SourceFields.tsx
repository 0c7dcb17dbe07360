import { NativeSelect, NumberInput, SimpleGrid, Textarea, TextInput } from '@mantine/core';
import type { GitSource, GitSourceRequest } from '@/shared/api';

/** The settings of a Git source as the form holds them. */
export interface SourceDraft {
  url: string;
  branch: string;
  folder: string;
  credential: GitSource['credential'];
  user: string;
  secret: string;
  policy: GitSource['policy'];
  intervalS: number;
  forge: GitSource['forge'];
  apiUrl: string;
  project: string;
  forgeToken: string;
}

export function draftOf(source: GitSource | null): SourceDraft {
  return {
    url: source?.url ?? '',
    branch: source?.branch ?? 'main',
    folder: source?.folder ?? '',
    credential: source?.credential ?? 'NONE',
    user: source?.user ?? '',
    secret: '',
    policy: source?.policy ?? 'LATEST',
    intervalS: source?.intervalS ?? 300,
    forge: source?.forge ?? 'NONE',
    apiUrl: source?.apiUrl ?? '',
    project: source?.project ?? '',
    forgeToken: '',
  };
}

/** Empty fields are left out, so that the server uses its defaults and keeps its secrets. */
export function requestOf(draft: SourceDraft): GitSourceRequest {
  const given = Object.entries(draft).filter(([, value]) => value !== '');
  return Object.fromEntries(given) as unknown as GitSourceRequest;
}

interface SourceFieldsProps {
  draft: SourceDraft;
  onDraft: (draft: SourceDraft) => void;
  /** Whether a secret is stored. */
  stored: boolean;
  storedForgeToken: boolean;
}

export function SourceFields({ draft, onDraft, stored, storedForgeToken }: SourceFieldsProps) {
  const set = (change: Partial<SourceDraft>) => {
    onDraft({ ...draft, ...change });
  };
  return (
    <SimpleGrid cols={{ base: 1, sm: 2 }}>
      <TextInput
        label="Repository URL"
        description="https://HOST/PATH or git@HOST:PATH"
        required
        value={draft.url}
        onChange={(event) => {
          set({ url: event.currentTarget.value });
        }}
      />
      <TextInput
        label="Branch"
        description="Its newest commit is tested"
        required
        value={draft.branch}
        onChange={(event) => {
          set({ branch: event.currentTarget.value });
        }}
      />
      <TextInput
        label="Folder"
        description="The folder of activity.yaml; empty for the root"
        value={draft.folder}
        onChange={(event) => {
          set({ folder: event.currentTarget.value });
        }}
      />
      <NativeSelect
        label="Commits"
        description="Which commits of a push are built"
        data={[
          { value: 'LATEST', label: 'The newest one' },
          { value: 'EVERY', label: 'Each one' },
        ]}
        value={draft.policy}
        onChange={(event) => {
          set({ policy: event.currentTarget.value as SourceDraft['policy'] });
        }}
      />
      <NativeSelect
        label="Credential"
        description="What the repository is read with"
        data={[
          { value: 'NONE', label: 'None: the repository is public' },
          { value: 'TOKEN', label: 'Token (https)' },
          { value: 'DEPLOY_KEY', label: 'Deploy key (ssh)' },
        ]}
        value={draft.credential}
        onChange={(event) => {
          set({ credential: event.currentTarget.value as SourceDraft['credential'] });
        }}
      />
      <NumberInput
        label="Interval (s)"
        description="Time between two looks for new commits"
        min={1}
        allowDecimal={false}
        value={draft.intervalS}
        onChange={(value) => {
          set({ intervalS: Number(value) });
        }}
      />
      {draft.credential === 'TOKEN' && (
        <>
          <TextInput
            label="User of the token"
            description="Empty if the forge needs none"
            value={draft.user}
            onChange={(event) => {
              set({ user: event.currentTarget.value });
            }}
          />
          <TextInput
            label="Token"
            type="password"
            autoComplete="off"
            description={stored ? 'Empty to keep the stored one' : 'Stored encrypted'}
            value={draft.secret}
            onChange={(event) => {
              set({ secret: event.currentTarget.value });
            }}
          />
        </>
      )}
      {draft.credential === 'DEPLOY_KEY' && (
        <Textarea
          label="Private key"
          autoComplete="off"
          rows={4}
          description={stored ? 'Empty to keep the stored one' : 'Without a passphrase'}
          value={draft.secret}
          onChange={(event) => {
            set({ secret: event.currentTarget.value });
          }}
        />
      )}
      <NativeSelect
        label="Commit statuses"
        description="The forge that shows results at its commits"
        data={[
          { value: 'NONE', label: 'None' },
          { value: 'GITHUB', label: 'GitHub' },
          { value: 'GITLAB', label: 'GitLab' },
          { value: 'GITEA', label: 'Gitea or Forgejo' },
        ]}
        value={draft.forge}
        onChange={(event) => {
          set({ forge: event.currentTarget.value as SourceDraft['forge'] });
        }}
      />
      {draft.forge !== 'NONE' && (
        <>
          <TextInput
            label="API URL"
            description="Empty for the usual one of the host"
            value={draft.apiUrl}
            onChange={(event) => {
              set({ apiUrl: event.currentTarget.value });
            }}
          />
          <TextInput
            label="Project"
            description="Empty for the path of the repository"
            value={draft.project}
            onChange={(event) => {
              set({ project: event.currentTarget.value });
            }}
          />
          <TextInput
            label="Token for statuses"
            type="password"
            autoComplete="off"
            description={
              storedForgeToken
                ? 'Empty to keep the stored one'
                : 'Empty to use the token of the repository'
            }
            value={draft.forgeToken}
            onChange={(event) => {
              set({ forgeToken: event.currentTarget.value });
            }}
          />
        </>
      )}
    </SimpleGrid>
  );
}
