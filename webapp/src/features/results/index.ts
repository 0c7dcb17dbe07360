export { ResultView } from './ResultView';
export { VERDICTS } from './verdicts';
