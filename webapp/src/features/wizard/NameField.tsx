import { TextInput } from '@mantine/core';

interface NameFieldProps {
  name: string;
  onName: (name: string) => void;
  error?: string | undefined;
}

/** The name of an activity. */
export function NameField({ name, onName, error }: NameFieldProps) {
  return (
    <TextInput
      label="Name of the activity"
      description="Letters, digits, ., _ and -"
      required
      value={name}
      error={error}
      onChange={(event) => {
        onName(event.currentTarget.value);
      }}
    />
  );
}
