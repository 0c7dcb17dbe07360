import { Button, Group, Text, TextInput } from '@mantine/core';
import { Formula, Section, type Words } from '@/shared/ui';
import type { NamedText } from '../document';

/** A list of expressions, with names if they have some. */
export function Conditions({
  title,
  help,
  words,
  named = false,
  texts,
  onChange,
}: {
  title: string;
  help: string;
  words: Words;
  named?: boolean;
  texts: readonly NamedText[];
  onChange: (texts: NamedText[]) => void;
}) {
  return (
    <Section
      title={title}
      actions={
        <Button
          size="xs"
          variant="default"
          onClick={() => {
            onChange([...texts, { name: '', text: '' }]);
          }}
        >
          Add
        </Button>
      }
    >
      {texts.length === 0 && <Text c="dimmed">None. {help}</Text>}
      {texts.map(({ name, text }, index) => (
        <Group key={index} align="end" wrap="nowrap">
          {named && (
            <TextInput
              label="Name"
              aria-label={`Name of ${title} ${index + 1}`}
              w={170}
              value={name}
              onChange={(event) => {
                onChange(texts.with(index, { name: event.currentTarget.value, text }));
              }}
            />
          )}
          <div style={{ flex: 1 }}>
            <Formula
              label={`${title} ${index + 1}`}
              text={text}
              words={words}
              onChange={(changed) => {
                onChange(texts.with(index, { name, text: changed }));
              }}
            />
          </div>
          <Button
            variant="subtle"
            size="xs"
            onClick={() => {
              onChange(texts.toSpliced(index, 1));
            }}
          >
            Remove
          </Button>
        </Group>
      ))}
    </Section>
  );
}
