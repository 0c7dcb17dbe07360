export type { CaseFilter } from './queries';
export { ResultComparison } from './ResultComparison';
export { ResultGraphs } from './ResultGraphs';
export { ResultHistory } from './ResultHistory';
export { ResultView } from './ResultView';
