import { Group, Progress, Stack, Table, Text } from '@mantine/core';
import type { CoverageFile } from '@/shared/api';
import { CodeEditor, Loading, ProblemAlert, ScrollTable, Section, UserText } from '@/shared/ui';
import type { LineMark } from '@/shared/ui';
import { useCoverage, useCoverageSource } from './queries';
import classes from './results.module.css';

interface CoverageViewProps {
  buildId: string;
  path?: string | undefined;
  onPath: (path: string) => void;
}

/** The coverage of the component's sources, by file and line. */
export function CoverageView({ buildId, path, onPath }: CoverageViewProps) {
  const coverage = useCoverage(buildId);
  if (coverage.isPending) return <Loading what="the coverage" />;
  if (!coverage.data) {
    return <ProblemAlert title="The coverage could not be read" error={coverage.error} />;
  }
  const { measured, statement, branch, files } = coverage.data;
  if (!measured) {
    return (
      <Text c="dimmed">
        This build has no coverage: the component has no sources, or coverage is disabled on the
        agent.
      </Text>
    );
  }
  const shown = files.find((file) => file.path === path) ?? files[0];
  return (
    <Stack gap="lg">
      <dl className={classes.summary} aria-label="Coverage of the component">
        <div>
          <dt>Statements</dt>
          <dd>{percent(statement)}</dd>
        </div>
        <div>
          <dt>Branches</dt>
          <dd>{percent(branch)}</dd>
        </div>
      </dl>
      <ScrollTable label="Files of the component" minWidth={560}>
        <Table.Thead>
          <Table.Tr>
            <Table.Th>File</Table.Th>
            <Table.Th>Covered lines</Table.Th>
            <Table.Th ta="right">Covered branches</Table.Th>
          </Table.Tr>
        </Table.Thead>
        <Table.Tbody>
          {files.map((file) => (
            <Table.Tr key={file.path}>
              <Table.Td>
                <button
                  type="button"
                  className={[classes.open, classes.path].join(' ')}
                  aria-current={file === shown}
                  onClick={() => {
                    onPath(file.path);
                  }}
                >
                  <UserText>{file.path}</UserText>
                </button>
              </Table.Td>
              <Table.Td>
                <Lines file={file} />
              </Table.Td>
              <Table.Td ta="right">
                {file.branches > 0 ? `${file.taken} of ${file.branches}` : '–'}
              </Table.Td>
            </Table.Tr>
          ))}
        </Table.Tbody>
      </ScrollTable>
      {shown && <Source key={shown.path} buildId={buildId} path={shown.path} />}
    </Stack>
  );
}

function Lines({ file: { reached, lines } }: { file: CoverageFile }) {
  return (
    <Group gap="sm" wrap="nowrap">
      <Text size="sm" w={90}>
        {reached} of {lines}
      </Text>
      <Progress
        flex={1}
        miw={80}
        value={lines > 0 ? (100 * reached) / lines : 0}
        aria-label="Covered lines"
      />
    </Group>
  );
}

function Source({ buildId, path }: { buildId: string; path: string }) {
  const source = useCoverageSource(buildId, path);
  if (source.isPending) return <Loading what="the source" />;
  if (!source.data) {
    return <ProblemAlert title="The source could not be read" error={source.error} />;
  }
  const { lines, source: text } = source.data;
  const missed = lines.filter(({ reached }) => !reached).map(({ number }) => number);
  const partly = lines.filter(({ reached, branches, taken }) => reached && taken < branches);
  const marks: LineMark[] = lines.map(({ number, reached, branches, taken }) => ({
    line: number,
    kind: !reached ? 'missed' : taken < branches ? 'partly' : 'reached',
    sign: !reached ? '✕' : branches > 0 ? `${taken}/${branches}` : '✓',
    title: !reached
      ? 'not covered'
      : branches > 0
        ? `covered; ${taken} of ${branches} branches`
        : 'covered',
  }));
  return (
    <Section title={path}>
      <Text size="sm">
        {missed.length === 0
          ? 'All lines with statements are covered.'
          : `Not covered: ${missed.length === 1 ? 'line' : 'lines'} ${ranges(missed)}.`}
        {partly.length > 0 &&
          ` Partly covered branches: ${partly.length === 1 ? 'line' : 'lines'} ${partly.map(({ number }) => number).join(', ')}.`}
      </Text>
      {text == null ? (
        <Text c="dimmed">The text of this file is not available.</Text>
      ) : (
        <CodeEditor label={`Text of ${path}`} path={path} text={text} marks={marks} />
      )}
    </Section>
  );
}

function percent(value: number | null | undefined): string {
  return value == null ? '–' : `${value.toFixed(1)} %`;
}

/** Consecutive lines as a range: `3, 7–9`. */
export function ranges(lines: readonly number[]): string {
  const found: [number, number][] = [];
  for (const line of lines) {
    const last = found.at(-1);
    if (last?.[1] === line - 1) last[1] = line;
    else found.push([line, line]);
  }
  return found.map(([from, to]) => (from === to ? `${from}` : `${from}–${to}`)).join(', ');
}
