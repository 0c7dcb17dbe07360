import { Spherical, Vector3, type PerspectiveCamera } from 'three';
import type { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import type { CameraPreset } from './cameraPresets';
import type { Frame } from './play';

/** From where the camera looks at what it frames. The axes are those of glTF: y is up. */
export const DIRECTIONS: Record<CameraPreset, Vector3> = {
  default: new Vector3(-0.8, 0.42, 0.95).normalize(),
  front: new Vector3(1, 0.18, 0).normalize(),
  back: new Vector3(-1, 0.18, 0).normalize(),
  left: new Vector3(0, 0.18, -1).normalize(),
  right: new Vector3(0, 0.18, 1).normalize(),
  // Not exactly from above, where the camera has no upright direction.
  top: new Vector3(-0.001, 1, 0).normalize(),
};

/** All around in steps of an eighth, then the same from higher up. */
const DEFAULT_SIDES = [0.42, 1.1].flatMap((height) =>
  [0, 1, -1, 2, -2, 3, -3, 4].map((eighths) =>
    new Vector3(-0.8, height, 0.95)
      .applyAxisAngle(new Vector3(0, 1, 0), (eighths * Math.PI) / 4)
      .normalize(),
  ),
);

/** Distance of the camera, in radii of what it frames. */
const DISTANCE = 2.6;

/** Moves of the camera around its target. */
export function createMoves(camera: PerspectiveCamera, controls: OrbitControls) {
  return {
    /** Looks at a target from the same side and distance. */
    lookAt(target: Vector3) {
      camera.position.add(target).sub(controls.target);
      controls.target.copy(target);
      controls.update();
    },
    /** The default side, or the next one from which nothing hides the robot. */
    freeSide({ center, radius }: Frame, isHiddenFrom: (point: Vector3) => boolean): Vector3 {
      const free = DEFAULT_SIDES.find(
        (side) => !isHiddenFrom(center.clone().addScaledVector(side, radius * DISTANCE)),
      );
      return free ?? DIRECTIONS.default;
    },
    /** Frames something from a side. */
    frame({ center, radius }: Frame, direction: Vector3) {
      controls.target.copy(center);
      // A narrow view needs a larger distance.
      const distance = radius * DISTANCE * Math.max(1, 0.8 / camera.aspect);
      camera.position.copy(center).addScaledVector(direction, distance);
      camera.near = radius / 100;
      camera.far = radius * 1000;
      camera.updateProjectionMatrix();
      controls.minDistance = radius / 20;
      controls.maxDistance = radius * 60;
      controls.update();
    },
    rotate(azimuth: number, elevation: number) {
      const offset = new Spherical().setFromVector3(camera.position.clone().sub(controls.target));
      offset.theta += azimuth;
      offset.phi += elevation;
      offset.makeSafe();
      camera.position.setFromSpherical(offset).add(controls.target);
      controls.update();
    },
    zoom(factor: number) {
      camera.position.sub(controls.target).divideScalar(factor).add(controls.target);
      controls.update();
    },
  };
}
