import { isSeq, parseDocument } from 'yaml';

/** The profile with one more test model; comments and the order of entries stay. */
export function withModel(profile: string, path: string): string {
  const document = parseDocument(profile);
  const models = document.get('models');
  if (isSeq(models)) {
    models.add(path);
  } else {
    document.set('models', [path]);
  }
  return document.toString();
}
