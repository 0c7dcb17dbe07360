import { NativeSelect, Stack, Switch, Table, TextInput } from '@mantine/core';
import { useState } from 'react';
import { Age, SecretForm, Loading, ProblemAlert, ScrollTable, UserText } from '@/shared/ui';
import { ROLES, useAddUser, useChangeUser, useUsers, type Role } from './queries';

/** User accounts and their roles, for administrators. */
export function Users() {
  const users = useUsers();
  const add = useAddUser();
  const change = useChangeUser();
  const [name, setName] = useState('');
  const [role, setRole] = useState<Role>('TESTER');
  if (users.isPending) return <Loading what="users" />;
  if (!users.data) return <ProblemAlert title="The users could not be read" error={users.error} />;

  return (
    <Stack gap="sm">
      <SecretForm
        issue={add}
        variables={{ name, role }}
        action="Add user"
        failed="The user was not added"
        secretOf={({ user, password }) => ({ title: `Password of ${user.name}`, secret: password })}
      >
        <TextInput
          label="User name"
          required
          value={name}
          onChange={(event) => {
            setName(event.currentTarget.value);
          }}
        />
        <RoleSelect label="Role" value={role} onRole={setRole} />
      </SecretForm>
      {change.isError && (
        <ProblemAlert
          title="The user was not changed"
          error={change.error}
          onClose={change.reset}
        />
      )}
      <ScrollTable label="Users" minWidth={560}>
        <Table.Thead>
          <Table.Tr>
            <Table.Th>Name</Table.Th>
            <Table.Th>Role</Table.Th>
            <Table.Th>Enabled</Table.Th>
            <Table.Th>Last sign-in</Table.Th>
          </Table.Tr>
        </Table.Thead>
        <Table.Tbody>
          {users.data.items.map((user) => (
            <Table.Tr key={user.id}>
              <Table.Td>
                <UserText>{user.name}</UserText>
              </Table.Td>
              <Table.Td>
                <RoleSelect
                  ariaLabel={`Role of ${user.name}`}
                  value={user.role}
                  onRole={(next) => {
                    change.mutate({ id: user.id, role: next });
                  }}
                />
              </Table.Td>
              <Table.Td>
                <Switch
                  aria-label={`Enable ${user.name}`}
                  checked={user.enabled}
                  onChange={(event) => {
                    change.mutate({ id: user.id, enabled: event.currentTarget.checked });
                  }}
                />
              </Table.Td>
              <Table.Td>{user.lastSignIn ? <Age at={user.lastSignIn} /> : 'Never'}</Table.Td>
            </Table.Tr>
          ))}
        </Table.Tbody>
      </ScrollTable>
    </Stack>
  );
}

interface RoleSelectProps {
  label?: string;
  /** A label for screen readers. */
  ariaLabel?: string;
  value: Role;
  onRole: (role: Role) => void;
}

export function RoleSelect({ label, ariaLabel, value, onRole }: RoleSelectProps) {
  return (
    <NativeSelect
      {...(label && { label })}
      {...(ariaLabel && { 'aria-label': ariaLabel })}
      value={value}
      data={ROLES.map((role) => ({ value: role, label: role.toLowerCase() }))}
      onChange={(event) => {
        const role = ROLES.find((known) => known === event.currentTarget.value);
        if (role) onRole(role);
      }}
    />
  );
}
