export { Examples } from './Examples';
export { FavouriteButton } from './FavouriteButton';
export { FavouriteList } from './FavouriteList';
export { ActivityFiles } from './ActivityFiles';
export { InterfaceTree } from './InterfaceTree';
export { ActivityList } from './ActivityList';
export { ActivityTags, TagFilter } from './Tags';
export { UploadActivity } from './UploadActivity';
export {
  useActivity,
  useActivityChoice,
  useChangeFiles,
  useDescription,
  useFileText,
} from './queries';
