export { CoverageView } from './CoverageView';
export { LiveCases } from './LiveCases';
export { CaseFacts } from './CaseFacts';
export { useResult, useResultCase, type CaseFilter } from './queries';
export { ResultComparison } from './ResultComparison';
export { ResultGraphs } from './ResultGraphs';
export { ResultHistory } from './ResultHistory';
export { ResultView } from './ResultView';
