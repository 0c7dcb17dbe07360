import { Button, Group, NativeSelect, Stack, Text, TextInput, Title } from '@mantine/core';
import type { Diagnostic, ModelPreview } from '@/shared/api';
import { Diagnostics, UserText } from '@/shared/ui';
import { defaultSpec } from '../defaults';
import { SCHEMES, type InputDraft, type ModelDraft } from '../document';
import classes from './values.module.css';
import { NumberLine } from './NumberLine';
import { parametersOf, withInput } from '../parameters';
import { SpecFields } from './SpecFields';

interface SpecificationStepProps {
  draft: ModelDraft;
  preview: ModelPreview | undefined;
  onChange: (draft: ModelDraft) => void;
}

const SCHEME_LABELS = {
  BVA: 'Boundary values (BVA)',
  ECP: 'Equivalence classes (ECP)',
  RANDOM: 'Random numbers',
  RANDOM_STRING: 'Random strings',
  ROTATION: 'Whole rotations',
  DIRECTION: 'Whole directions',
  POSE: 'Whole poses',
  RELATED: 'Next to another input',
} as const;

/** Step 3 (Fig. 14(c)): how the values of each parameter are generated, with a preview. */
export function SpecificationStep({ draft, preview, onChange }: SpecificationStepProps) {
  const parameters = parametersOf(draft, preview);
  if (parameters.length === 0) {
    return <Text c="dimmed">The model varies no parameters: it has a single case.</Text>;
  }
  return (
    <Stack gap="md">
      {parameters.map((parameter) => {
        const { call, input, values } = parameter;
        return (
          <Element
            key={`${call} ${input.name}`}
            input={input}
            call={call}
            others={parameters
              .filter((other) => other.call === call && other.input.name !== input.name)
              .map((other) => other.input.name)}
            values={values}
            problems={problemsOf(input, preview)}
            onChange={(changed) => {
              onChange(withInput(draft, parameter, changed));
            }}
          />
        );
      })}
    </Stack>
  );
}

function problemsOf({ name }: InputDraft, preview: ModelPreview | undefined): Diagnostic[] {
  const element = `test_element ${name}`;
  return (preview?.diagnostics ?? []).filter(
    (diagnostic) => diagnostic.element === element || diagnostic.element.startsWith(`${element}/`),
  );
}

interface ElementProps {
  input: InputDraft;
  /** The call of a sequence; empty for an input of the model. */
  call: string;
  others: readonly string[];
  values: ModelPreview['inputs'][number] | undefined;
  problems: readonly Diagnostic[];
  onChange: (input: InputDraft) => void;
}

function Element({ input, call, others, values, problems, onChange }: ElementProps) {
  const what = call === '' ? input.name : `${input.name} of ${call}`;
  return (
    <section className={classes.element} aria-label={`Specification of ${what}`}>
      <Stack gap="sm">
        <Group justify="space-between">
          <Title order={3} size="h5">
            <UserText>{what}</UserText>{' '}
            <Text span size="sm" c="dimmed">
              {input.kind}, <UserText>{input.realType}</UserText>
            </Text>
          </Title>
          <NativeSelect
            aria-label={`Scheme of ${what}`}
            value={input.spec?.type ?? ''}
            data={[
              { value: '', label: 'Custom values, or all values of the type' },
              ...SCHEMES.map((value) => ({ value, label: SCHEME_LABELS[value] })),
            ]}
            onChange={(event) => {
              const scheme = SCHEMES.find((known) => known === event.currentTarget.value);
              onChange({
                ...input,
                spec: scheme ? defaultSpec(scheme) : null,
                furtherSpecs: scheme ? input.furtherSpecs : [],
              });
            }}
          />
        </Group>
        {input.spec && (
          <SpecFields
            spec={input.spec}
            others={others}
            onChange={(spec) => {
              onChange({ ...input, spec });
            }}
          />
        )}
        {input.furtherSpecs.map((spec, index) => (
          <Group key={index} align="end">
            <NativeSelect
              aria-label={`Scheme ${index + 2} of ${what}`}
              value={spec.type}
              data={SCHEMES.map((value) => ({ value, label: SCHEME_LABELS[value] }))}
              onChange={(event) => {
                const scheme = SCHEMES.find((known) => known === event.currentTarget.value);
                if (scheme) {
                  onChange({
                    ...input,
                    furtherSpecs: input.furtherSpecs.with(index, defaultSpec(scheme)),
                  });
                }
              }}
            />
            <SpecFields
              spec={spec}
              others={others}
              onChange={(changed) => {
                onChange({ ...input, furtherSpecs: input.furtherSpecs.with(index, changed) });
              }}
            />
            <Button
              variant="subtle"
              size="xs"
              onClick={() => {
                onChange({ ...input, furtherSpecs: input.furtherSpecs.toSpliced(index, 1) });
              }}
            >
              Remove
            </Button>
          </Group>
        ))}
        {input.spec && (
          <Group>
            <Button
              variant="default"
              size="xs"
              aria-label={`Add a specification to ${what}`}
              onClick={() => {
                onChange({
                  ...input,
                  furtherSpecs: [...input.furtherSpecs, defaultSpec('RELATED')],
                });
              }}
            >
              Add specification
            </Button>
          </Group>
        )}
        <TextInput
          label="Custom values"
          description="Separated by commas; used in addition to the generated values"
          value={input.userValues.join(', ')}
          onChange={(event) => {
            const { value } = event.currentTarget;
            onChange({
              ...input,
              userValues:
                value.trim() === '' ? [] : value.split(',').map((part) => part.trimStart()),
            });
          }}
        />
        {problems.length > 0 && <Diagnostics items={problems} />}
        {values ? (
          <>
            <NumberLine values={values.values} />
            {values.leftOut.length > 0 && (
              <Text size="sm" c="dimmed">
                Omitted, because {input.realType} cannot represent them:{' '}
                <UserText>{values.leftOut.join(', ')}</UserText>
              </Text>
            )}
          </>
        ) : (
          <Text size="sm" c="dimmed">
            The values are shown when the model has no problems.
          </Text>
        )}
      </Stack>
    </section>
  );
}
