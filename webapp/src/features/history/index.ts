export { ResultComparison } from './ResultComparison';
export { ResultHistory } from './ResultHistory';
