export { CaseGrid } from './CaseGrid';
export { CombinationView } from './CombinationView';
export { useGenerateSuite, useHarness, useSuite, useSuites, type SuiteOf } from './queries';
export { SuiteChangesView } from './SuiteChangesView';
export { SuiteList } from './SuiteList';
