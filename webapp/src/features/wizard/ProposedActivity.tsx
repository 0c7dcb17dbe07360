import { Stack, Text } from '@mantine/core';
import type { ActivityProposal } from '@/shared/api';
import { plural } from '@/shared/lib/format';
import { Section, UserText } from '@/shared/ui';
import classes from './wizard.module.css';

/** A proposal: what is written, what is taken over, and what a person has to decide. */
export function ProposedActivity({ proposal }: { proposal: ActivityProposal }) {
  const written = proposal.files.filter(({ given }) => !given).map(({ path }) => path);
  const given = proposal.files.filter((file) => file.given).map(({ path }) => path);
  const hasSkeleton = written.some((path) => path.startsWith('component/'));
  return (
    <Section title="Proposed activity">
      <Stack gap="md">
        <Files title={plural(written.length, 'proposed file')} paths={written} />
        {given.length > 0 && (
          <Files title={`${plural(given.length, 'file')} taken over`} paths={given} />
        )}
        <div>
          <Text fw={600}>To decide</Text>
          <ul className={classes.list} aria-label="To decide" tabIndex={0}>
            {hasSkeleton && <li>The component: the files of component/ are a skeleton.</li>}
            <li>
              The test models: their ranges are guesses, and cases pass without a judgement until
              the models say what is expected.
            </li>
            {proposal.notes.map((note) => (
              <li key={note}>
                <UserText>{note}</UserText>
              </li>
            ))}
          </ul>
        </div>
      </Stack>
    </Section>
  );
}

function Files({ title, paths }: { title: string; paths: readonly string[] }) {
  return (
    <div>
      <Text fw={600}>{title}</Text>
      <ul className={classes.list} aria-label={title} tabIndex={0}>
        {paths.map((path) => (
          <li key={path}>
            <UserText>{path}</UserText>
          </li>
        ))}
      </ul>
    </div>
  );
}
