import { useMutation } from '@tanstack/react-query';
import { dataOf, useApi, type SuiteOptions } from '@/shared/api';

/** The test model a suite is generated from; options left out are the model's own. */
export interface SuiteOf {
  activityId: string;
  model: string;
  options?: SuiteOptions;
}

/** Generates and keeps a suite of test cases. */
export function useGenerateSuite() {
  const api = useApi();
  return useMutation({
    mutationFn: ({ activityId, model, options = {} }: SuiteOf) =>
      dataOf(
        api.POST('/api/v1/activities/{id}/models/{name}/suites', {
          params: { path: { id: activityId, name: model } },
          body: options,
        }),
      ),
  });
}
