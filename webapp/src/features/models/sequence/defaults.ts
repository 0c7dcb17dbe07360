import type { Words } from '@/shared/ui';
import {
  argumentsOf,
  faultInputs,
  freeName,
  outputsOf,
  stubInputs,
  worldInputs,
  type Candidate,
  type Description,
  type Method,
} from '../defaults';
import type { CallDraft, EventDraft, SequenceDraft } from '../document';

/** The methods that a sequence of an interface can call. */
export function methodsOf(description: Description, interfaceName: string): Method[] {
  const interfaces = description.provided.filter(
    ({ name }) => interfaceName === '' || name === interfaceName,
  );
  return interfaces.flatMap(({ methods }) => methods);
}

/** The method of a call; undefined if the interface has none of this name. */
export function methodOf(
  methods: readonly Method[],
  call: Pick<CallDraft, 'method' | 'signature'>,
): Method | undefined {
  return methods.find(
    ({ name, signature }) =>
      name === call.method && (call.signature === '' || call.signature === signature),
  );
}

/** A call of a method, with the inputs and outputs that the interface declares. */
export function callOf(
  method: Method,
  methods: readonly Method[],
  sequence: SequenceDraft,
): CallDraft {
  const overloaded = methods.filter(({ name }) => name === method.name).length > 1;
  return {
    name: freeName(method.name, namesOf(sequence), '_'),
    guard: '',
    updates: [],
    method: method.name,
    signature: overloaded ? method.signature : '',
    settle: '',
    runFor: '',
    overlap: '',
    forbidden: '',
    preConditions: [],
    inputs: argumentsOf(method).map(({ input }) => input),
    outputs: outputsOf(method),
    postConditions: [],
  };
}

/** An event that sets a parameter of the world or a fault. */
export function eventOf(set: string, sequence: SequenceDraft): EventDraft {
  return {
    name: freeName('Event', namesOf(sequence), '_'),
    guard: '',
    updates: [],
    set,
    to: set.startsWith('fault.') ? '1' : '0',
  };
}

/** What an event can set. */
export function changesOf(description: Description): string[] {
  const switched = faultInputs(description, []).map(({ input }) => input.name);
  return [...worldInputs(description).map(({ input }) => input.name), ...switched];
}

/** What a call can set around it and does not yet: the world, faults of devices, and answers of stubs. */
export function surroundingsOf(description: Description, call: CallDraft): Candidate[] {
  const names = call.inputs.map(({ name }) => name);
  return [
    ...worldInputs(description),
    ...faultInputs(description, names),
    ...stubInputs(description),
  ].filter(({ input }) => !names.includes(input.name));
}

function namesOf({ calls, events }: SequenceDraft): string[] {
  return [...calls, ...events].map(({ name }) => name);
}

/** The names that guards see. */
export function stateWords({ states }: SequenceDraft): Words {
  return states.map(({ name, type }) => ({ label: name, detail: `state ${type}` }));
}
