import { Anchor, Button, Stack, Table, Text, TextInput } from '@mantine/core';
import { useState } from 'react';
import { formatInstant } from '@/shared/lib/format';
import { Age, SecretForm, Loading, ProblemAlert, ScrollTable, UserText } from '@/shared/ui';
import { useAddToken, useRevokeToken, useTokens, type Role } from './queries';
import { RoleSelect } from './Users';

/** Access tokens for scripts, which act for the owner of the token. */
export function Tokens() {
  const tokens = useTokens();
  const add = useAddToken();
  const revoke = useRevokeToken();
  const [name, setName] = useState('');
  const [days, setDays] = useState('90');
  const [role, setRole] = useState<Role>('TESTER');
  if (tokens.isPending) return <Loading what="tokens" />;
  if (!tokens.data) {
    return <ProblemAlert title="The tokens could not be read" error={tokens.error} />;
  }

  return (
    <Stack gap="sm">
      <Text c="dimmed">
        Scripts use a token with the REST API. Download its{' '}
        <Anchor href="/v3/api-docs" underline="always">
          OpenAPI document
        </Anchor>
        , or a client in{' '}
        <Anchor href="/api/v1/clients/python" download underline="always">
          Python
        </Anchor>{' '}
        or{' '}
        <Anchor href="/api/v1/clients/java" download underline="always">
          Java
        </Anchor>
        .
      </Text>
      <SecretForm
        issue={add}
        variables={{ name, role, days: Number(days) }}
        action="Create token"
        failed="The token was not created"
        secretOf={({ token, secret }) => ({ title: `Token ${token.name}`, secret })}
      >
        <TextInput
          label="Token name"
          required
          value={name}
          onChange={(event) => {
            setName(event.currentTarget.value);
          }}
        />
        <RoleSelect label="Role" value={role} onRole={setRole} />
        <TextInput
          label="Valid for (days)"
          type="number"
          min={1}
          required
          w={150}
          value={days}
          onChange={(event) => {
            setDays(event.currentTarget.value);
          }}
        />
      </SecretForm>
      {revoke.isError && (
        <ProblemAlert
          title="The token was not revoked"
          error={revoke.error}
          onClose={revoke.reset}
        />
      )}
      {tokens.data.items.length === 0 ? (
        <Text c="dimmed">No tokens yet.</Text>
      ) : (
        <ScrollTable label="Tokens" minWidth={560}>
          <Table.Thead>
            <Table.Tr>
              <Table.Th>Name</Table.Th>
              <Table.Th>Owner</Table.Th>
              <Table.Th>Role</Table.Th>
              <Table.Th>Expires</Table.Th>
              <Table.Th>Last used</Table.Th>
              <Table.Th aria-label="Actions" />
            </Table.Tr>
          </Table.Thead>
          <Table.Tbody>
            {tokens.data.items.map((token) => (
              <Table.Tr key={token.id}>
                <Table.Td>
                  <UserText>{token.name}</UserText>
                </Table.Td>
                <Table.Td>
                  <UserText>{token.owner}</UserText>
                </Table.Td>
                <Table.Td>{token.role.toLowerCase()}</Table.Td>
                <Table.Td>{formatInstant(token.expires)}</Table.Td>
                <Table.Td>{token.lastUsed ? <Age at={token.lastUsed} /> : 'Never'}</Table.Td>
                <Table.Td ta="right">
                  <Button
                    size="compact-xs"
                    variant="default"
                    aria-label={`Revoke ${token.name}`}
                    onClick={() => {
                      revoke.mutate(token.id, {
                        onSuccess: () => {
                          // The secret of a revoked token is useless.
                          if (add.data?.token.id === token.id) add.reset();
                        },
                      });
                    }}
                  >
                    Revoke
                  </Button>
                </Table.Td>
              </Table.Tr>
            ))}
          </Table.Tbody>
        </ScrollTable>
      )}
    </Stack>
  );
}
