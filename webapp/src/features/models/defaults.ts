import type { ActivityDescription } from '@/shared/api';
import type { InputDraft, ModelDraft, OutputDraft, Scheme, SpecDraft } from './document';

export type Description = ActivityDescription;
export type Method = Description['provided'][number]['methods'][number];
type Type = Method['returnType'];

const INTEGER = /^u?int(8|16|32|64)$|^(octet|byte|short|long|int|char)$/;
const FLOATING = /^(float|double)$/;

export function isNumeric(realType: string): boolean {
  return INTEGER.test(realType) || FLOATING.test(realType);
}

function abstractTypeOf(type: Type): string {
  if (type.kind === 'enumeration') return 'ENUM';
  if (type.spelling === 'boolean' || type.spelling === 'bool') return 'BOOLEAN';
  return type.spelling.startsWith('string') ? 'STRING' : 'NUMERIC';
}

/** An input that can be added to a model. */
export interface Candidate {
  input: InputDraft;
  note: string;
}

/** The inputs of the method under test: members of structs, first elements of sequences. */
export function argumentsOf(method: Method): Candidate[] {
  return method.parameters
    .filter(({ direction }) => direction !== 'OUT')
    .flatMap(({ name, type }) => leaves(name, type))
    .map(({ name, type }) => ({
      input: inputOf(name, 'TDI', type),
      note: type.spelling,
    }));
}

/** The parameters of the world. */
export function worldInputs({ world }: Description): Candidate[] {
  return (world?.parameters ?? []).map(({ name, unit, min, max, defaultValue }) => {
    // The values outside the boundaries must still be in the range of the world.
    const offset = round((max - min) / 40);
    return {
      input: {
        name,
        kind: 'TDSD',
        abstractType: 'NUMERIC',
        realType: 'double',
        description: '',
        spec: boundaries(String(offset), String(round(min + offset)), String(round(max - offset))),
        furtherSpecs: [],
        userValues: [],
      },
      note: `${min} to ${max} ${unit === '1' ? '' : unit}, default ${defaultValue}`,
    };
  });
}

/**
 * The faults of the world's devices, and the times of those that are selected.
 *
 * @param selected names of inputs
 */
export function faultInputs({ world }: Description, selected: readonly string[]): Candidate[] {
  return (world?.devices ?? []).flatMap(({ name, kind, faults }) =>
    faults.flatMap((fault) => {
      const input = `fault.${name}.${fault}`;
      const values = FAULT_VALUES[fault];
      const times: Candidate[] = [
        { input: faultInput(`${input}.at`, 'double', ['0.5']), note: 'seconds after the call' },
        { input: faultInput(`${input}.for`, 'double', ['1']), note: 'duration in seconds' },
      ];
      return [
        { input: faultInput(input, values ? 'double' : 'int', values ?? ['0', '1']), note: kind },
        ...(selected.includes(input) ? times : []),
      ];
    }),
  );
}

/** Whether an input is a time or the value of a fault, which has no effect without the fault. */
export function isPartOfFault(name: string, fault: string): boolean {
  return ['.at', '.for', '.value'].some((part) => name === fault + part);
}

function faultInput(name: string, realType: string, userValues: string[]): InputDraft {
  return {
    name,
    kind: 'TDSD',
    abstractType: 'NUMERIC',
    realType,
    description: '',
    spec: null,
    furtherSpecs: [],
    userValues,
  };
}

/** Values of the faults that are no switches: no fault first. */
const FAULT_VALUES: Partial<Record<string, string[]>> = {
  offset: ['0', '0.1'],
  scale: ['1', '1.1'],
  noise: ['0', '0.05'],
  delay: ['0', '0.1'],
  intermittent: ['0', '0.2'],
};

/** The return values and out-parameters of the test stub. */
export function stubInputs({ required }: Description): Candidate[] {
  return required.flatMap(({ name, methods }) =>
    methods.flatMap((method) => [
      ...(method.returnType.spelling === 'void'
        ? []
        : [
            {
              input: inputOf(`${name}.${method.name}`, 'TDTS', method.returnType),
              note: `return value, ${method.returnType.spelling}`,
            },
          ]),
      ...method.parameters
        .filter(({ direction }) => direction !== 'IN')
        .map((parameter) => ({
          input: inputOf(`${name}.${method.name}.${parameter.name}`, 'TDTS', parameter.type),
          note: `out-parameter, ${parameter.type.spelling}`,
        })),
    ]),
  );
}

