export { callTime } from './lanes';
export { useSignals } from './queries';
export { SignalPlot } from './SignalPlot';
