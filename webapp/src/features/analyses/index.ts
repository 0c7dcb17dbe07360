export { CausePanel } from './CausePanel';
export { ScorePanel } from './ScorePanel';
