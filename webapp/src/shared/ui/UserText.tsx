import { visible } from '@/shared/lib/visible';
import classes from './text.module.css';

/** Untrusted text of a user, a component or a log. Its direction does not affect the text around it. */
export function UserText({ children }: { children: string }) {
  return <bdi className={classes.user}>{visible(children)}</bdi>;
}
