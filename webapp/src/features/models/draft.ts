/** A test model while it is being written: all settings as texts, as they stand in its document. */
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
  preConditions: string[];
  inputs: InputDraft[];
  outputs: OutputDraft[];
  postConditions: string[];
  invalidValues: 'isolate' | 'combine';
  order: string;
  /** Parts of the document that this editor does not show (mixed strength, kept cases), unchanged. */
  others: string[];
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
  userValues: string[];
}

export const SCHEMES = ['BVA', 'ECP', 'RANDOM', 'RANDOM_STRING'] as const;
export type Scheme = (typeof SCHEMES)[number];

export interface SpecDraft {
  type: Scheme;
  /** By the name of the attribute or element. */
  settings: Record<string, string>;
  classes: ClassDraft[];
  ranges: { min: string; max: string; weight: string }[];
}

export const CLASSES = [
  { value: 'NEC_NUMERIC_TWO_BOUNDARY', label: 'between two boundaries' },
  { value: 'NEC_NUMERIC_ONE_BOUNDARY', label: 'one boundary' },
  { value: 'NEC_NUMERIC_CONSTANT', label: 'a constant' },
  { value: 'NEC_NUMERIC_SET', label: 'a set of values' },
  { value: 'NEC_BOOLEAN', label: 'true or false' },
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
  absolute: string;
  relative: string;
}
