import type { Diagnostic } from '@/shared/api';
import { UserText } from './UserText';
import classes from './text.module.css';

/** What is wrong with an input and where, one `file:line: message` a row, as compilers print it. */
export function Diagnostics({ items }: { items: readonly Diagnostic[] }) {
  return (
    // A long list scrolls; the keyboard must reach it.
    <ul className={classes.diagnostics} aria-label="Diagnostics" tabIndex={0}>
      {items.map((item, index) => (
        <li key={index}>
          <Place diagnostic={item} />
          {item.severity === 'ERROR' ? '' : `${item.severity.toLowerCase()}: `}
          <UserText>{item.message}</UserText>
        </li>
      ))}
    </ul>
  );
}

function Place({ diagnostic: { file, line, element } }: { diagnostic: Diagnostic }) {
  const place = file ? (line == null ? file : `${file}:${line}`) : element;
  if (!place) return null;
  return (
    <>
      <span className={classes.place}>
        <UserText>{place}</UserText>
      </span>
      {': '}
      {file && element ? (
        <>
          <UserText>{element}</UserText>
          {': '}
        </>
      ) : null}
    </>
  );
}
