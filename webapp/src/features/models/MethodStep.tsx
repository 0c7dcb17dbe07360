import { Alert, Code, Group, Radio, Stack, Text, TextInput } from '@mantine/core';
import { UserText } from '@/shared/ui';
import type { Description } from './defaults';
import type { ModelDraft } from './draft';

interface MethodStepProps {
  description: Description;
  draft: ModelDraft;
  /** An existing model keeps its name, because suites and builds refer to it. */
  isNew: boolean;
  onChange: (draft: ModelDraft) => void;
  onMethod: (interfaceName: string, signature: string, name: string) => void;
}

/** Step 1 (Fig. 14(a)): the method under test. */
export function MethodStep({ description, draft, isNew, onChange, onMethod }: MethodStepProps) {
  const { target } = draft;
  const chosen = description.provided.flatMap(({ name, methods }) =>
    methods
      .filter(
        (method) =>
          method.name === target.method &&
          (target.interface === '' || target.interface === name) &&
          (target.signature === '' || target.signature === method.signature),
      )
      .map((method) => keyOf(name, method.name, method.signature)),
  )[0];
  if (draft.sequence !== '') {
    return (
      <Alert variant="outline" title="This model describes sequences of calls">
        <Stack gap="sm">
          <Text size="sm">
            States, calls and events are edited in the XML document. They are shown here and kept
            when you save.
          </Text>
          <Code block>{draft.sequence}</Code>
        </Stack>
      </Alert>
    );
  }
  return (
    <Stack gap="lg">
      <Radio.Group
        label="Method under test"
        value={chosen ?? ''}
        onChange={(key) => {
          const [interfaceName = '', name = '', signature = ''] = JSON.parse(key) as string[];
          onMethod(interfaceName, signature, name);
        }}
      >
        <Stack gap="xs" mt="xs">
          {description.provided.map(({ name, methods }) => (
            <Stack key={name} gap="xs">
              <Text fw={600}>
                <UserText>{name}</UserText>
              </Text>
              {methods.map((method) => (
                <Radio
                  key={method.signature + method.name}
                  ml="md"
                  value={keyOf(name, method.name, method.signature)}
                  label={
                    <code>
                      <UserText>
                        {`${method.returnType.spelling} ${method.name}(${method.parameters
                          .map((p) => `${p.type.spelling} ${p.name}`)
                          .join(', ')})`}
                      </UserText>
                    </code>
                  }
                />
              ))}
            </Stack>
          ))}
        </Stack>
      </Radio.Group>
      <Group align="start" grow>
        <TextInput
          label="Name of the test model"
          description={
            isNew ? 'Letters, digits, ., _ and -' : 'Suites and builds refer to this name'
          }
          value={draft.name}
          readOnly={!isNew}
          onChange={(event) => {
            onChange({ ...draft, name: event.currentTarget.value });
          }}
        />
        <TextInput
          label="Description"
          description="What the model tests"
          value={draft.description}
          onChange={(event) => {
            onChange({ ...draft, description: event.currentTarget.value });
          }}
        />
      </Group>
      <Group align="start" grow>
        <TextInput
          label="Settling time before the call (s)"
          placeholder="0"
          value={target.settle}
          onChange={(event) => {
            onChange({ ...draft, target: { ...target, settle: event.currentTarget.value } });
          }}
        />
        <TextInput
          label="Run time after the call (s)"
          placeholder="0"
          value={target.runFor}
          onChange={(event) => {
            onChange({ ...draft, target: { ...target, runFor: event.currentTarget.value } });
          }}
        />
      </Group>
    </Stack>
  );
}

function keyOf(interfaceName: string, method: string, signature: string): string {
  return JSON.stringify([interfaceName, method, signature]);
}
