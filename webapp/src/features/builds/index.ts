export { BuildList } from './BuildList';
export { BuildLog } from './BuildLog';
export { BuildOverview } from './BuildOverview';
export { FailingActivities } from './FailingActivities';
export { isFinished } from './state';
export { useBuild, useRequestBuild } from './queries';
