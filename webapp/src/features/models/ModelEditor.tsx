import { Alert, Button, Group, SegmentedControl, Stack, Stepper, Text } from '@mantine/core';
import { useMemo, useState } from 'react';
import { ApiError, type Activity } from '@/shared/api';
import { plural } from '@/shared/lib/format';
import { ProblemAlert } from '@/shared/ui';
import { argumentsOf, draftFor, freeName, outputsOf, type Description } from './defaults';
import { readModel, writeModel, type ModelDraft } from './document';
import { MethodStep } from './MethodStep';
import { OrderStep } from './OrderStep';
import { ParametersStep } from './ParametersStep';
import { usePreview, useSaveModel, useSequenceProposal } from './queries';
import { SequenceStep } from './sequence';
import { SpecificationStep } from './values';

interface ModelEditorProps {
  activity: Activity;
  description: Description;
  /** The stored model; absent for a new one. */
  existing?: { name: string; draft: ModelDraft; version: number };
  /** Called after *Save*. */
  onSaved: (model: string) => void;
  /** Called after *Generate test cases*, when the model is saved. */
  onGenerate: (model: string) => void;
  generating: boolean;
}

const LAST_STEP = 3;

/** Edits a test model in four steps (Fig. 14) with a preview of its values and cases. */
export function ModelEditor({
  activity,
  description,
  existing,
  onSaved,
  onGenerate,
  generating,
}: ModelEditorProps) {
  const [step, setStep] = useState(0);
  const [draft, setDraft] = useState<ModelDraft>(
    () => existing?.draft ?? firstDraft(activity, description),
  );
  const [saved, setSaved] = useState(existing ? writeModel(existing.draft) : '');
  // Set when a new model has been saved for the first time.
  const [savedAs, setSavedAs] = useState(existing?.name);
  const [version, setVersion] = useState(existing?.version ?? activity.version);
  const document = useMemo(() => writeModel(draft), [draft]);
  const preview = usePreview(activity.id, document, step === LAST_STEP);
  const save = useSaveModel(activity, savedAs);
  const proposal = useSequenceProposal(activity.id);
  const changed = document !== saved;
  const method = description.provided
    .filter(({ name }) => draft.target.interface === '' || name === draft.target.interface)
    .flatMap(({ methods }) => methods)
    .find(
      ({ name, signature }) =>
        name === draft.target.method &&
        (draft.target.signature === '' || draft.target.signature === signature),
    );

  function chooseMethod(interfaceName: string, signature: string, name: string) {
    const methods =
      description.provided.find((known) => known.name === interfaceName)?.methods ?? [];
    const chosen = methods.find((m) => m.name === name && m.signature === signature);
    if (!chosen) return;
    const overloaded = methods.filter((m) => m.name === name).length > 1;
    const initial = draftFor(interfaceName, chosen, namesOf(activity), overloaded);
    setDraft({
      ...draft,
      name: savedAs === undefined ? initial.name : draft.name,
      target: { ...initial.target, settle: draft.target.settle, runFor: draft.target.runFor },
      // Inputs of the world and of stubs do not depend on the method.
      inputs: [
        ...argumentsOf(chosen).map(({ input }) => input),
        ...draft.inputs.filter(({ kind }) => kind !== 'TDI'),
      ],
      outputs: outputsOf(chosen),
    });
  }

  /** Begins a model of sequences with what the names of the methods tell. */
  function propose(interfaceName: string) {
    const name = freeName('Sequences', namesOf(activity));
    proposal.mutate(
      { interfaceName: interfaceName || (description.provided[0]?.name ?? ''), name },
      {
        onSuccess: (document) => {
          setDraft(readModel(document));
        },
      },
    );
  }

  function saveThen(then: (model: string) => void) {
    save.mutate(
      { name: draft.name, document, version },
      {
        onSuccess: (now) => {
          setSaved(document);
          setSavedAs(draft.name);
          setVersion(now.version);
          then(draft.name);
        },
      },
    );
  }

  const errors = (preview.data?.diagnostics ?? []).filter(({ severity }) => severity === 'ERROR');
  return (
    <Stack gap="lg">
      <Stepper active={step} onStepClick={setStep} size="sm">
        {draft.sequence ? (
          <Stepper.Step label="Sequence" description="of calls and events" />
        ) : (
          <Stepper.Step label="Method" description="to test" />
        )}
        <Stepper.Step label="Parameters" description="to vary" />
        <Stepper.Step label="Values" description="of each parameter" />
        <Stepper.Step label="Combination" description="and expected values" />
      </Stepper>
      {step === 0 && savedAs === undefined && (
        <SegmentedControl
          aria-label="What a case does"
          value={draft.sequence ? 'sequence' : 'call'}
          data={[
            { value: 'call', label: 'One call in a case' },
            { value: 'sequence', label: 'A sequence of calls in a case' },
          ]}
          onChange={(kind) => {
            if (kind === 'sequence') propose(draft.target.interface);
            else setDraft(firstDraft(activity, description));
          }}
        />
      )}
      {proposal.isError && (
        <ProblemAlert title="No sequence could be proposed" error={proposal.error} />
      )}
      {step === 0 && draft.sequence && (
        <SequenceStep
          description={description}
          draft={draft}
          sequence={draft.sequence}
          isNew={savedAs === undefined}
          preview={preview.data}
          onChange={setDraft}
          onInterface={propose}
        />
      )}
      {step === 0 && !draft.sequence && (
        <MethodStep
          description={description}
          draft={draft}
          isNew={savedAs === undefined}
          onChange={setDraft}
          onMethod={chooseMethod}
        />
      )}
      {step === 1 && (
        <ParametersStep
          description={description}
          method={method}
          draft={draft}
          onChange={setDraft}
        />
      )}
      {step === 2 && <SpecificationStep draft={draft} preview={preview.data} onChange={setDraft} />}
      {step === LAST_STEP && (
        <OrderStep
          draft={draft}
          preview={preview.data}
          counting={preview.isFetching}
          onChange={setDraft}
        />
      )}
      {preview.isError && (
        <ProblemAlert title="The values could not be generated" error={preview.error} />
      )}
      {save.isError &&
        (save.error instanceof ApiError && save.error.status === 412 ? (
          <Alert role="alert" color="orange" variant="outline" title="The activity was changed">
            Another user changed the activity since you opened it. Nothing was overwritten. Reload
            the page to see the new version; your changes will be lost.
          </Alert>
        ) : (
          <ProblemAlert title="The model was not saved" error={save.error} onClose={save.reset} />
        ))}
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
        <Text size="sm" c={errors.length > 0 ? 'red' : 'dimmed'} role="status">
          {errors.length > 0
            ? `${plural(errors.length, 'problem')}: ${errors[0]?.element ?? ''} ${errors[0]?.message ?? ''}`
            : changed
              ? 'Unsaved changes'
              : 'Saved'}
        </Text>
        <Group gap="sm">
          <Button
            variant={step === LAST_STEP ? 'default' : 'subtle'}
            disabled={!changed}
            loading={save.isPending}
            onClick={() => {
              saveThen(onSaved);
            }}
          >
            Save
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
              loading={save.isPending || generating}
              disabled={errors.length > 0}
              onClick={() => {
                if (changed) saveThen(onGenerate);
                else onGenerate(draft.name);
              }}
            >
              Generate test cases
            </Button>
          )}
        </Group>
      </Group>
    </Stack>
  );
}

function namesOf({ models }: Activity): string[] {
  return models.map(({ name }) => name);
}

function firstDraft(activity: Activity, description: Description): ModelDraft {
  const [first] = description.provided;
  // The method with the most parameters is the most likely choice.
  const method = [...(first?.methods ?? [])].sort(
    (a, b) => b.parameters.length - a.parameters.length,
  )[0];
  if (first && method) {
    const overloaded = first.methods.filter(({ name }) => name === method.name).length > 1;
    return draftFor(first.name, method, namesOf(activity), overloaded);
  }
  return {
    name: 'Model',
    description: '',
    target: { interface: '', method: '', signature: '', settle: '', runFor: '' },
    definitions: [],
    preConditions: [],
    inputs: [],
    outputs: [],
    postConditions: [],
    trajectoryConditions: [],
    relations: [],
    invalidValues: 'isolate',
    order: '2',
    maxCases: '',
    timing: null,
    sequence: null,
    strengths: [],
    others: [],
    comments: [],
  };
}
