/** Files by path, relative to their folder in the activity. */
export type Files = ReadonlyMap<string, Uint8Array>;

export const LANGUAGES = [
  { value: 'java', label: 'Java' },
  { value: 'cpp', label: 'C++' },
  { value: 'python', label: 'Python' },
] as const;
export type Language = (typeof LANGUAGES)[number]['value'];

export function languageOf(value: string): Language {
  return LANGUAGES.find((known) => known.value === value)?.value ?? 'java';
}

/** The fields of the wizard (Fig. 13). */
export interface WizardDraft {
  name: string;
  description: string;
  language: Language;
  className: string;
  lifeCycle: 'case' | 'suite';
  /** One `NAME: VALUE` per line, set before the first call. */
  properties: string;
  /** One call per line, such as `Enable()`, before the method under test. */
  before: string;
  /** The component profile, optional. */
  profile: Files;
  sources: Files;
  /** A compiled library instead of sources. */
  library: Files;
  provided: Files;
  required: Files;
  libraries: Files;
  harness: Language;
  world: Files;
}

export const NONE: Files = new Map();

export const EMPTY: WizardDraft = {
  name: '',
  description: '',
  language: 'java',
  className: '',
  lifeCycle: 'case',
  properties: '',
  before: '',
  profile: NONE,
  sources: NONE,
  library: NONE,
  provided: NONE,
  required: NONE,
  libraries: NONE,
  harness: 'java',
  world: NONE,
};

/** The first public class of the sources, as a suggestion. */
export function suggestedClass({ language, sources }: WizardDraft): string {
  for (const [path, content] of sources) {
    const text = new TextDecoder().decode(content);
    const base = path.slice(path.lastIndexOf('/') + 1);
    if (language === 'java' && base.endsWith('.java')) {
      const found = /\bpublic\s+(?:final\s+)?class\s+(\w+)/.exec(text)?.[1];
      const within = /^\s*package\s+([\w.]+)\s*;/m.exec(text)?.[1];
      if (found) return within ? `${within}.${found}` : found;
    } else if (language === 'python' && base.endsWith('.py')) {
      const found = /^class\s+(\w+)/m.exec(text)?.[1];
      if (found) return `${path.replace(/\.py$/, '').replaceAll('/', '.')}.${found}`;
    } else if (language === 'cpp' && /\.(h|hpp|hxx)$/.test(base)) {
      const found = /\bclass\s+(\w+)\s*(?:final\s*)?[:{]/.exec(text)?.[1];
      if (found) return found;
    }
  }
  return '';
}

/** The paths of all files of the activity. */
export function pathsOf(draft: WizardDraft): string[] {
  return [...filesOf(draft).keys(), 'activity.yaml'].sort();
}

/** All files except activity.yaml. */
export function filesOf(draft: WizardDraft): Map<string, Uint8Array> {
  const files = new Map<string, Uint8Array>();
  const add = (folder: string, some: Files) => {
    for (const [path, content] of some) files.set(`${folder}${path}`, content);
  };
  add('component/', draft.sources);
  add('library/', draft.library);
  add('lib/', draft.libraries);
  add('world/', draft.world);
  for (const some of [draft.profile, draft.provided, draft.required]) add('', some);
  return files;
}
