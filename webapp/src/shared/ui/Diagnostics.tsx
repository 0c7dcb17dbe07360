import type { Diagnostic, SourceProblem } from '@/shared/api';
import { UserText } from './UserText';
import classes from './text.module.css';

/** A diagnostic of a document, or a compiler's of a source file; line 0 is an unknown line. */
type Item = Pick<Diagnostic, 'file' | 'line' | 'message'> &
  Partial<Pick<Diagnostic, 'severity' | 'element'> & Pick<SourceProblem, 'generated'>>;

/** What is wrong with an input and where, one `file:line: message` a row, as compilers print it. */
export function Diagnostics({ items }: { items: readonly Item[] }) {
  return (
    // A long list scrolls; the keyboard must reach it.
    <ul className={classes.diagnostics} aria-label="Diagnostics" tabIndex={0}>
      {items.map((item, index) => (
        <li key={index}>
          <span className={classes.place}>
            <UserText>{item.line > 0 ? `${item.file}:${item.line}` : item.file}</UserText>
          </span>
          {': '}
          {item.severity === 'WARNING' && 'warning: '}
          {item.element && <UserText>{`${item.element}: `}</UserText>}
          <UserText>{item.message}</UserText>
          {item.generated && ' (in generated source)'}
        </li>
      ))}
    </ul>
  );
}
