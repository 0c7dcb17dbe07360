import { Alert, Code, Text } from '@mantine/core';

/** A secret that the server shows this once. */
export function ShownOnce({ title, secret }: { title: string; secret: string }) {
  return (
    <Alert role="status" color="petrol" variant="outline" title={title}>
      <Code block>{secret}</Code>
      <Text size="sm">Keep it now: it is not shown again.</Text>
    </Alert>
  );
}
