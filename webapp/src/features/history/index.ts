export { CaseHistory } from './CaseHistory';
export type { Points } from './queries';
export { ResultComparison } from './ResultComparison';
export { ResultHistory } from './ResultHistory';
