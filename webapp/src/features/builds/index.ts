export { BuildList } from './BuildList';
export { BuildOverview } from './BuildOverview';
export { useBuild, useRequestBuild } from './queries';
