import { unzipSync, zipSync } from 'fflate';
import { parse, stringify } from 'yaml';
import { filesOf, type Files, type WizardDraft } from './draft';

/** The profile (activity.yaml) of a draft. */
export function profileOf(draft: WizardDraft): string {
  const [profile] = draft.profile.keys();
  const [library] = draft.library.keys();
  const world = [...draft.world.keys()].find((path) => path.endsWith('.world.yaml'));
  return stringify({
    name: draft.name,
    ...(draft.description && { description: draft.description }),
    component: {
      language: draft.language,
      ...(draft.sources.size > 0 && { sources: 'component/' }),
      ...(draft.sources.size === 0 && library && { library: `library/${library}` }),
      class: draft.className,
      ...(profile && { profile }),
      ...(draft.properties.trim() && { properties: parse(draft.properties) as unknown }),
      life_cycle: draft.lifeCycle,
      ...(draft.before.trim() && { before: linesOf(draft.before) }),
    },
    provided: [...draft.provided.keys()],
    required: [...draft.required.keys()],
    libraries: [...draft.libraries.keys()].map((path) => `lib/${path}`),
    harness: draft.harness,
    ...(world && { world: `world/${world}` }),
    models: [],
  });
}

function linesOf(text: string): string[] {
  return text
    .split('\n')
    .map((line) => line.trim())
    .filter((line) => line !== '');
}

/** The zip file of a draft. */
export function archiveOf(draft: WizardDraft): Uint8Array<ArrayBuffer> {
  return zipSync({
    'activity.yaml': new TextEncoder().encode(profileOf(draft)),
    ...Object.fromEntries(filesOf(draft)),
  });
}

/** The zip file of some files; nothing for none. */
export function zipOf(files: Files): Uint8Array<ArrayBuffer> {
  return files.size === 0 ? new Uint8Array() : zipSync(Object.fromEntries(files));
}

/**
 * Selected files: zip files are unpacked, folders keep their relative paths.
 *
 * @param whole whether to keep a top-level folder that contains all files
 */
export async function filesFrom(
  given: readonly { path: string; file: File }[],
  whole = false,
): Promise<Files> {
  const files = new Map<string, Uint8Array>();
  for (const { path, file } of given) {
    const content = new Uint8Array(await file.arrayBuffer());
    if (file.name.toLowerCase().endsWith('.zip')) {
      for (const [inside, bytes] of Object.entries(unzipSync(content))) {
        if (!inside.endsWith('/')) files.set(inside, bytes);
      }
    } else {
      files.set(path, content);
    }
  }
  return whole ? files : withoutCommonFolder(files);
}

/** Removes a top-level folder that contains all files. */
function withoutCommonFolder(files: Files): Files {
  const paths = [...files.keys()];
  const folder = /^[^/]+\//.exec(paths[0] ?? '')?.[0];
  // These folders are part of package names or include paths.
  const significant = ['com/', 'org/', 'net/', 'io/', 'src/', 'include/'];
  if (!folder || significant.includes(folder) || !paths.every((path) => path.startsWith(folder))) {
    return files;
  }
  return new Map([...files].map(([path, content]) => [path.slice(folder.length), content]));
}
