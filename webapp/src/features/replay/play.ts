import {
  AnimationMixer,
  Box3,
  BufferGeometry,
  Line,
  LineBasicMaterial,
  Mesh,
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
/** Points of the path of the robot. */
const MAX_PATH_POINTS = 400;

/** What the camera shows: a sphere, in metres. */
export interface Frame {
  center: Vector3;
  radius: number;
}

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
  dispose: () => void;
}

export async function loadPlay(recording: Recording, trailColour: string): Promise<Play> {
  const { scene: root, animations } = await new GLTFLoader().parseAsync(recording.glb, '');
  const mixer = new AnimationMixer(root);
  const [clip] = animations;
  const action: AnimationAction | null = clip ? mixer.clipAction(clip) : null;
  action?.play();
  const floorHeight = hideFloor(root);
  const showBeams = createBeams(root, recording);
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
  const trail = createTrail(path, trailColour);
  const seek = (time: number) => {
    pose(time);
    const frame = frameAt(recording, time);
    showBeams(frame);
    trail.showUntil(time);
  };
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
function createBeams(root: Object3D, recording: Recording): (frame: number) => void {
  const beams: { line: Line; column: number }[] = [];
  const sensors: Object3D[] = [];
  root.traverse((node) => {
    if ((node.userData as { kind?: string }).kind === 'range') sensors.push(node);
  });
  for (const sensor of sensors) {
    const { device } = sensor.userData as { device?: string };
    const column = recording.columns.findIndex((name) => name.startsWith(`${device ?? ''}.`));
    if (column < 0) continue;
    const line = new Line(
      new BufferGeometry().setFromPoints([new Vector3(), new Vector3(0, 0, 1)]),
      new LineBasicMaterial({ color: BEAM }),
    );
    sensor.add(line);
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
