import { Children, type ReactNode } from 'react';
import classes from './text.module.css';

/** The links from the list of everything to the page above this one. */
export function Breadcrumb({ children }: { children: ReactNode }) {
  return (
    <nav aria-label="Breadcrumb">
      <ol className={classes.breadcrumb}>
        {Children.toArray(children).map((link, index) => (
          <li key={index}>{link}</li>
        ))}
      </ol>
    </nav>
  );
}
