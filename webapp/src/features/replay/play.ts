import {
  AnimationMixer,
  AxesHelper,
  Box3,
  BufferGeometry,
  Color,
  Line,
  LineBasicMaterial,
  Mesh,
  MeshStandardMaterial,
  Raycaster,
  Sphere,
  Vector3,
  type AnimationAction,
  type Material,
  type Object3D,
} from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { frameAt, readingsIn, spreadFrames, type Recording } from './recording';
import { createTrail, type Trail } from './trail';

const BEAM = '#e03131';
/** Larger objects, in metres, belong to the surroundings. */
const MAX_OBJECT_M = 8;
/** Bodies that move less, in metres, count as fixed. */
const MIN_TRAVEL_M = 0.02;
/** The camera shows at most this many radii of the robot, so that the robot is not too small. */
const MAX_FRAME = 5;
const MIN_RADIUS_M = 0.2;
/** Length of the axes of a coordinate frame, in radii of the robot, and the maximum number of frames. */
const FRAME_SIZE = 0.25;
const MAX_FRAMES = 100;
/** Points of the path of the robot. */
const MAX_PATH_POINTS = 400;

/** What the camera shows: a sphere, in metres. */
export interface Frame {
  center: Vector3;
  radius: number;
}

/** Parts of a recording that can be switched on. */
interface PlayOptions {
  trail: boolean;
  beams: boolean;
  frames: boolean;
  tint: boolean;
}

/** The share of the verdict's colour in that of the robot. */
const TINT = 0.65;

/** A recording in the scene. */
export interface Play {
  root: Object3D;
  trail: Trail;
  /** File of the world's description. */
  world: string;
  /** Name of the body that the camera can follow; null if no body moves. */
  followable: string | null;
  floorHeight: number;
  seek: (time: number) => void;
  /** The position of the followable body. */
  position: () => Vector3 | null;
  /** The robot and its path. */
  frame: () => Frame;
  /** Whether something hides the robot from a point. */
  isHiddenFrom: (point: Vector3) => boolean;
  setOptions: (options: PlayOptions) => void;
  dispose: () => void;
}

export async function loadPlay(recording: Recording, colour: string): Promise<Play> {
  const { scene: root, animations } = await new GLTFLoader().parseAsync(recording.glb, '');
  const mixer = new AnimationMixer(root);
  const [clip] = animations;
  const action: AnimationAction | null = clip ? mixer.clipAction(clip) : null;
  action?.play();
  const floorHeight = hideFloor(root);
  const beams = createBeams(root, recording);
  castShadows(root);
  const pose = (time: number) => {
    if (action) {
      action.time = time;
      // A step of 0 applies the time of the action, also at its end.
      mixer.update(0);
    }
    root.updateMatrixWorld(true);
  };
  const bodies = root.children.flatMap((world) => world.children);
  const { body, path } = findRobot(bodies, recording, pose);
  const trail = createTrail(path, colour);
  const seek = (time: number) => {
    pose(time);
    const frame = frameAt(recording, time);
    beams.show(frame);
    trail.showUntil(time);
  };
  const frames = createFrames(root, body);
  const tint = createTint(body ?? root, colour);
  const position = () => body && body.getWorldPosition(new Vector3());
  return {
    root,
    trail,
    world: recording.world,
    followable: body ? nameOf(body) : null,
    floorHeight,
    seek,
    position,
    frame() {
      const box = body ? boxOf(body) : new Box3();
      if (box.isEmpty()) return sphereOf(boxOf(root));
      const robot = sphereOf(box);
      const all = sphereOf(path.reduce((sum, { point }) => sum.expandByPoint(point), box));
      return all.radius <= robot.radius * MAX_FRAME
        ? all
        : { center: robot.center, radius: robot.radius * MAX_FRAME };
    },
    isHiddenFrom: (point) => {
      if (!body) return false;
      const { center } = sphereOf(boxOf(body));
      const ray = new Raycaster(point, center.clone().sub(point).normalize());
      ray.far = center.distanceTo(point);
      const [nearest] = ray.intersectObject(root).filter(({ object }) => isSolid(object));
      return nearest !== undefined && !isBelow(nearest.object, body);
    },
    setOptions(options) {
      trail.root.visible = options.trail;
      beams.setVisible(options.beams);
      frames.setVisible(options.frames);
      tint(options.tint);
    },
    dispose() {
      mixer.stopAllAction();
      trail.dispose();
      root.traverse((node) => {
        if (!(node instanceof Mesh || node instanceof Line)) return;
        (node.geometry as BufferGeometry).dispose();
        for (const material of [node.material as Material | Material[]].flat()) material.dispose();
      });
    },
  };
}

function isSolid(node: Object3D): boolean {
  return node instanceof Mesh && node.visible;
}

function isBelow(node: Object3D, root: Object3D): boolean {
  for (let above: Object3D | null = node; above; above = above.parent) {
    if (above === root) return true;
  }
  return false;
}

/** The name of the body in the world; the loader changes names to fit its own paths. */
function nameOf(node: Object3D): string {
  const { name } = node.userData as { name?: unknown };
  return typeof name === 'string' ? name : node.name;
}

/** A point of a path, in metres, and its time. */
export interface PathPoint {
  time: number;
  point: Vector3;
}

