import { NativeSelect, Text } from '@mantine/core';
import { useState } from 'react';
import type { Activity } from '@/shared/api';
import { FilePicker } from './FilePicker';
import { NameField } from './NameField';
import {
  folderOf,
  nodesFirst,
  packagesIn,
  requestOfPackage,
  withoutHidden,
  type PackageDraft,
} from './proposal';
import { ProposalForm } from './ProposalForm';

interface RosPackageProps {
  draft: PackageDraft;
  set: (changes: Partial<PackageDraft>) => void;
  onCreated: (activity: Activity) => void;
}

/** Begins an activity with the package of a ROS 2 node. */
export function RosPackage({ draft, set, onCreated }: RosPackageProps) {
  const [nodes, setNodes] = useState<readonly string[]>(draft.node === '' ? [] : [draft.node]);
  const folders = nodesFirst(packagesIn(draft.files), draft.files);
  /** The nodes of another package or language are others. */
  const change = (changes: Partial<PackageDraft>) => {
    setNodes([]);
    set({ ...changes, node: '' });
  };
  return (
    <ProposalForm
      request={requestOfPackage(draft)}
      onCreated={onCreated}
      onNodes={(several) => {
        setNodes(several);
        set({ node: several[0] ?? '' });
      }}
    >
      <NameField
        name={draft.name}
        onName={(name) => {
          set({ name });
        }}
      />
      <FilePicker
        label="ROS 2 package"
        description="The folder of package.xml or a zip of it; or the folder above it, with the interface packages that it uses"
        folder
        whole
        files={draft.files}
        onFiles={(files) => {
          change({ files: withoutHidden(files) });
        }}
      />
      {folders.length > 1 && (
        <NativeSelect
          label="Package of the node"
          data={folders}
          value={folderOf(draft)}
          onChange={(event) => {
            change({ chosenFolder: event.currentTarget.value });
          }}
        />
      )}
      <NativeSelect
        label="Language of the node"
        data={[
          { value: '', label: 'As in the package' },
          { value: 'python', label: 'Python' },
          { value: 'cpp', label: 'C++' },
        ]}
        value={draft.language}
        onChange={(event) => {
          const { value } = event.currentTarget;
          change({ language: value === 'python' || value === 'cpp' ? value : '' });
        }}
      />
      <Text size="sm" role="status">
        {nodes.length > 0 && 'The package holds several nodes. Choose the one to test.'}
      </Text>
      {nodes.length > 0 && (
        <NativeSelect
          label="Node"
          data={[...nodes]}
          value={draft.node}
          onChange={(event) => {
            set({ node: event.currentTarget.value });
          }}
        />
      )}
    </ProposalForm>
  );
}
