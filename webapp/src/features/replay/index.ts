export { CasePreview } from './CasePreview';
export { CaseReplay } from './CaseReplay';
export type { EventMark } from './EventMarks';
export { ReplayPair } from './ReplayPair';
export { RelationReplays } from './RelationReplays';
export { LiveReplay } from './LiveReplay';
export { useRecordedCases } from './queries';
export type { StepMark } from './StepMarks';
