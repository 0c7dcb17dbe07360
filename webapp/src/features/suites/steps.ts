import type { SuiteCase } from '@/shared/api';

type Step = SuiteCase['steps'][number];

/** A step with the values of its inputs, and its expected values. */
export function stepText(step: Step): string {
  const outcome = Object.values(step.expected);
  return outcome.length > 0 ? `${callText(step)} = ${outcome.join(', ')}` : callText(step);
}

/** A step with the values of its inputs. */
export function callText({ name, inputs }: Pick<Step, 'name' | 'inputs'>): string {
  const values = Object.values(inputs);
  return values.length > 0 ? `${name}(${values.join(', ')})` : name;
}
