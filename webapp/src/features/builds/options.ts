import type { BuildRequest } from '@/shared/api';
import type { RecordingsOption } from '@/shared/lib/recordings';

/** The options of a build, as typed in the form. */
export interface BuildOptions {
  priority: string;
  shards: string;
  retries: string;
  toolchain: string;
  labels: string[];
  recordings: RecordingsOption;
  explain: boolean;
  /** Whether ROS 2 nodes run with the agent's ROS 2. */
  installedRos: boolean;
}

export const DEFAULT_OPTIONS: BuildOptions = {
  priority: '0',
  shards: '1',
  retries: '',
  toolchain: '',
  labels: [],
  recordings: '',
  explain: false,
  installedRos: false,
};

/** The options of a build as the server takes them. */
export type RequestedOptions = Omit<BuildRequest, 'suiteId'>;

/** The form's fields for options that were requested before. */
export function optionsFrom(requested: RequestedOptions): BuildOptions {
  const {
    priority = 0,
    shards = 1,
    retries,
    toolchain = '',
    labels = [],
    recordings,
    explain = false,
    ros,
  } = requested;
  return {
    priority: String(priority),
    shards: String(shards),
    retries: retries === undefined ? '' : String(retries),
    toolchain,
    labels,
    recordings: recordings ?? '',
    explain,
    installedRos: ros === 'SYSTEM',
  };
}

/** The options to send; defaults are left out. */
export function requestOf(options: BuildOptions): RequestedOptions {
  const { priority, shards, retries, toolchain, labels, recordings, explain, installedRos } =
    options;
  return {
    ...(Number(priority) !== 0 && { priority: Number(priority) }),
    ...(Number(shards) > 1 && { shards: Number(shards) }),
    ...(retries.trim() !== '' && { retries: Number(retries) }),
    ...(toolchain.trim() !== '' && { toolchain: toolchain.trim() }),
    ...(labels.length > 0 && { labels }),
    ...(recordings !== '' && { recordings }),
    ...(explain && { explain }),
    ...(installedRos && { ros: 'SYSTEM' }),
  };
}

const RECORDED: Record<Exclude<RecordingsOption, ''>, string> = {
  ALL: 'all cases recorded',
  FAILED: 'failing cases recorded',
  NONE: 'nothing recorded',
};

/** A short text for a button; empty if all options have their default. */
export function describeOptions(options: BuildOptions): string {
  const { priority, shards, retries, toolchain, labels, recordings, explain, installedRos } =
    options;
  return [
    Number(priority) !== 0 && `priority ${priority}`,
    Number(shards) > 1 && `${shards} shards`,
    retries.trim() !== '' && `${retries} retries`,
    toolchain.trim() !== '' && `toolchain ${toolchain.trim()}`,
    labels.length > 0 && `labels ${labels.join(', ')}`,
    recordings !== '' && RECORDED[recordings],
    explain && 'failures explained',
    installedRos && 'installed ROS 2',
  ]
    .filter(Boolean)
    .join(', ');
}
