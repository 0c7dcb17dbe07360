import type { Comment } from './comments';

/** A test model in the editor. All settings are texts, as in the document. */
export interface ModelDraft {
  name: string;
  description: string;
  target: {
    interface: string;
    method: string;
    signature: string;
    settle: string;
    runFor: string;
  };
  /** Named sub-expressions. */
  definitions: NamedText[];
  preConditions: NamedText[];
  inputs: InputDraft[];
  outputs: OutputDraft[];
  postConditions: NamedText[];
  trajectoryConditions: TrajectoryDraft[];
  relations: RelationDraft[];
  invalidValues: 'isolate' | 'combine';
  order: string;
  /** Maximum number of cases; empty if there is none. */
  maxCases: string;
  /** Repeated calls of each case; null if the model does not say. */
  timing: { warmUp: string; repeat: string } | null;
  /** Null if a case is one call. */
  sequence: SequenceDraft | null;
  /** Mixed strengths, as XML; the editor does not show them. */
  strengths: string[];
  /** Kept cases, as XML; the editor does not show them. */
  others: string[];
  /** Comments of the document; the editor does not show them. */
  comments: Comment[];
}

/** Which sequences of calls and events are generated. */
export interface SequenceDraft {
  length: string;
  order: string;
  /** `false` if a case has each step at most once. */
  repeat: string;
  threads: string;
  states: StateDraft[];
  calls: CallDraft[];
  events: EventDraft[];
}

/** A variable of the abstract state. */
export interface StateDraft {
  name: string;
  type: string;
  initial: string;
}

/** A step of a sequence. */
export interface StepDraft {
  name: string;
  /** Empty if the step is always allowed. */
  guard: string;
  /** Each names a state. */
  updates: NamedText[];
}

export interface CallDraft extends StepDraft {
  method: string;
  signature: string;
  settle: string;
  runFor: string;
  overlap: string;
  /** What the call does where the guard is false; empty if it is not made there. */
  forbidden: string;
  preConditions: NamedText[];
  inputs: InputDraft[];
  outputs: OutputDraft[];
  postConditions: NamedText[];
}

export interface EventDraft extends StepDraft {
  /** A parameter of the world, or a fault of a device. */
  set: string;
  to: string;
}

/** A condition over time; `from` is empty for the call. */
export interface TrajectoryDraft {
  name: string;
  from: string;
  formula: string;
}

/** A relation between two runs: the changed inputs of the second run, and what must hold. */
export interface RelationDraft {
  name: string;
  /** Each names an input. */
  changes: NamedText[];
  holds: string;
}

/** An expression with its name; pre-conditions have none. */
export interface NamedText {
  name: string;
  text: string;
}

export type InputKind = 'TDI' | 'TDSD' | 'TDTS';
export const INPUT_KINDS: readonly InputKind[] = ['TDI', 'TDSD', 'TDTS'];

export interface InputDraft {
  name: string;
  kind: InputKind;
  abstractType: string;
  realType: string;
  description: string;
  spec: SpecDraft | null;
  /** Further specifications; the values are the union of all. */
  furtherSpecs: SpecDraft[];
  userValues: string[];
}

export const SCHEMES = [
  'BVA',
  'ECP',
  'RANDOM',
  'RANDOM_STRING',
  'ROTATION',
  'DIRECTION',
  'POSE',
  'RELATED',
] as const;
export type Scheme = (typeof SCHEMES)[number];

export interface SpecDraft {
  type: Scheme;
  /** By name of the attribute or element. */
  settings: Record<string, string>;
  classes: ClassDraft[];
  ranges: { min: string; max: string; weight: string }[];
}

export const CLASSES = [
  { value: 'NEC_NUMERIC_TWO_BOUNDARY', label: 'A range' },
  { value: 'NEC_NUMERIC_ONE_BOUNDARY', label: 'A range with one boundary' },
  { value: 'NEC_NUMERIC_CONSTANT', label: 'A constant' },
  { value: 'NEC_NUMERIC_SET', label: 'A set of values' },
  { value: 'NEC_BOOLEAN', label: 'A boolean' },
] as const;

export interface ClassDraft {
  type: string;
  attributes: Record<string, string>;
  values: string[];
}

export const OUTPUT_KINDS = ['RETURN', 'OUT', 'OBSERVED'] as const;

export interface OutputDraft {
  name: string;
  kind: (typeof OUTPUT_KINDS)[number];
  abstractType: string;
  realType: string;
  description: string;
  expected: string;
  /** Names of exceptions that pass as well, separated by blanks. */
  orError: string;
  /** Attributes of the element `tolerance`, by name. */
  tolerance: Record<string, string>;
}
