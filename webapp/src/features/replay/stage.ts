import {
  Color,
  DirectionalLight,
  HemisphereLight,
  PerspectiveCamera,
  Scene,
  Spherical,
  Vector3,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { createFloor } from './floor';
import { loadPlay, type Play } from './play';
import type { Recording } from './recording';

const BACKGROUND = { light: '#e9eef2', dark: '#171b1f' } as const;
/** From where the camera looks at the target. */
const DIRECTION = new Vector3(-0.75, 0.7, 0.95).normalize();
/** Distance of the camera, in radii of what it frames. */
const DISTANCE = 2.6;

/** A 3D view of recordings. It renders only after a change. */
export interface Stage {
  /**
   * Shows a recording. The camera is kept if the previous recording was of the same world.
   *
   * @param trailColour of the path of the robot
   */
  load: (recording: Recording, trailColour: string) => Promise<void>;
  /** Shows a time, in seconds of simulation time. */
  seek: (time: number) => void;
  /** The body that the camera can follow; null if no body moves. */
  readonly followable: () => string | null;
  follow: (on: boolean) => void;
  setDark: (dark: boolean) => void;
  /** Rotates the camera around its target, in radians. */
  rotate: (azimuth: number, elevation: number) => void;
  /** Moves the camera closer; farther for factors below 1. */
  zoom: (factor: number) => void;
  /** Frames the robot and its path. */
  reset: () => void;
  dispose: () => void;
}

/**
 * Creates a stage that fills an element.
 *
 * @throws Error if the browser has no WebGL
 */
export function openStage(parent: HTMLElement): Stage {
  const renderer = new WebGLRenderer({ antialias: true });
  const canvas = renderer.domElement;
  canvas.style.display = 'block';
  parent.append(canvas);
  const scene = new Scene();
  const camera = new PerspectiveCamera(45, 1, 0.01, 200);
  const controls = new OrbitControls(camera, canvas);
  const sun = new DirectionalLight('#ffffff', 1.5);
  sun.position.set(2, 5, 3);
  const sky = new HemisphereLight('#ffffff', '#8a9099', 1.1);
  const floor = createFloor();
  scene.add(sky, sun, floor.root);

  let play: Play | null = null;
  let following = false;
  let frameRequest = 0;

  const render = () => {
    frameRequest = 0;
    renderer.render(scene, camera);
  };
  const invalidate = () => {
    frameRequest ||= requestAnimationFrame(render);
  };
  const resize = new ResizeObserver(() => {
    const { clientWidth, clientHeight } = parent;
    if (clientWidth === 0 || clientHeight === 0) return;
    renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    renderer.setSize(clientWidth, clientHeight);
    play?.trail.setResolution(clientWidth, clientHeight);
    camera.aspect = clientWidth / clientHeight;
    camera.updateProjectionMatrix();
    // Immediately, because a resized canvas is blank.
    render();
  });
  resize.observe(parent);
  controls.addEventListener('change', invalidate);

  const lookAt = (target: Vector3) => {
    camera.position.add(target).sub(controls.target);
    controls.target.copy(target);
    controls.update();
  };

  const reset = () => {
    if (!play) return;
    const { center, radius } = play.frame();
    const target = (following && play.position()) || center;
    controls.target.copy(target);
    camera.position.copy(target).addScaledVector(DIRECTION, radius * DISTANCE);
    controls.update();
    invalidate();
  };

  return {
    async load(recording, trailColour) {
      const next = await loadPlay(recording, trailColour);
      const sameWorld = play?.world === next.world;
      if (play) {
        scene.remove(play.root, play.trail.root);
        play.dispose();
      }
      play = next;
      next.trail.setResolution(parent.clientWidth, parent.clientHeight);
      scene.add(next.root, next.trail.root);
      next.seek(recording.times[0] ?? 0);
      floor.fit(next.floorHeight, next.frame());
      if (!sameWorld) reset();
      invalidate();
    },
    seek(time) {
      if (!play) return;
      const before = play.position();
      play.seek(time);
      const after = play.position();
      if (following && before && after) lookAt(controls.target.clone().add(after).sub(before));
      invalidate();
    },
    followable: () => play?.followable ?? null,
    follow(on) {
      following = on;
      const position = on ? play?.position() : null;
      if (!position) return;
      lookAt(position);
      invalidate();
    },
    setDark(dark) {
      scene.background = new Color(dark ? BACKGROUND.dark : BACKGROUND.light);
      sky.intensity = dark ? 0.8 : 1.1;
      floor.setDark(dark);
      invalidate();
    },
    rotate(azimuth, elevation) {
      const offset = new Spherical().setFromVector3(camera.position.clone().sub(controls.target));
      offset.theta += azimuth;
      offset.phi += elevation;
      offset.makeSafe();
      camera.position.setFromSpherical(offset).add(controls.target);
      controls.update();
      invalidate();
    },
    zoom(factor) {
      camera.position.sub(controls.target).divideScalar(factor).add(controls.target);
      controls.update();
      invalidate();
    },
    reset,
    dispose() {
      cancelAnimationFrame(frameRequest);
      resize.disconnect();
      controls.dispose();
      play?.dispose();
      floor.dispose();
      renderer.dispose();
      // Browsers limit the number of contexts and release unused ones late.
      renderer.forceContextLoss();
      canvas.remove();
    },
  };
}
