import { Radio, Stack, Text } from '@mantine/core';
import { UserText } from '@/shared/ui';
import type { Description } from './defaults';
import type { ModelDraft } from './document';
import { ModelName } from './ModelName';

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
      <ModelName draft={draft} isNew={isNew} onChange={onChange} />
    </Stack>
  );
}

function keyOf(interfaceName: string, method: string, signature: string): string {
  return JSON.stringify([interfaceName, method, signature]);
}
