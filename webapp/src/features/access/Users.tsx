import { NativeSelect, Stack, Switch, Table, TextInput } from '@mantine/core';
import { useState } from 'react';
import { Age, IssueForm, Loading, ProblemAlert, ScrollTable, UserText } from '@/shared/ui';
import { ROLES, useAddUser, useChangeUser, useUsers, type Role } from './queries';

/** Who may sign in, and as what; for administrators. */
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
      <IssueForm
        issue={add}
        wish={{ name, role }}
        action="Add"
        refused="Not added"
        secretOf={({ user, password }) => ({ title: `Password of ${user.name}`, secret: password })}
      >
        <TextInput
          label="Name of a new user"
          required
          value={name}
          onChange={(event) => {
            setName(event.currentTarget.value);
          }}
        />
        <RoleSelect label="Role" value={role} onRole={setRole} />
      </IssueForm>
      {change.isError && (
        <ProblemAlert title="Not changed" error={change.error} onClose={change.reset} />
      )}
      <ScrollTable label="Users" minWidth={560}>
        <Table.Thead>
          <Table.Tr>
            <Table.Th>Name</Table.Th>
            <Table.Th>Role</Table.Th>
            <Table.Th>May sign in</Table.Th>
            <Table.Th>Last signed in</Table.Th>
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
                  hidden={`Role of ${user.name}`}
                  value={user.role}
                  onRole={(next) => {
                    change.mutate({ id: user.id, role: next });
                  }}
                />
              </Table.Td>
              <Table.Td>
                <Switch
                  aria-label={`${user.name} may sign in`}
                  checked={user.enabled}
                  onChange={(event) => {
                    change.mutate({ id: user.id, enabled: event.currentTarget.checked });
                  }}
                />
              </Table.Td>
              <Table.Td>{user.lastSignIn ? <Age at={user.lastSignIn} /> : 'never'}</Table.Td>
            </Table.Tr>
          ))}
        </Table.Tbody>
      </ScrollTable>
    </Stack>
  );
}

interface RoleSelectProps {
  label?: string;
  /** A label for those who do not see the table around it. */
  hidden?: string;
  value: Role;
  onRole: (role: Role) => void;
}

export function RoleSelect({ label, hidden, value, onRole }: RoleSelectProps) {
  return (
    <NativeSelect
      {...(label && { label })}
      {...(hidden && { 'aria-label': hidden })}
      value={value}
      data={ROLES.map((role) => ({ value: role, label: role.toLowerCase() }))}
      onChange={(event) => {
        const role = ROLES.find((known) => known === event.currentTarget.value);
        if (role) onRole(role);
      }}
    />
  );
}
