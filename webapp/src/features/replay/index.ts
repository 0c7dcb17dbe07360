export { CaseReplay } from './CaseReplay';
export { ReplayPair } from './ReplayPair';
export { LiveReplay } from './LiveReplay';
export { useRecordedCases } from './queries';
export type { StepMark } from './StepMarks';
