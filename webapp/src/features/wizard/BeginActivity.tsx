import { Radio, Stack } from '@mantine/core';
import { useState } from 'react';
import type { Activity } from '@/shared/api';
import { EMPTY, type WizardDraft } from './draft';
import { NewComponent } from './NewComponent';
import { NEW_COMPONENT, NEW_PACKAGE, type ComponentDraft, type PackageDraft } from './proposal';
import { RosPackage } from './RosPackage';
import { Wizard } from './Wizard';

type Beginning = 'component' | 'package' | 'files';

const BEGINNINGS: readonly { value: Beginning; label: string; description: string }[] = [
  {
    value: 'component',
    label: 'A new component',
    description: 'From its interface: test models, the skeleton of the component and a profile',
  },
  {
    value: 'package',
    label: 'A ROS 2 package',
    description: 'A node as it is, with test models for its topics, services and actions',
  },
  {
    value: 'files',
    label: 'Files that I have',
    description: 'A component, its interfaces and a world; test models are written later',
  },
];

/** An activity that was created, and whether it already has test models. */
export interface BegunActivity {
  activity: Activity;
  hasModels: boolean;
}

/** Creates an activity: first a person says what exists. */
export function BeginActivity({ onCreated }: { onCreated: (begun: BegunActivity) => void }) {
  const [beginning, setBeginning] = useState<Beginning>('component');
  // The drafts outlive a look at another beginning.
  const [component, setComponent] = useState<ComponentDraft>(NEW_COMPONENT);
  const [ros, setRos] = useState<PackageDraft>(NEW_PACKAGE);
  const [files, setFiles] = useState<WizardDraft>(EMPTY);
  const created = (activity: Activity) => {
    onCreated({ activity, hasModels: beginning !== 'files' });
  };
  return (
    <Stack gap="lg">
      <Radio.Group
        label="Begin with"
        value={beginning}
        onChange={(value) => {
          setBeginning(BEGINNINGS.find((known) => known.value === value)?.value ?? 'component');
        }}
      >
        <Stack gap="xs" mt="xs">
          {BEGINNINGS.map((known) => (
            <Radio key={known.value} {...known} />
          ))}
        </Stack>
      </Radio.Group>
      {beginning === 'component' && (
        <NewComponent
          draft={component}
          set={(changes) => {
            // Reading files takes time: keep what was typed in the meantime.
            setComponent((known) => ({ ...known, ...changes }));
          }}
          onCreated={created}
        />
      )}
      {beginning === 'package' && (
        <RosPackage
          draft={ros}
          set={(changes) => {
            setRos((known) => ({ ...known, ...changes }));
          }}
          onCreated={created}
        />
      )}
      {beginning === 'files' && (
        <Wizard
          draft={files}
          set={(changes) => {
            setFiles((known) => ({ ...known, ...changes }));
          }}
          onCreated={created}
        />
      )}
    </Stack>
  );
}
