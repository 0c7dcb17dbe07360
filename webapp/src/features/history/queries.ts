import { keepPreviousData, useQuery } from '@tanstack/react-query';
import { dataOf, useApi, type CaseHistory } from '@/shared/api';

const HISTORY = 'history';

/** Page size of the history of a case. */
export const POINTS_PER_PAGE = 50;

export type Points = CaseHistory['by'];

/** A case by its number in a build. */
export interface CaseOfBuild {
  activityId: string;
  model: string;
  no: number;
  /** The build that has the number; absent for the one with the newest result. */
  build?: string | undefined;
  /** Absent for commits if the activity comes from Git, else builds. */
  by?: Points | undefined;
}

/** A page of what a case did in all commits or builds, the newest first; pages count from 0. */
export function useCaseHistory({ activityId, model, no, build, by }: CaseOfBuild, page: number) {
  const api = useApi();
  return useQuery({
    queryKey: [HISTORY, activityId, 'case', model, no, build, by, page],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/activities/{id}/case-history', {
          params: {
            path: { id: activityId },
            query: {
              model,
              no,
              ...(build !== undefined && { build }),
              ...(by && { by }),
              page,
              size: POINTS_PER_PAGE,
            },
          },
          signal,
        }),
      ),
    placeholderData: keepPreviousData,
  });
}

/** Results of an activity or of one of its models, newest first. */
export function useHistory(activityId: string, model?: string) {
  const api = useApi();
  return useQuery({
    queryKey: [HISTORY, activityId, model],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/activities/{id}/results', {
          params: { path: { id: activityId }, query: { size: 100, ...(model && { model }) } },
          signal,
        }),
      ),
  });
}

export function useComparison(buildId: string, other: string) {
  const api = useApi();
  return useQuery({
    queryKey: [HISTORY, 'comparison', buildId, other],
    queryFn: ({ signal }) =>
      dataOf(
        api.GET('/api/v1/builds/{id}/result/comparison', {
          params: { path: { id: buildId }, query: { with: other } },
          signal,
        }),
      ),
    staleTime: Infinity,
  });
}
