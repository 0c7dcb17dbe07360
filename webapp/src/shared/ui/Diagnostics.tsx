import type { Diagnostic, SourceProblem } from '@/shared/api';
import { UserText } from './UserText';
import classes from './text.module.css';

/** A diagnostic of a document or of a compiler; line 0 if the line is unknown. */
type Item = Pick<Diagnostic, 'file' | 'line' | 'message'> &
  Partial<Pick<Diagnostic, 'severity' | 'element'> & Pick<SourceProblem, 'generated'>>;

/** A list of problems in the format of compilers: `file:line: message`. */
export function Diagnostics({ items }: { items: readonly Item[] }) {
  return (
    // Focusable, so that a long list can be scrolled by keyboard.
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