function leaves(name: string, type: Type): { name: string; type: Type }[] {
  if (type.members.length === 0) return [{ name, type }];
  return type.members.flatMap((member) =>
    leaves(member.name === '[]' ? `${name}[0]` : `${name}.${member.name}`, member.type),
  );
}

function inputOf(name: string, kind: InputDraft['kind'], type: Type): InputDraft {
  const abstractType = abstractTypeOf(type);
  return {
    name,
    kind,
    abstractType,
    realType: type.spelling,
    description: '',
    // The values of booleans and enumerations follow from the type.
    spec:
      abstractType === 'NUMERIC'
        ? defaultSpec('BVA')
        : abstractType === 'STRING'
          ? defaultSpec('RANDOM_STRING')
          : null,
    furtherSpecs: [],
    userValues: [],
  };
}

function boundaries(offset: string, min: string, max: string): SpecDraft {
  return {
    type: 'BVA',
    settings: { offset },
    classes: [{ type: 'NEC_NUMERIC_TWO_BOUNDARY', attributes: { min, max }, values: [] }],
    ranges: [],
  };
}

export function defaultSpec(scheme: Scheme): SpecDraft {
  switch (scheme) {
    case 'BVA':
      return boundaries('1', '0', '10');
    case 'ECP':
      return { ...boundaries('1', '0', '10'), type: 'ECP' };
    case 'RANDOM':
      return {
        type: 'RANDOM',
        settings: { count: '5', min: '0', max: '10', distribution: 'uniform' },
        classes: [],
        ranges: [],
      };
    case 'RANDOM_STRING':
      return {
        type: 'RANDOM_STRING',
        settings: {
          min_length: '1',
          max_length: '10',
          alphabet: 'true',
          number: 'true',
          special_char: 'false',
          space: 'false',
        },
        classes: [],
        ranges: [],
      };
    case 'ROTATION':
      return plain(scheme, { as: 'quaternion_xyzw', count: '48' });
    case 'DIRECTION':
      return plain(scheme, { count: '26' });
    case 'POSE':
      return plain(scheme, { as: 'quaternion_xyzw', count: '48', min: '-1', max: '1' });
    case 'RELATED':
      return plain(scheme, { to: '', offsets: '0 1ulp -1ulp 1e-9 -1e-9' });
  }
}

function plain(type: Scheme, settings: Record<string, string>): SpecDraft {
  return { type, settings, classes: [], ranges: [] };
}

/** A new model of a method, with the inputs and outputs that the interface declares. */
export function draftFor(
  interfaceName: string,
  method: Method,
  taken: readonly string[],
  overloaded: boolean,
): ModelDraft {
  return {
    name: freeName(method.name, taken),
    description: '',
    target: {
      interface: interfaceName,
      method: method.name,
      signature: overloaded ? method.signature : '',
      settle: '',
      runFor: '',
    },
    definitions: [],
    preConditions: [],
    inputs: argumentsOf(method).map(({ input }) => input),
    outputs: outputsOf(method),
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

export function outputsOf(method: Method): OutputDraft[] {
  const output = (name: string, kind: OutputDraft['kind'], type: Type): OutputDraft => ({
    name,
    kind,
    abstractType: abstractTypeOf(type),
    realType: type.spelling,
    description: '',
    expected: '',
    orError: '',
    tolerance: FLOATING.test(type.spelling) ? { absolute: '1e-9' } : {},
  });
  return [
    ...(method.returnType.spelling === 'void'
      ? []
      : [output('return', 'RETURN', method.returnType)]),
    ...method.parameters
      .filter(({ direction }) => direction !== 'IN')
      .map(({ name, type }) => output(name, 'OUT', type)),
  ];
}

/** A name that is not taken: the wanted one, or one with a number. */
export function freeName(wanted: string, taken: readonly string[], separator = '-'): string {
  if (!taken.includes(wanted)) return wanted;
  let number = 2;
  while (taken.includes(`${wanted}${separator}${number}`)) number++;
  return `${wanted}${separator}${number}`;
}

function round(value: number): number {
  return Number(value.toPrecision(3));
}
