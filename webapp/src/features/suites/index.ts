export { useGenerateSuite, type SuiteOf } from './queries';
