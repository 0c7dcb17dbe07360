export { CoverageView } from './CoverageView';
export { LiveCases } from './LiveCases';
export { CaseFacts } from './CaseFacts';
export { RelationRuns } from './RelationRuns';
export { useCase, useResult, type CaseFilter } from './queries';
export { ResultGraphs } from './ResultGraphs';
export { ResultView } from './ResultView';
