import { NONE, type Files, type Language } from './draft';

/** What the server proposes an activity from. */
export interface ProposalRequest {
  files: Files;
  query: {
    name: string;
    language?: string;
    class?: string;
    interface?: string;
    node?: string;
  };
}

/** A new component, of which only the interface exists. */
export interface ComponentDraft {
  name: string;
  /** Where its interface comes from: files, the interfaces of ROS 2, or nowhere yet. */
  source: 'files' | 'ros' | 'small';
  files: Files;
  /** One of the files; the first one that fits if it is empty. */
  chosenFile: string;
  /** Such as `nav_msgs/srv/GetPlan.srv`. */
  installed: string;
  language: Language;
  /** Optional. */
  className: string;
}

/** A ROS 2 package that exists. */
export interface PackageDraft {
  name: string;
  files: Files;
  /** The folder of a package.xml; the first one that fits if it is empty. */
  chosenFolder: string;
  /** Empty for that of the package. */
  language: '' | 'python' | 'cpp';
  /** Empty for the only node. */
  node: string;
}

export const NEW_COMPONENT: ComponentDraft = {
  name: '',
  source: 'files',
  files: NONE,
  chosenFile: '',
  installed: '',
  language: 'python',
  className: '',
};

export const NEW_PACKAGE: PackageDraft = {
  name: '',
  files: NONE,
  chosenFolder: '',
  language: '',
  node: '',
};

/** The files that can provide an interface. Messages have no methods. */
export function interfacesIn(files: Files): string[] {
  return [...files.keys()].filter(
    (path) => /\.(xml|idl|srv|action|proto)$/.test(path) && !/(^|\/)package\.xml$/.test(path),
  );
}

/** The folders of package.xml; `.` is the top. */
export function packagesIn(files: Files): string[] {
  return [...files.keys()]
    .filter((path) => /(^|\/)package\.xml$/.test(path))
    .map((path) => path.replace(/\/?package\.xml$/, '') || '.');
}

/** The folders of packages with sources of nodes come first. */
export function nodesFirst(folders: readonly string[], files: Files): string[] {
  const hasSources = (folder: string) =>
    [...files.keys()].some(
      (path) =>
        (folder === '.' || path.startsWith(`${folder}/`)) && /\.(py|cpp|cc|cxx)$/.test(path),
    );
  return [...folders].sort((a, b) => Number(hasSources(b)) - Number(hasSources(a)));
}

/** Files without those that no activity needs, such as the folder of a repository. */
export function withoutHidden(files: Files): Files {
  return new Map(
    [...files].filter(
      ([path]) => !path.split('/').some((part) => part.startsWith('.') || part === '__pycache__'),
    ),
  );
}

/** The file of the interface; empty if there is none. */
export function fileOf({ files, chosenFile }: ComponentDraft): string {
  return files.has(chosenFile) ? chosenFile : (interfacesIn(files)[0] ?? '');
}

/** The folder of the package; empty if there is none. */
export function folderOf({ files, chosenFolder }: PackageDraft): string {
  const folders = packagesIn(files);
  return folders.includes(chosenFolder) ? chosenFolder : (nodesFirst(folders, files)[0] ?? '');
}

/** Undefined until the draft is complete. */
export function requestOfComponent(draft: ComponentDraft): ProposalRequest | undefined {
  const { name, source, files, installed, language, className } = draft;
  const path = { files: fileOf(draft), ros: installed.trim(), small: '' }[source];
  const isComplete = { files: files.size > 0, ros: path !== '', small: true }[source];
  if (name.trim() === '' || !isComplete) return undefined;
  return {
    files: source === 'files' ? files : NONE,
    query: {
      name: name.trim(),
      language,
      ...(path !== '' && { interface: path }),
      ...(className.trim() !== '' && { class: className.trim() }),
    },
  };
}

/** Undefined until the draft is complete. The server says what is wrong with the files. */
export function requestOfPackage(draft: PackageDraft): ProposalRequest | undefined {
  const { name, files, language, node } = draft;
  if (name.trim() === '' || files.size === 0) return undefined;
  return {
    files,
    query: {
      name: name.trim(),
      node: folderOf(draft) || '.',
      ...(language !== '' && { language }),
      ...(node !== '' && { class: node }),
    },
  };
}

/** The bytes of a zip file that JSON carries as text. */
export function bytesOf(base64: string): Uint8Array<ArrayBuffer> {
  return Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
}
