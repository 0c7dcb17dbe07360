/** Sides from which the camera looks; without three.js, which is loaded on demand. */
export const CAMERA_LABELS = {
  default: 'Default',
  front: 'Front',
  back: 'Back',
  left: 'Left',
  right: 'Right',
  top: 'Top',
} as const;

export type CameraPreset = keyof typeof CAMERA_LABELS;
