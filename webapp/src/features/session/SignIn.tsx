import { Alert, Button, Paper, PasswordInput, Stack, TextInput, Title } from '@mantine/core';
import { useState, type SyntheticEvent } from 'react';
import { ProblemAlert } from '@/shared/ui';
import { useSignIn } from './queries';

interface SignInProps {
  /** Whether the user came with a sign-in link that has expired. */
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
              title="The link was used or has expired"
            >
              Sign in with a password, or start the launcher again to get a new link.
            </Alert>
          )}
          <TextInput
            label="User name"
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
            visibilityToggleButtonProps={{ 'aria-label': 'Show password' }}
            onChange={(event) => {
              setPassword(event.currentTarget.value);
            }}
          />
          {signIn.isError && <ProblemAlert title="Sign-in failed" error={signIn.error} />}
          <Button type="submit" loading={signIn.isPending}>
            Sign in
          </Button>
        </Stack>
      </form>
    </Paper>
  );
}
