export { ParameterTable } from './ParameterTable';
export { SpecificationStep } from './SpecificationStep';
