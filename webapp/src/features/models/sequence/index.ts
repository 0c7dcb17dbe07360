export { CallInputs } from './CallInputs';
export { CallOutputs } from './CallOutputs';
export { SequenceStep } from './SequenceStep';
