export { BuildForm } from './BuildForm';
export { BuildNow } from './BuildNow';
export { HowToBuild } from './HowToBuild';
export { useStartBuild } from './useStartBuild';
