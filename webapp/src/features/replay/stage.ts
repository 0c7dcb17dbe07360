import {
  AnimationMixer,
  Box3,
  BufferGeometry,
  Color,
  DirectionalLight,
  HemisphereLight,
  Line,
  LineBasicMaterial,
  Mesh,
  PerspectiveCamera,
  Scene,
  Spherical,
  Vector3,
  WebGLRenderer,
  type AnimationAction,
  type Material,
  type Object3D,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { frameAt, readingsIn, type Recording } from './recording';

const GROUND = { light: '#e9eef2', dark: '#171b1f' } as const;
const BEAM = '#e03131';
/** What is larger is ground, and not to be looked at whole. */
const LARGEST_M = 8;
/** A body that moves less, in metres, is not worth following. */
const LEAST_TRAVEL_M = 0.02;

/** Where recordings are played. Draws only when something has changed. */
export interface Stage {
  /** Puts a recording on the stage; what the camera looks at stays when it is of the same world. */
  load: (recording: Recording) => Promise<void>;
  /** Shows a time, in seconds of simulation time. */
  seek: (time: number) => void;
  /** The body that the camera can follow; null where none moves about. */
  readonly followable: () => string | null;
  follow: (on: boolean) => void;
  dark: (on: boolean) => void;
  /** Turns the camera about what it looks at, in radians. */
  turn: (azimuth: number, elevation: number) => void;
  /** Brings the camera nearer; below 1 farther. */
  approach: (factor: number) => void;
  /** Looks at all of it again. */
  reset: () => void;
  dispose: () => void;
}

/**
 * Opens a stage that fills an element.
 *
 * @throws Error when the browser has no WebGL
 */
export function openStage(place: HTMLElement): Stage {
  const renderer = new WebGLRenderer({ antialias: true });
  const canvas = renderer.domElement;
  canvas.style.display = 'block';
  place.append(canvas);
  const scene = new Scene();
  const camera = new PerspectiveCamera(45, 1, 0.01, 200);
  const controls = new OrbitControls(camera, canvas);
  const sun = new DirectionalLight('#ffffff', 1.5);
  sun.position.set(2, 5, 3);
  scene.add(new HemisphereLight('#ffffff', '#8a9099', 1.1), sun);

  let play: Play | null = null;
  let following = false;
  let asked = 0;

  const draw = () => {
    asked = 0;
    renderer.render(scene, camera);
  };
  const invalidate = () => {
    asked ||= requestAnimationFrame(draw);
  };
  const resize = new ResizeObserver(() => {
    const { clientWidth, clientHeight } = place;
    if (clientWidth === 0 || clientHeight === 0) return;
    renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    renderer.setSize(clientWidth, clientHeight);
    camera.aspect = clientWidth / clientHeight;
    camera.updateProjectionMatrix();
    // At once: a canvas that was resized is blank.
    draw();
  });
  resize.observe(place);
  controls.addEventListener('change', invalidate);

  const reset = () => {
    if (!play) return;
    const box = play.extent();
    const middle = box.getCenter(new Vector3());
    const radius = Math.max(0.2, box.getSize(new Vector3()).length() / 2);
    controls.target.copy(middle);
    camera.position
      .copy(middle)
      .add(new Vector3(-0.75, 0.7, 0.95).normalize().multiplyScalar(radius * 2.4));
    controls.update();
    invalidate();
  };

  return {
    async load(recording) {
      const next = await makePlay(recording);
      const known = play?.world === next.world;
      if (play) {
        scene.remove(play.root);
        play.dispose();
      }
      play = next;
      scene.add(next.root);
      next.seek(recording.times[0] ?? 0);
      if (!known) reset();
      invalidate();
    },
    seek(time) {
      if (!play) return;
      const before = play.place();
      play.seek(time);
      if (following && before) {
        const moved = play.place()?.sub(before);
        if (moved) {
          camera.position.add(moved);
          controls.target.add(moved);
          controls.update();
        }
      }
      invalidate();
    },
    followable: () => play?.followable ?? null,
    follow(on) {
      following = on;
      const place = on ? play?.place() : null;
      if (!place) return;
      camera.position.add(place.clone().sub(controls.target));
      controls.target.copy(place);
      controls.update();
      invalidate();
    },
    dark(on) {
      scene.background = new Color(on ? GROUND.dark : GROUND.light);
      invalidate();
    },
    turn(azimuth, elevation) {
      const offset = new Spherical().setFromVector3(camera.position.clone().sub(controls.target));
      offset.theta += azimuth;
      offset.phi += elevation;
      offset.makeSafe();
      camera.position.setFromSpherical(offset).add(controls.target);
      controls.update();
      invalidate();
    },
    approach(factor) {
      camera.position.sub(controls.target).divideScalar(factor).add(controls.target);
      controls.update();
      invalidate();
    },
    reset,
    dispose() {
      cancelAnimationFrame(asked);
      resize.disconnect();
      controls.dispose();
      play?.dispose();
      renderer.dispose();
      // Browsers grant few contexts, and take their time to notice that one is not used.
      renderer.forceContextLoss();
      canvas.remove();
    },
  };
}

/** A recording that is on the stage. */
interface Play {
  root: Object3D;
  world: string;
  followable: string | null;
  seek: (time: number) => void;
  /** Where the body that can be followed is. */
  place: () => Vector3 | null;
  /** What there is to see. */
  extent: () => Box3;
  dispose: () => void;
}

async function makePlay(recording: Recording): Promise<Play> {
  const { scene: root, animations } = await new GLTFLoader().parseAsync(recording.glb, '');
  const mixer = new AnimationMixer(root);
  const [clip] = animations;
  const action: AnimationAction | null = clip ? mixer.clipAction(clip) : null;
  action?.play();
  const seek = (time: number) => {
    if (action) {
      action.time = time;
      // No time passes: the action stands where it was put, its end too.
      mixer.update(0);
    }
    beams(frameAt(recording, time));
    root.updateMatrixWorld(true);
  };
  const beams = beamsOf(root, recording);
  const body = moving(root, recording, seek);
  return {
    root,
    world: recording.world,
    followable: body ? nameOf(body) : null,
    seek,
    place: () => body && body.getWorldPosition(new Vector3()),
    extent: () => extentOf(root),
    dispose() {
      mixer.stopAllAction();
      root.traverse((node) => {
        if (!(node instanceof Mesh || node instanceof Line)) return;
        (node.geometry as BufferGeometry).dispose();
        for (const material of [node.material as Material | Material[]].flat()) material.dispose();
      });
    },
  };
}

/** The name that the body has in the world; the loader makes names fit for its own paths. */
function nameOf(node: Object3D): string {
  const { name } = node.userData as { name?: unknown };
  return typeof name === 'string' ? name : node.name;
}

/** Of the bodies with devices, or of all if none of these moves, the one that goes farthest. */
function moving(
  root: Object3D,
  { devices, times }: Recording,
  seek: (time: number) => void,
): Object3D | null {
  const bodies = root.children.flatMap((world) => world.children);
  const boxes = new Map(bodies.map((body) => [body, new Box3()] as const));
  const samples = 20;
  for (let i = 0; i <= samples; i++) {
    seek(times[Math.round(((times.length - 1) * i) / samples)] ?? 0);
    for (const [body, box] of boxes) box.expandByPoint(body.position);
  }
  const travel = (body: Object3D) => boxes.get(body)?.getSize(new Vector3()).length() ?? 0;
  const farthest = (some: Object3D[]) =>
    some.filter((body) => travel(body) > LEAST_TRAVEL_M).sort((a, b) => travel(b) - travel(a))[0] ??
    null;
  const equipped = new Set(devices.map(({ body }) => body));
  return farthest(bodies.filter((body) => equipped.has(nameOf(body)))) ?? farthest(bodies);
}

/** The box about all but the ground. */
function extentOf(root: Object3D): Box3 {
  const whole = new Box3();
  const seen = new Box3();
  root.traverse((node) => {
    if (!(node instanceof Mesh)) return;
    const box = new Box3().setFromObject(node);
    whole.union(box);
    const size = box.getSize(new Vector3());
    if (Math.max(size.x, size.y, size.z) <= LARGEST_M) seen.union(box);
  });
  return seen.isEmpty() ? whole : seen;
}

/** What range sensors see: a line along the z axis of each, as long as it reads. */
function beamsOf(root: Object3D, recording: Recording): (frame: number) => void {
  const beams: { line: Line; column: number }[] = [];
  const places: Object3D[] = [];
  root.traverse((node) => {
    if ((node.userData as { kind?: string }).kind === 'range') places.push(node);
  });
  for (const place of places) {
    const { device } = place.userData as { device?: string };
    const column = recording.columns.findIndex((name) => name.startsWith(`${device ?? ''}.`));
    if (column < 0) continue;
    const line = new Line(
      new BufferGeometry().setFromPoints([new Vector3(), new Vector3(0, 0, 1)]),
      new LineBasicMaterial({ color: BEAM }),
    );
    place.add(line);
    beams.push({ line, column });
  }
  return (frame) => {
    const readings = readingsIn(recording, frame);
    for (const { line, column } of beams) {
      const range = readings[column] ?? 0;
      line.visible = range > 0;
      line.scale.z = Math.max(range, 1e-6);
    }
  };
}
