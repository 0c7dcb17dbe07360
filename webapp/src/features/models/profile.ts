import { isSeq, parseDocument } from 'yaml';

/** Adds a test model to the profile of an activity. Comments and the order of entries are kept. */
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
