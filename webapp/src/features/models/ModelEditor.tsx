import { Alert, Button, Group, Stack, Stepper, Text } from '@mantine/core';
import { useMemo, useState } from 'react';
import { ApiError, type Activity } from '@/shared/api';
import { ProblemAlert } from '@/shared/ui';
import { draftFor, outputsOf, argumentsOf, type Description } from './defaults';
import type { ModelDraft } from './draft';
import { MethodStep } from './MethodStep';
import { OrderStep } from './OrderStep';
import { ParametersStep } from './ParametersStep';
import { usePreview, useSaveModel } from './queries';
import { SpecificationStep } from './SpecificationStep';
import { writeModel } from './xml';

interface ModelEditorProps {
  activity: Activity;
  description: Description;
  /** The model as it is; absent for a new one. */
  existing?: { name: string; draft: ModelDraft; version: number };
  /** Called once all is stored and nothing more was asked for. */
  onSaved: (model: string) => void;
  /** Called once all is stored and the cases are to be generated. */
  onGenerate: (model: string) => void;
  generating: boolean;
}

const LAST_STEP = 3;

/** A test model in four steps (Fig. 14); what it gives shows all the while. */
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
  const [stored, setStored] = useState(existing ? writeModel(existing.draft) : '');
  // A new model that is stored is new no more, though the page is still the one it began on.
  const [storedAs, setStoredAs] = useState(existing?.name);
  const [version, setVersion] = useState(existing?.version ?? activity.version);
  const document = useMemo(() => writeModel(draft), [draft]);
  const preview = usePreview(activity.id, document, step === LAST_STEP);
  const save = useSaveModel(activity, storedAs);
  const changed = document !== stored;
  const method = description.provided
    .filter(({ name }) => draft.target.interface === '' || name === draft.target.interface)
    .flatMap(({ methods }) => methods)
    .find(
      ({ name, signature }) =>
        name === draft.target.method &&
        (draft.target.signature === '' || draft.target.signature === signature),
    );

  function choose(interfaceName: string, signature: string, name: string) {
    const methods =
      description.provided.find((known) => known.name === interfaceName)?.methods ?? [];
    const chosen = methods.find((m) => m.name === name && m.signature === signature);
    if (!chosen) return;
    const overloaded = methods.filter((m) => m.name === name).length > 1;
    const fresh = draftFor(interfaceName, chosen, namesOf(activity), overloaded);
    setDraft({
      ...draft,
      name: storedAs === undefined ? fresh.name : draft.name,
      target: { ...fresh.target, settle: draft.target.settle, runFor: draft.target.runFor },
      // What the world and the stubs give stays; the arguments are another method's.
      inputs: [
        ...argumentsOf(chosen).map(({ input }) => input),
        ...draft.inputs.filter(({ kind }) => kind !== 'TDI'),
      ],
      outputs: outputsOf(chosen),
    });
  }

  function store(then: (model: string) => void) {
    save.mutate(
      { name: draft.name, document, version },
      {
        onSuccess: (now) => {
          setStored(document);
          setStoredAs(draft.name);
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
        <Stepper.Step label="Method" description="under test" />
        <Stepper.Step label="Parameters" description="that vary" />
        <Stepper.Step label="Specification" description="of their values" />
        <Stepper.Step label="Combination" description="and conditions" />
      </Stepper>
      {step === 0 && (
        <MethodStep
          description={description}
          draft={draft}
          isNew={storedAs === undefined}
          onChange={setDraft}
          onMethod={choose}
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
        <ProblemAlert title="The values could not be worked out" error={preview.error} />
      )}
      {save.isError &&
        (save.error instanceof ApiError && save.error.status === 412 ? (
          <Alert role="alert" color="orange" variant="outline" title="The activity was changed">
            Somebody else changed it meanwhile, and nothing was overwritten. Open the page anew to
            see it; what you wrote is lost then.
          </Alert>
        ) : (
          <ProblemAlert title="The model was not stored" error={save.error} onClose={save.reset} />
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
            ? `${errors.length} to mend: ${errors[0]?.element ?? ''} ${errors[0]?.message ?? ''}`
            : changed
              ? 'Not stored yet'
              : 'All stored'}
        </Text>
        <Group gap="sm">
          <Button
            variant={step === LAST_STEP ? 'default' : 'subtle'}
            disabled={!changed}
            loading={save.isPending}
            onClick={() => {
              store(onSaved);
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
                if (changed) store(onGenerate);
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
  // The method with the most to vary is the likeliest to be meant.
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
    preConditions: [],
    inputs: [],
    outputs: [],
    postConditions: [],
    invalidValues: 'isolate',
    order: '2',
    others: [],
  };
}
