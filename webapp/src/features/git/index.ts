export { GitTab } from './GitTab';
export { NewFromGit } from './NewFromGit';
