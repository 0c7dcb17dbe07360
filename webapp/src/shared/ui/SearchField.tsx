import { CloseButton, TextInput } from '@mantine/core';
import { useEffect, useState } from 'react';

interface SearchFieldProps {
  label: string;
  value: string | undefined;
  /** Called when the user pauses; with undefined for an empty field. */
  onSearch: (text: string | undefined) => void;
}

const PAUSE_MS = 300;

/** Searches a list while the user types. */
export function SearchField({ label, value, onSearch }: SearchFieldProps) {
  const [text, setText] = useState(value ?? '');
  const [last, setLast] = useState(value);
  // The address has changed, for example by going back.
  if (last !== value) {
    setLast(value);
    setText(value ?? '');
  }
  const wanted = text.trim() === '' ? undefined : text.trim();
  useEffect(() => {
    if (wanted === value) return;
    const timer = setTimeout(() => {
      setLast(wanted);
      onSearch(wanted);
    }, PAUSE_MS);
    return () => {
      clearTimeout(timer);
    };
    // The callback is a new one in each render.
    // eslint-disable-next-line react-hooks/exhaustive-deps
  }, [wanted, value]);
  return (
    <TextInput
      type="search"
      size="sm"
      w={240}
      aria-label={label}
      placeholder={label}
      value={text}
      rightSection={
        text !== '' && (
          <CloseButton
            size="sm"
            aria-label="Clear the search"
            onClick={() => {
              setText('');
            }}
          />
        )
      }
      onChange={(event) => {
        setText(event.currentTarget.value);
      }}
    />
  );
}
