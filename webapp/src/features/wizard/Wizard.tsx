import {
  Button,
  Code,
  Group,
  NativeSelect,
  SegmentedControl,
  Stack,
  Stepper,
  Text,
  Textarea,
  TextInput,
} from '@mantine/core';
import { useState } from 'react';
import type { Activity, Diagnostic } from '@/shared/api';
import { Diagnostics, ProblemAlert, Section, UserText } from '@/shared/ui';
import { languageOf, LANGUAGES, suggestedClass, pathsOf, type WizardDraft } from './draft';
import { FilePicker } from './FilePicker';
import { NameField } from './NameField';
import { useCheck, useCreateActivity } from './queries';

const LAST_STEP = 3;

interface WizardProps {
  draft: WizardDraft;
  set: (changes: Partial<WizardDraft>) => void;
  onCreated: (activity: Activity) => void;
}

/** Creates an activity in four steps (Fig. 13). Problems are shown next to the fields that cause them. */
export function Wizard({ draft, set, onCreated }: WizardProps) {
  const [step, setStep] = useState(0);
  const check = useCheck(draft, step);
  const create = useCreateActivity();
  const problems = check.data?.diagnostics ?? [];
  const props: StepProps = { draft, set, problems };
  const errors = problems.filter(({ severity }) => severity === 'ERROR');
  return (
    <Stack gap="lg">
      <Stepper active={step} onStepClick={setStep} size="sm">
        <Stepper.Step label="Component" description="and profile" />
        <Stepper.Step label="Sources" description="or library" />
        <Stepper.Step label="Interfaces" description="and libraries" />
        <Stepper.Step label="Summary" description="and world" />
      </Stepper>
      {step === 0 && <ComponentStep {...props} />}
      {step === 1 && <SourcesStep {...props} />}
      {step === 2 && <InterfacesStep {...props} />}
      {step === LAST_STEP && <SummaryStep {...props} checking={check.isFetching} />}
      {create.isError && (
        <ProblemAlert
          title="The activity was not created"
          error={create.error}
          onClose={create.reset}
        />
      )}
      <Group justify="space-between">
        <Button
          variant="default"
          disabled={step === 0}
          onClick={() => {
            setStep(step - 1);
          }}
        >
          Back
        </Button>
        {step < LAST_STEP ? (
          <Button
            onClick={() => {
              setStep(step + 1);
            }}
          >
            Next
          </Button>
        ) : (
          <Button
            disabled={errors.length > 0 || check.isFetching}
            loading={create.isPending}
            onClick={() => {
              create.mutate(
                async () => {
                  const { archiveOf } = await import('./archive');
                  return archiveOf(draft);
                },
                { onSuccess: onCreated },
              );
            }}
          >
            Create activity
          </Button>
        )}
      </Group>
    </Stack>
  );
}

interface StepProps {
  draft: WizardDraft;
  set: (changes: Partial<WizardDraft>) => void;
  problems: readonly Diagnostic[];
}

/** The problem of a field of the profile; none while the field is empty. */
function problemOf(problems: readonly Diagnostic[], element: string, value: string) {
  return value === ''
    ? undefined
    : problems.find((p) => p.file === 'activity.yaml' && p.element === element)?.message;
}

function Problems({ items }: { items: readonly Diagnostic[] }) {
  return items.length > 0 ? <Diagnostics items={items} /> : null;
}

function ComponentStep({ draft, set, problems }: StepProps) {
  return (
    <Stack gap="md">
      <NameField
        name={draft.name}
        error={problemOf(problems, 'name', draft.name)}
        onName={(name) => {
          set({ name });
        }}
      />
      <Textarea
        label="Description"
        autosize
        value={draft.description}
        onChange={(event) => {
          set({ description: event.currentTarget.value });
        }}
      />
      <Group align="end">
        <NativeSelect
          label="Language of the component"
          data={[...LANGUAGES]}
          value={draft.language}
          onChange={(event) => {
            const language = languageOf(event.currentTarget.value);
            set({ language, harness: language });
          }}
        />
        <NativeSelect
          label="Component instance"
          data={[
            { value: 'case', label: 'New instance for each case' },
            { value: 'suite', label: 'One instance for all cases' },
          ]}
          value={draft.lifeCycle}
          onChange={(event) => {
            set({ lifeCycle: event.currentTarget.value === 'suite' ? 'suite' : 'case' });
          }}
        />
      </Group>
      <Group align="start" grow>
        <Textarea
          label="Properties"
          description="One NAME: VALUE per line, set before the first call"
          autosize
          value={draft.properties}
          onChange={(event) => {
            set({ properties: event.currentTarget.value });
          }}
        />
        <Textarea
          label="Calls before the method under test"
          description="One per line, such as Enable()"
          autosize
          value={draft.before}
          onChange={(event) => {
            set({ before: event.currentTarget.value });
          }}
        />
      </Group>
      <FilePicker
        label="Component profile"
        description="OPRoS XML, optional"
        single
        files={draft.profile}
        onFiles={(profile) => {
          set({ profile });
        }}
      />
      <Problems items={problems.filter((p) => draft.profile.has(p.file))} />
    </Stack>
  );
}

