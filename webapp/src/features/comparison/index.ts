export { ValueDifferences, type ShownCase } from './ValueDifferences';
