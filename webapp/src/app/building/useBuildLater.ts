import { useMutation } from '@tanstack/react-query';
import { useNavigate } from '@tanstack/react-router';
import { requestOf, type BuildOptions } from '@/features/builds';
import { useGenerateSuite, type SuiteOf } from '@/features/suites';

/**
 * Opens the form of a new schedule with the chosen options. A schedule generates its cases with the
 * options of the model; with other options the suite is generated now and the schedule builds that.
 */
export function useBuildLater() {
  const generate = useGenerateSuite();
  const navigate = useNavigate();
  return useMutation({
    mutationFn: async ({ buildOptions, ...of }: SuiteOf & { buildOptions: BuildOptions }) => {
      const { activityId, model, options = {} } = of;
      const subject =
        Object.keys(options).length === 0
          ? { activity: activityId, model }
          : { suite: (await generate.mutateAsync(of)).id };
      await navigate({
        to: '/schedules/new',
        search: { ...subject, ...requestOf(buildOptions) },
      });
    },
  });
}
