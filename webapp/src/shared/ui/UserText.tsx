import { visible } from '@/shared/lib/visible';
import classes from './text.module.css';

/** Text that came from a user, a component or a log: shown as text, apart from what stands around it. */
export function UserText({ children }: { children: string }) {
  return <bdi className={classes.user}>{visible(children)}</bdi>;
}
