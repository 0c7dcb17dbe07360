export { BuildForm } from './BuildForm';
export { BuildAgain, RunCaseAgain } from './BuildAgain';
export { BuildNow } from './BuildNow';
export { BuildOptionsButton } from './BuildOptionsButton';
export { useStartBuild } from './useStartBuild';
