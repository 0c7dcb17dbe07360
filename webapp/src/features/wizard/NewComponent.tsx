import { Code, Group, NativeSelect, SegmentedControl, Text, TextInput } from '@mantine/core';
import { useId } from 'react';
import type { Activity } from '@/shared/api';
import { languageOf, LANGUAGES } from './draft';
import { FilePicker } from './FilePicker';
import { NameField } from './NameField';
import { fileOf, interfacesIn, requestOfComponent, type ComponentDraft } from './proposal';
import { ProposalForm } from './ProposalForm';

const SOURCES: readonly { value: ComponentDraft['source']; label: string }[] = [
  { value: 'files', label: 'Files' },
  { value: 'ros', label: 'ROS 2' },
  { value: 'small', label: 'Small example' },
];

const CLASSES = {
  java: 'package.Class',
  cpp: 'namespace::Class',
  python: 'module.Class',
} as const;

interface NewComponentProps {
  draft: ComponentDraft;
  set: (changes: Partial<ComponentDraft>) => void;
  onCreated: (activity: Activity) => void;
}

/** Begins an activity with the interface of a component that does not exist yet. */
export function NewComponent({ draft, set, onCreated }: NewComponentProps) {
  const interfaceFrom = useId();
  const candidates = interfacesIn(draft.files);
  return (
    <ProposalForm request={requestOfComponent(draft)} onCreated={onCreated}>
      <NameField
        name={draft.name}
        onName={(name) => {
          set({ name });
        }}
      />
      <div>
        <Text size="sm" fw={600} id={interfaceFrom}>
          Interface
        </Text>
        <SegmentedControl
          aria-labelledby={interfaceFrom}
          fullWidth
          value={draft.source}
          onChange={(value) => {
            set({ source: SOURCES.find((known) => known.value === value)?.value ?? 'files' });
          }}
          data={[...SOURCES]}
        />
      </div>
      {draft.source === 'files' && (
        <FilePicker
          label="Interface files"
          description="OPRoS XML, OMG IDL, ROS srv or action, protobuf; with the files that they refer to"
          folder
          whole
          files={draft.files}
          onFiles={(files) => {
            set({ files });
          }}
        />
      )}
      {draft.source === 'files' && candidates.length > 1 && (
        <NativeSelect
          label="Interface of the component"
          data={candidates}
          value={fileOf(draft)}
          onChange={(event) => {
            set({ chosenFile: event.currentTarget.value });
          }}
        />
      )}
      {draft.source === 'ros' && (
        <TextInput
          label="Interface of ROS 2"
          description="An installed service or action, such as nav_msgs/srv/GetPlan.srv"
          required
          value={draft.installed}
          onChange={(event) => {
            set({ installed: event.currentTarget.value });
          }}
        />
      )}
      {draft.source === 'small' && (
        <Text size="sm" c="dimmed">
          The activity begins with Controller.idl, an interface with one method. Change it to yours.
        </Text>
      )}
      <Group align="start" grow preventGrowOverflow={false}>
        <NativeSelect
          label="Language of the component"
          description="Of the proposed skeleton"
          data={[...LANGUAGES]}
          value={draft.language}
          onChange={(event) => {
            set({ language: languageOf(event.currentTarget.value) });
          }}
        />
        <TextInput
          label="Component class"
          description={`Optional, such as ${CLASSES[draft.language]}`}
          value={draft.className}
          onChange={(event) => {
            set({ className: event.currentTarget.value });
          }}
        />
      </Group>
      <Text size="sm" c="dimmed">
        The proposal has no world. <Code>./sitaf new --robot FILE</Code> proposes one for a robot; a
        world that exists is added in the tab Files of the activity.
      </Text>
    </ProposalForm>
  );
}
