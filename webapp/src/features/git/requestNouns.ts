/** What a forge calls a request to merge commits into a branch. */
export function nounOf(forge: string): string {
  return forge === 'GITLAB' ? 'Merge request' : 'Pull request';
}
