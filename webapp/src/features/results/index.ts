export type { CaseFilter } from './queries';
export { CoverageView } from './CoverageView';
export { LiveCases } from './LiveCases';
export { ResultComparison } from './ResultComparison';
export { ResultGraphs } from './ResultGraphs';
export { ResultHistory } from './ResultHistory';
export { ResultView } from './ResultView';
