import { useMutation } from '@tanstack/react-query';
import { useNavigate } from '@tanstack/react-router';
import { DEFAULT_OPTIONS, requestOf, useRequestBuild, type BuildOptions } from '@/features/builds';
import { useGenerateSuite, type SuiteOf } from '@/features/suites';

/** Generates a suite from a test model, requests a build of it, and opens that build. */
export function useStartBuild() {
  const suite = useGenerateSuite();
  const build = useRequestBuild();
  const navigate = useNavigate();
  return useMutation({
    mutationFn: async ({ buildOptions, ...of }: SuiteOf & { buildOptions?: BuildOptions }) =>
      build.mutateAsync({
        suiteId: (await suite.mutateAsync(of)).id,
        ...requestOf(buildOptions ?? DEFAULT_OPTIONS),
      }),
    onSuccess: ({ id }) => navigate({ to: '/builds/$buildId', params: { buildId: id } }),
  });
}

export type StartBuild = ReturnType<typeof useStartBuild>;
