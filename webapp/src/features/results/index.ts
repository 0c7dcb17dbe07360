export { CoverageView } from './CoverageView';
export { LiveCases } from './LiveCases';
export { CaseFacts } from './CaseFacts';
export { RelationRuns } from './RelationRuns';
export { useCase, useFirstCases, useResult, type CaseFilter } from './queries';
export { StepList } from './StepList';
export { ResultGraphs } from './ResultGraphs';
export { ResultProvenance } from './ResultProvenance';
export { ResultView } from './ResultView';
