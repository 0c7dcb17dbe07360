export { CaseReplay } from './CaseReplay';
export { LiveReplay } from './LiveReplay';
export { useRecordedCases } from './queries';
export type { StepMark } from './StepMarks';
