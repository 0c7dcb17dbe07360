import { Alert, Button, Paper, PasswordInput, Stack, TextInput, Title } from '@mantine/core';
import { useState, type SyntheticEvent } from 'react';
import { ProblemAlert } from '@/shared/ui';
import { useSignIn } from './queries';

interface SignInProps {
  /** Whether a link that would have signed in was too old. */
  expiredLink: boolean;
  onSignedIn: () => void;
}

export function SignIn({ expiredLink, onSignedIn }: SignInProps) {
  const signIn = useSignIn();
  const [name, setName] = useState('');
  const [password, setPassword] = useState('');

  function submit(event: SyntheticEvent) {
    event.preventDefault();
    signIn.mutate({ name, password }, { onSuccess: onSignedIn });
  }

  return (
    <Paper maw={420} mx="auto" mt="xl" p="xl" withBorder component="section">
      <form onSubmit={submit}>
        <Stack gap="md">
          <Title order={1} size="h2">
            Sign in
          </Title>
          {expiredLink && (
            <Alert
              role="alert"
              color="orange"
              variant="outline"
              title="The link was used or is old"
            >
              Sign in with a password, or have the launcher print another link.
            </Alert>
          )}
          <TextInput
            label="Name"
            autoComplete="username"
            required
            value={name}
            onChange={(event) => {
              setName(event.currentTarget.value);
            }}
          />
          <PasswordInput
            label="Password"
            autoComplete="current-password"
            required
            value={password}
            visibilityToggleButtonProps={{ 'aria-label': 'Show the password' }}
            onChange={(event) => {
              setPassword(event.currentTarget.value);
            }}
          />
          {signIn.isError && <ProblemAlert title="Not signed in" error={signIn.error} />}
          <Button type="submit" loading={signIn.isPending}>
            Sign in
          </Button>
        </Stack>
      </form>
    </Paper>
  );
}
