export { Conditions } from './Conditions';
export { ExpectedOutput } from './ExpectedOutput';
export { FunctionReference } from './FunctionReference';
export { Relations } from './Relations';
export { TrajectoryConditions } from './TrajectoryConditions';
