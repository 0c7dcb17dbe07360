export { BuildList } from './BuildList';
export { BuildLog } from './BuildLog';
export { BuildOverview } from './BuildOverview';
export { CaseLog } from './CaseLog';
export { BuildOptionsFields } from './BuildOptionsFields';
export { FailingActivities } from './FailingActivities';
export {
  DEFAULT_OPTIONS,
  describeOptions,
  optionsFrom,
  requestOf,
  type BuildOptions,
  type RequestedOptions,
} from './options';
export { isFinished, statusOf } from './state';
export { useBuild, useRequestBuild } from './queries';
