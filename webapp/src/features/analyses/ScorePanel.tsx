import { Alert, List, Stack, Table, Text } from '@mantine/core';
import type { Build, MutationScore, Score } from '@/shared/api';
import { ProblemAlert, ScrollTable, Section, UserText } from '@/shared/ui';
import { AnalysisButton, AnalysisProgress } from './AnalysisProgress';
import { isEnded, useAnalysis } from './queries';

/** How many faults the specification of a build notices, and the button that counts them. */
export function ScorePanel({ build }: { build: Build }) {
  const analysis = useAnalysis(build.id, 'score');
  const latest = analysis.data ?? undefined;
  return (
    <Section
      title="Score of the specification"
      actions={
        analysis.isSuccess &&
        (!latest || isEnded(latest)) && (
          <AnalysisButton
            buildId={build.id}
            kind="score"
            label={latest ? 'Score again' : 'Score'}
          />
        )
      }
    >
      {analysis.isError && (
        <ProblemAlert title="The score could not be read" error={analysis.error} />
      )}
      {analysis.isSuccess && !latest && (
        <Text size="sm" c="dimmed">
          Score puts faults between test driver and component, mutates the sources, and counts what
          the cases notice.
        </Text>
      )}
      {latest && <AnalysisProgress buildId={build.id} kind="score" analysis={latest} />}
      {latest?.score && <Noticed score={latest.score} />}
    </Section>
  );
}

const PERCENT = 100;

function Noticed({ score }: { score: Score }) {
  const { injected, noticed, equivalent, survivors, outputs, warnings, mutations } = score;
  const effective = injected - equivalent;
  const share = effective === 0 ? 1 : noticed / effective;
  return (
    <Stack gap="md">
      <Text>
        <strong>{(PERCENT * share).toFixed(1)} %</strong>
        {`: ${noticed} of ${effective} faults with an effect are noticed; ${equivalent} change no recorded value.`}
      </Text>
      {warnings.length > 0 && (
        <Alert color="yellow" variant="outline" title="Weaknesses of the specification">
          <List size="sm">
            {warnings.map((warning) => (
              <List.Item key={warning}>
                <UserText>{warning}</UserText>
              </List.Item>
            ))}
          </List>
        </Alert>
      )}
      {outputs.length > 0 && (
        <ScrollTable label="Noticed faults by output" minWidth={320}>
          <Table.Thead>
            <Table.Tr>
              <Table.Th>Output</Table.Th>
              <Table.Th>Faults that change it</Table.Th>
              <Table.Th>Noticed</Table.Th>
            </Table.Tr>
          </Table.Thead>
          <Table.Tbody>
            {outputs.map((output) => (
              <Table.Tr key={output.output}>
                <Table.Th scope="row">
                  <UserText>{output.output}</UserText>
                </Table.Th>
                <Table.Td>{output.changed}</Table.Td>
                <Table.Td>{output.noticed}</Table.Td>
              </Table.Tr>
            ))}
          </Table.Tbody>
        </ScrollTable>
      )}
      <Survivors label="Faults that are not noticed" head="Fault" survivors={survivors} />
      {mutations && <Mutations mutations={mutations} />}
    </Stack>
  );
}

function Mutations({ mutations }: { mutations: MutationScore }) {
  const { made, noticed, survivors, unchanged } = mutations;
  const effective = made - unchanged.length;
  const share = effective === 0 ? 1 : noticed / effective;
  return (
    <>
      <Text>
        <strong>{(PERCENT * share).toFixed(1)} %</strong>
        {` of the mutations of the sources: ${noticed} of ${effective} with an effect are noticed; ${unchanged.length} change no recorded value.`}
      </Text>
      <Survivors
        label="Mutations that are not noticed"
        head="Mutation of the sources"
        survivors={survivors}
      />
      {unchanged.length > 0 && (
        <details>
          <summary>Mutations without an effect in these cases</summary>
          <List size="sm">
            {unchanged.map((mutation) => (
              <List.Item key={mutation}>
                <UserText>{mutation}</UserText>
              </List.Item>
            ))}
          </List>
        </details>
      )}
    </>
  );
}

interface SurvivorsProps {
  label: string;
  head: string;
  survivors: Score['survivors'];
}

function Survivors({ label, head, survivors }: SurvivorsProps) {
  if (survivors.length === 0) return null;
  return (
    <ScrollTable label={label} minWidth={480}>
      <Table.Thead>
        <Table.Tr>
          <Table.Th>{head} that is not noticed</Table.Th>
          <Table.Th>What to add to the specification</Table.Th>
        </Table.Tr>
      </Table.Thead>
      <Table.Tbody>
        {survivors.map(({ fault, where, suggestion }) => (
          <Table.Tr key={`${where} ${fault}`}>
            <Table.Td>
              <UserText>{fault}</UserText>
            </Table.Td>
            <Table.Td>
              <UserText>{suggestion}</UserText>
            </Table.Td>
          </Table.Tr>
        ))}
      </Table.Tbody>
    </ScrollTable>
  );
}
