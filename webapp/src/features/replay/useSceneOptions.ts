import { useLocalStorage } from '@mantine/hooks';
import type { SceneOptions } from './stage';

export interface ShownOptions extends SceneOptions {
  /** Whether the cost of a frame is shown. */
  cost: boolean;
}

const DEFAULTS: ShownOptions = {
  shadows: true,
  trail: true,
  beams: true,
  frames: false,
  tint: false,
  cost: false,
};

/** What the user switches on in scenes, kept in the browser. */
export function useSceneOptions() {
  return useLocalStorage<ShownOptions>({
    key: 'sitaf-scene',
    defaultValue: DEFAULTS,
    deserialize: readOptions,
  });
}

/** Unknown and damaged entries of the browser's store are ignored. */
function readOptions(text: string | undefined): ShownOptions {
  try {
    const stored = JSON.parse(text ?? '{}') as Partial<Record<string, unknown>>;
    const options = { ...DEFAULTS };
    for (const key of Object.keys(DEFAULTS) as (keyof ShownOptions)[]) {
      const value = stored[key];
      if (typeof value === 'boolean') options[key] = value;
    }
    return options;
  } catch {
    return DEFAULTS;
  }
}
