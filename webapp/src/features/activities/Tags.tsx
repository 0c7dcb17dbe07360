import { Button, Group, NativeSelect, TagsInput } from '@mantine/core';
import { useState } from 'react';
import type { Activity } from '@/shared/api';
import { ProblemAlert, RouteLink, UserText } from '@/shared/ui';
import { useReplaceTags, useTags } from './queries';

/** The tags of an activity, each a link to the activities with it. */
export function TagLinks({ tags }: { tags: readonly string[] }) {
  return (
    <Group gap={6} role="list" aria-label="Tags">
      {tags.map((tag) => (
        <span key={tag} role="listitem">
          <RouteLink to="/activities" search={{ tag }} size="sm">
            #<UserText>{tag}</UserText>
          </RouteLink>
        </span>
      ))}
    </Group>
  );
}

/** Chooses the tag by which a list is filtered; nothing while no activity has one. */
export function TagFilter({
  tag,
  onTag,
}: {
  tag: string | undefined;
  onTag: (tag: string | undefined) => void;
}) {
  const tags = useTags();
  const known = tags.data ?? [];
  if (known.length === 0 && !tag) return null;
  return (
    <NativeSelect
      aria-label="Tag"
      size="sm"
      value={tag ?? ''}
      data={[
        { value: '', label: 'All tags' },
        ...known.map(({ name, activities }) => ({ value: name, label: `${name} (${activities})` })),
        // A tag of a link that no activity has any more.
        ...(tag && known.every(({ name }) => name !== tag) ? [{ value: tag, label: tag }] : []),
      ]}
      onChange={(event) => {
        onTag(event.currentTarget.value || undefined);
      }}
    />
  );
}

/** The tags of an activity, which may be changed. */
export function ActivityTags({
  activity,
  mayChange,
}: {
  activity: Pick<Activity, 'id' | 'tags'>;
  mayChange: boolean;
}) {
  const [edited, setEdited] = useState<string[]>();
  if (edited) {
    return (
      <TagEditor
        id={activity.id}
        tags={edited}
        onTags={setEdited}
        onEnd={() => {
          setEdited(undefined);
        }}
      />
    );
  }
  return (
    <Group gap="sm">
      {activity.tags.length > 0 && <TagLinks tags={activity.tags} />}
      {mayChange && (
        <Button
          size="compact-xs"
          variant="transparent"
          px={0}
          onClick={() => {
            setEdited([...activity.tags]);
          }}
        >
          {activity.tags.length > 0 ? 'Edit tags' : 'Add tags'}
        </Button>
      )}
    </Group>
  );
}

function TagEditor({
  id,
  tags,
  onTags,
  onEnd,
}: {
  id: string;
  tags: string[];
  onTags: (tags: string[]) => void;
  onEnd: () => void;
}) {
  const known = useTags();
  const replace = useReplaceTags(id);
  return (
    <>
      <Group gap="xs" align="end">
        <TagsInput
          label="Tags"
          description="Letters, digits, . _ / and -; Enter adds a tag"
          w={360}
          maw="100%"
          maxTags={20}
          data-autofocus
          autoFocus
          acceptValueOnBlur
          data={known.data?.map(({ name }) => name) ?? []}
          value={tags}
          onChange={onTags}
          clearButtonProps={{ 'aria-label': 'Remove all tags' }}
        />
        <Button
          size="sm"
          loading={replace.isPending}
          onClick={() => {
            replace.mutate(tags, { onSuccess: onEnd });
          }}
        >
          Save tags
        </Button>
        <Button size="sm" variant="default" onClick={onEnd}>
          Cancel
        </Button>
      </Group>
      {replace.isError && (
        <ProblemAlert
          title="The tags were not saved"
          error={replace.error}
          onClose={replace.reset}
        />
      )}
    </>
  );
}
