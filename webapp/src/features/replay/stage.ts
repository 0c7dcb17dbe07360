import { PCFShadowMap, PerspectiveCamera, Scene, WebGLRenderer, type Vector3 } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { createMoves, DIRECTIONS } from './camera';
import type { CameraPreset } from './cameraPresets';
import { loadPlay, type Play } from './play';
import type { Recording } from './recording';
import { addSurroundings } from './surroundings';

/** What the user has switched on. */
export interface SceneOptions {
  shadows: boolean;
  trail: boolean;
  beams: boolean;
  /** The coordinate frames of bodies and sensors. */
  frames: boolean;
  /** Whether the robot has the colour of the verdict. */
  tint: boolean;
}

/** What the last frame cost. */
export interface FrameCost {
  drawCalls: number;
  triangles: number;
  /** Time of the script, in milliseconds, on average over the last frames. */
  scriptMs: number;
}

/** A 3D view of recordings. It renders only after a change. */
export interface Stage {
  /**
   * Shows a recording. The camera is kept if the previous recording was of the same world.
   *
   * @param colour of the path of the robot, and of the robot if that is switched on
   */
  load: (recording: Recording, colour: string) => Promise<void>;
  /** Shows a time, in seconds of simulation time. */
  seek: (time: number) => void;
  /** The body that the camera can follow; null if no body moves. */
  readonly followable: () => string | null;
  follow: (on: boolean) => void;
  setDark: (dark: boolean) => void;
  setOptions: (options: SceneOptions) => void;
  /** Frames the robot and its path from a side. */
  setView: (preset: CameraPreset) => void;
  /** Rotates the camera around its target, in radians. */
  rotate: (azimuth: number, elevation: number) => void;
  /** Moves the camera closer; farther for factors below 1. */
  zoom: (factor: number) => void;
  cost: () => FrameCost;
  dispose: () => void;
}

/** The share of the newest frame in the average of the script's time. */
const NEWEST = 0.1;
const FENCE_INTERVAL_MS = 10;
const SKIPPED_FRAMES = 3;

/** Without a graphics card, each pixel of a shadow costs time of the processor. */
function drawsInSoftware(renderer: WebGLRenderer): boolean {
  const context = renderer.getContext();
  const names = context.getExtension('WEBGL_debug_renderer_info');
  const name = String(context.getParameter(names?.UNMASKED_RENDERER_WEBGL ?? context.RENDERER));
  return /swiftshader|llvmpipe|softpipe|software/i.test(name);
}

/** Waits, without stopping the page, until everything has been drawn. */
async function drawn(context: WebGL2RenderingContext): Promise<void> {
  const fence = context.fenceSync(context.SYNC_GPU_COMMANDS_COMPLETE, 0);
  if (!fence) return;
  context.flush();
  while (context.clientWaitSync(fence, 0, 0) === context.TIMEOUT_EXPIRED) {
    await new Promise((resolve) => setTimeout(resolve, FENCE_INTERVAL_MS));
  }
  context.deleteSync(fence);
}

/**
 * Creates a stage that fills an element.
 *
 * @throws Error if the browser has no WebGL
 */
export function openStage(parent: HTMLElement): Stage {
  const renderer = new WebGLRenderer({ antialias: true });
  renderer.shadowMap.enabled = true;
  renderer.shadowMap.type = PCFShadowMap;
  const software = drawsInSoftware(renderer);
  const canvas = renderer.domElement;
  canvas.style.display = 'block';
  canvas.style.visibility = 'hidden';
  parent.append(canvas);
  const scene = new Scene();
  const camera = new PerspectiveCamera(45, 1, 0.01, 200);
  const controls = new OrbitControls(camera, canvas);
  const moves = createMoves(camera, controls);
  const surroundings = addSurroundings(
    scene,
    software ? 1 : renderer.capabilities.getMaxAnisotropy(),
  );

  let play: Play | null = null;
  let options: SceneOptions | null = null;
  let following = false;
  let defaultSide = DIRECTIONS.default;
  let frameRequest = 0;
  let scriptMs = 0;
  let frames = 0;

  let compiling = 0;
  let disposed = false;

  const render = () => {
    frameRequest = 0;
    // Without a recording there is nothing to see, and a browser without a graphics card waits for each frame.
    if (!play || compiling > 0 || disposed) return;
    const begin = performance.now();
    surroundings.follow(camera);
    renderer.render(scene, camera);
    frames++;
    // The first frames compile shaders.
    if (frames > SKIPPED_FRAMES) {
      const share = Math.max(NEWEST, 1 / (frames - SKIPPED_FRAMES));
      scriptMs += (performance.now() - begin - scriptMs) * share;
    }
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
    moves.lookAt(target);
    surroundings.lookAt(target);
  };
  const setView = (preset: CameraPreset) => {
    if (!play) return;
    const { center, radius } = play.frame();
    const direction = preset === 'default' ? defaultSide : DIRECTIONS[preset];
    moves.frame({ center: (following && play.position()) || center, radius }, direction);
    surroundings.lookAt(controls.target);
    invalidate();
  };
  const applyOptions = () => {
    if (!options) return;
    renderer.shadowMap.enabled = options.shadows && !software;
    play?.setOptions(options);
    invalidate();
  };

  return {
    async load(recording, colour) {
      const next = await loadPlay(recording, colour);
      const sameWorld = play?.world === next.world;
      if (play) {
        scene.remove(play.root, play.trail.root);
        play.dispose();
      }
      play = next;
      next.trail.setResolution(parent.clientWidth, parent.clientHeight);
      scene.add(next.root, next.trail.root);
      next.seek(recording.times[0] ?? 0);
      surroundings.fit(next.floorHeight, next.frame());
      applyOptions();
      if (!sameWorld) {
        defaultSide = moves.freeSide(next.frame(), next.isHiddenFrom);
        setView('default');
      }
      compiling++;
      try {
        await renderer.compileAsync(scene, camera);
        // The first frame takes longest. While the canvas is hidden, the page does not wait for it.
        if (!disposed) {
          renderer.render(scene, camera);
          await drawn(renderer.getContext() as WebGL2RenderingContext);
        }
      } finally {
        compiling--;
      }
      canvas.style.visibility = 'visible';
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
      surroundings.setDark(dark);
      invalidate();
    },
    setOptions(wanted) {
      options = wanted;
      applyOptions();
    },
    setView,
    rotate(azimuth, elevation) {
      moves.rotate(azimuth, elevation);
      invalidate();
    },
    zoom(factor) {
      moves.zoom(factor);
      invalidate();
    },
    cost: () => ({
      drawCalls: renderer.info.render.calls,
      triangles: renderer.info.render.triangles,
      scriptMs,
    }),
    dispose() {
      disposed = true;
      cancelAnimationFrame(frameRequest);
      resize.disconnect();
      controls.dispose();
      play?.dispose();
      surroundings.dispose();
      renderer.dispose();
      // Browsers limit the number of contexts and release unused ones late.
      renderer.forceContextLoss();
      canvas.remove();
    },
  };
}
