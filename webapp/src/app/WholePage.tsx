import { useQueryClient, type Query } from '@tanstack/react-query';
import { useEffect, useState, type ReactNode } from 'react';
import { ArrivedContext } from '@/shared/lib/arrival';
import classes from './Shell.module.css';

/** Milliseconds between two looks at the requests. */
const INTERVAL = 16;
/** Looks without a request after which the first data are there; an answer can lead to a further request. */
const QUIET_LOOKS = 3;
/** A slower answer is not waited for: its place shows that it is loading. */
const PATIENCE = 700;

const isFirst = (query: Query) => query.state.data === undefined;

/** Shows the first page when its data are there, so that nothing moves while it is being read. */
export function WholePage({ children }: { children: ReactNode }) {
  const queries = useQueryClient();
  const [shown, setShown] = useState(false);
  useEffect(() => {
    const began = performance.now();
    let quiet = 0;
    const looks = setInterval(() => {
      quiet = queries.isFetching({ predicate: isFirst }) > 0 ? 0 : quiet + 1;
      if (quiet < QUIET_LOOKS && performance.now() - began < PATIENCE) return;
      clearInterval(looks);
      setShown(true);
    }, INTERVAL);
    return () => {
      clearInterval(looks);
    };
  }, [queries]);
  return (
    <ArrivedContext value={shown}>
      <div className={shown ? undefined : classes.arriving}>{children}</div>
    </ArrivedContext>
  );
}
