export * from './draft';
export { readModel, writeModel } from './model';