/** The body with devices that moves most, or else the body that moves most, and its path. */
function findRobot(
  bodies: readonly Object3D[],
  recording: Recording,
  pose: (time: number) => void,
): { body: Object3D | null; path: PathPoint[] } {
  const paths = new Map(bodies.map((body) => [body, [] as PathPoint[]] as const));
  for (const frame of spreadFrames(recording, MAX_PATH_POINTS)) {
    const time = recording.times[frame] ?? 0;
    pose(time);
    for (const [body, path] of paths) {
      path.push({ time, point: body.getWorldPosition(new Vector3()) });
    }
  }
  const travel = (body: Object3D) =>
    new Box3()
      .setFromPoints((paths.get(body) ?? []).map(({ point }) => point))
      .getSize(new Vector3())
      .length();
  const moving = bodies
    .filter((body) => travel(body) > MIN_TRAVEL_M)
    .sort((a, b) => travel(b) - travel(a));
  const equipped = new Set(recording.devices.map(({ body }) => body));
  const body = moving.find((candidate) => equipped.has(nameOf(candidate))) ?? moving[0] ?? null;
  return { body, path: (body && paths.get(body)) ?? [] };
}

/** The box of the meshes below a node, without the surroundings. */
function boxOf(root: Object3D): Box3 {
  const whole = new Box3();
  const objects = new Box3();
  root.traverse((node) => {
    if (!(node instanceof Mesh) || !node.visible) return;
    const box = new Box3().setFromObject(node);
    whole.union(box);
    const size = box.getSize(new Vector3());
    if (Math.max(size.x, size.y, size.z) <= MAX_OBJECT_M) objects.union(box);
  });
  return objects.isEmpty() ? whole : objects;
}

function sphereOf(box: Box3): Frame {
  const { center, radius } = box.getBoundingSphere(new Sphere());
  return { center, radius: Math.max(MIN_RADIUS_M, radius) };
}

/** Hides the horizontal planes of a world and returns the height of the lowest one in metres. */
function hideFloor(root: Object3D): number {
  root.updateMatrixWorld(true);
  const heights: number[] = [];
  root.traverse((node) => {
    if (!(node instanceof Mesh)) return;
    const box = new Box3().setFromObject(node);
    const size = box.getSize(new Vector3());
    if (size.y < 1e-6 && Math.min(size.x, size.z) > 1) {
      node.visible = false;
      heights.push(box.min.y);
    }
  });
  return heights.length > 0 ? Math.min(...heights) : boxOf(root).min.y;
}

/** The beams of range sensors: a line along the z axis of the sensor, as long as its reading. */
function createBeams(root: Object3D, recording: Recording) {
  const beams: { line: Line; column: number }[] = [];
  const sensors: Object3D[] = [];
  let visible = true;
  let shown = 0;
  root.traverse((node) => {
    if ((node.userData as { kind?: string }).kind === 'range') sensors.push(node);
  });
  for (const sensor of sensors) {
    const { device } = sensor.userData as { device?: string };
    const column = recording.columns.findIndex((name) => name.startsWith(`${device ?? ''}.`));
    if (column < 0) continue;
    const line = new Line(
      new BufferGeometry().setFromPoints([new Vector3(), new Vector3(0, 0, 1)]),
      new LineBasicMaterial({ color: BEAM, fog: false }),
    );
    sensor.add(line);
    beams.push({ line, column });
  }
  const show = (frame: number) => {
    shown = frame;
    const readings = readingsIn(recording, frame);
    for (const { line, column } of beams) {
      const range = readings[column] ?? 0;
      line.visible = visible && range > 0;
      line.scale.z = Math.max(range, 1e-6);
    }
  };
  return {
    show,
    setVisible(on: boolean) {
      visible = on;
      show(shown);
    },
  };
}

function castShadows(root: Object3D): void {
  root.traverse((node) => {
    if (!(node instanceof Mesh)) return;
    node.castShadow = true;
    node.receiveShadow = true;
  });
}

/** The coordinate frames of sensors and of the bodies of the robot: x red, y green, z blue. */
function createFrames(root: Object3D, robot: Object3D | null) {
  const places = new Set<Object3D>();
  root.traverse((node) => {
    if ((node.userData as { device?: unknown }).device !== undefined) places.add(node);
  });
  robot?.traverse((node) => {
    if (!(node instanceof Mesh || node instanceof Line)) places.add(node);
  });
  const size = sphereOf(boxOf(robot ?? root)).radius * FRAME_SIZE;
  let axes: AxesHelper[] = [];
  return {
    setVisible(on: boolean) {
      if (on && axes.length === 0) {
        axes = [...places].slice(0, MAX_FRAMES).map((place) => {
          const helper = new AxesHelper(size);
          (helper.material as LineBasicMaterial).fog = false;
          place.add(helper);
          return helper;
        });
      }
      for (const helper of axes) helper.visible = on;
    },
  };
}

/** Gives the meshes below a node the colour of the verdict, or their own. */
function createTint(node: Object3D, colour: string): (on: boolean) => void {
  const wanted = new Color(colour);
  let tinted: { mesh: Mesh; own: Material; other: Material }[] | null = null;
  return (on) => {
    if (on) tinted ??= tintedMeshes(node, wanted);
    for (const { mesh, own, other } of tinted ?? []) mesh.material = on ? other : own;
  };
}

/** Other parts of the world use the same materials, so the tinted ones are copies. */
function tintedMeshes(node: Object3D, wanted: Color) {
  const meshes: { mesh: Mesh; own: Material; other: Material }[] = [];
  node.traverse((part) => {
    if (!(part instanceof Mesh)) return;
    const own: unknown = part.material;
    if (!(own instanceof MeshStandardMaterial)) return;
    const other = own.clone();
    other.color.lerp(wanted, TINT);
    meshes.push({ mesh: part as Mesh, own, other });
  });
  return meshes;
}
