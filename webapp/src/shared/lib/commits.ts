const ID = /^[0-9a-f]{40,64}/;
const SHORT = 10;

/** The beginning of a commit's id; `-dirty` stays. */
export function shortCommit(commit: string): string {
  return commit.replace(ID, (id) => id.slice(0, SHORT));
}
