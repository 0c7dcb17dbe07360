export { ActivityFiles } from './ActivityFiles';
export { ActivityList } from './ActivityList';
export { UploadActivity } from './UploadActivity';
export { useActivity } from './queries';
