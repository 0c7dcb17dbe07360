export { CausePanel } from './CausePanel';
export { FlakyPanel } from './FlakyPanel';
export { ScorePanel } from './ScorePanel';
