import type { components } from './schema';

/** The resources of the REST interface. */
type Schemas = components['schemas'];

export type Activity = Schemas['Activity'];
export type ActivityModel = Schemas['ActivityModel'];
export type Agent = Schemas['Agent'];
export type Build = Schemas['Build'];
export type BuildState = Build['state'];
export type ActivityDescription = Schemas['ActivityDescription'];
export type BuildRequest = Schemas['BuildRequest'];
export type Calendar = Schemas['Calendar'];
export type CaseSignals = Schemas['CaseSignals'];
export type CaseChange = Schemas['CaseChange'];
export type Combinations = Schemas['Combinations'];
export type ComparedCase = Schemas['ComparedCase'];
export type CoverageFile = Schemas['CoverageFile'];
export type Diagnostic = Schemas['Diagnostic'];
export type Problem = Schemas['Problem'];
export type Result = Schemas['Result'];
export type ResultCase = Schemas['ResultCase'];
export type ResultParameter = Schemas['ResultParameter'];
export type RecordedCases = Build['recordedCases'];
export type ResultSummary = Schemas['ResultSummary'];
export type HarnessFile = Schemas['HarnessFile'];
export type ModelPreview = Schemas['ModelPreview'];
export type ResultComparison = Schemas['ResultComparison'];
export type ResultOfBuild = Schemas['ResultOfBuild'];
export type ResultStatistics = Schemas['ResultStatistics'];
export type Schedule = Schemas['Schedule'];
export type ScheduleRequest = Schemas['ScheduleRequest'];
export type SourceProblem = Schemas['SourceProblem'];
export type Suite = Schemas['Suite'];
export type SuiteCase = Schemas['SuiteCase'];
export type SuiteChanges = Schemas['SuiteChanges'];
export type SuiteOptions = Schemas['SuiteOptions'];
export type Verdict = ResultCase['verdict'];
export type Verdicts = Schemas['Verdicts'];