function SourcesStep({ draft, set, problems }: StepProps) {
  const [kind, setKind] = useState(draft.library.size > 0 ? 'library' : 'sources');
  const suggestion = suggestedClass(draft);
  const className = draft.className;
  return (
    <Stack gap="md">
      <SegmentedControl
        aria-label="Form of the component"
        value={kind}
        onChange={(value) => {
          setKind(value);
          set(value === 'library' ? { sources: new Map() } : { library: new Map() });
        }}
        data={[
          { value: 'sources', label: 'Sources' },
          { value: 'library', label: 'Compiled library' },
        ]}
      />
      {kind === 'sources' ? (
        <FilePicker
          label="Sources of the component"
          description="Drop a folder, a zip file or files here"
          folder
          files={draft.sources}
          onFiles={(sources) => {
            const found = suggestedClass({ ...draft, sources });
            set({ sources, ...(className === '' && { className: found }) });
          }}
        />
      ) : (
        <FilePicker
          label="Library of the component"
          description="A .jar, .so or Python package"
          single
          files={draft.library}
          onFiles={(library) => {
            set({ library });
          }}
        />
      )}
      <TextInput
        label="Component class"
        description={
          suggestion && suggestion !== className
            ? `Qualified name; the sources declare ${suggestion}`
            : 'Qualified name, such as org.example.Sensor'
        }
        required
        value={className}
        error={problemOf(problems, 'component.class', className)}
        onChange={(event) => {
          set({ className: event.currentTarget.value });
        }}
      />
      {draft.sources.size + draft.library.size > 0 && (
        <Problems
          items={problems.filter((p) =>
            ['component.sources', 'component.library'].includes(p.element),
          )}
        />
      )}
    </Stack>
  );
}

function InterfacesStep({ draft, set, problems }: StepProps) {
  const given = [...draft.provided.keys(), ...draft.required.keys()];
  return (
    <Stack gap="md">
      <FilePicker
        label="Provided interfaces"
        description="OPRoS XML, OMG IDL, ROS msg, srv or action, protobuf"
        files={draft.provided}
        onFiles={(provided) => {
          set({ provided });
        }}
      />
      <FilePicker
        label="Required interfaces"
        description="Implemented by the test stub; optional"
        files={draft.required}
        onFiles={(required) => {
          set({ required });
        }}
      />
      <FilePicker
        label="External libraries"
        description="Other libraries that the component needs, optional"
        files={draft.libraries}
        onFiles={(libraries) => {
          set({ libraries });
        }}
      />
      <Problems
        items={problems.filter(
          (p) =>
            given.some((path) => path === p.file) ||
            (given.length > 0 && ['provided', 'required', 'libraries'].includes(p.element)),
        )}
      />
    </Stack>
  );
}

function SummaryStep({ draft, set, problems, checking }: StepProps & { checking: boolean }) {
  return (
    <Stack gap="md">
      <NativeSelect
        label="Language of the test application"
        description="The default is the language of the component"
        data={[...LANGUAGES]}
        value={draft.harness}
        onChange={(event) => {
          set({ harness: languageOf(event.currentTarget.value) });
        }}
      />
      <FilePicker
        label="Simulation world"
        description="NAME.world.yaml and its MJCF files, optional"
        folder
        files={draft.world}
        onFiles={(world) => {
          set({ world });
        }}
      />
      <Section title="Summary">
        <Text>
          <UserText>{`${draft.name || 'No name'}: ${draft.className || 'no class'} in ${
            LANGUAGES.find(({ value }) => value === draft.language)?.label ?? ''
          }`}</UserText>
        </Text>
        <Code block aria-label="Files of the activity">
          {pathsOf(draft).join('\n')}
        </Code>
        {problems.length > 0 ? (
          <Diagnostics items={problems} />
        ) : (
          <Text role="status">{checking ? 'Checking…' : 'No problems.'}</Text>
        )}
      </Section>
    </Stack>
  );
}
