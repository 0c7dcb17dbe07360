import { Button, Checkbox, Popover, Stack } from '@mantine/core';
import { CAMERA_LABELS, type CameraPreset } from './cameraPresets';
import classes from './replay.module.css';
import type { ShownOptions } from './useSceneOptions';

const SWITCHES: readonly [keyof ShownOptions, string][] = [
  ['trail', 'Trail'],
  ['beams', 'Sensor beams'],
  ['frames', 'Coordinate frames'],
  ['tint', 'Colour by verdict'],
  ['shadows', 'Shadows'],
  ['cost', 'Cost of a frame'],
];

interface SceneMenuProps {
  options: ShownOptions;
  onOptions: (options: ShownOptions) => void;
  onView: (preset: CameraPreset) => void;
}

/** Camera presets, and parts of the scene to switch on. */
export function SceneMenu({ options, onOptions, onView }: SceneMenuProps) {
  return (
    <Popover position="bottom-start" trapFocus withRoles>
      <Popover.Target>
        <Button size="compact-xs" variant="default" className={classes.menu ?? ''}>
          View
        </Button>
      </Popover.Target>
      <Popover.Dropdown aria-label="View" className={classes.dropdown ?? ''}>
        <Stack gap={6}>
          <div className={classes.presets} role="group" aria-label="Camera">
            {(Object.entries(CAMERA_LABELS) as [CameraPreset, string][]).map(([preset, label]) => (
              <Button
                key={preset}
                size="compact-xs"
                variant="default"
                onClick={() => {
                  onView(preset);
                }}
              >
                {label}
              </Button>
            ))}
          </div>
          {SWITCHES.map(([key, label]) => (
            <Checkbox
              key={key}
              size="xs"
              label={label}
              checked={options[key]}
              onChange={(event) => {
                onOptions({ ...options, [key]: event.currentTarget.checked });
              }}
            />
          ))}
        </Stack>
      </Popover.Dropdown>
    </Popover>
  );
}
