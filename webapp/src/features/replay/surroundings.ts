import {
  BackSide,
  Color,
  DirectionalLight,
  FogExp2,
  HemisphereLight,
  Mesh,
  ShaderMaterial,
  SphereGeometry,
  Vector3,
  type Camera,
  type Scene,
} from 'three';
import { createFloor, FLOOR_RADII } from './floor';
import type { Frame } from './play';

const SKIES = {
  light: { zenith: '#86aed3', horizon: '#e4ecf3' },
  dark: { zenith: '#0b1016', horizon: '#2b3742' },
} as const;
/** From where the sun shines. */
const SUN = new Vector3(1.2, 2.4, 1.5).normalize();
const SHADOW_PX = 2048;
/** Half the side of the square with shadows, in radii of what the camera frames. */
const SHADOW_RADII = 2.5;

/** Light, shadow, floor and sky of a scene, as in the viewer of MuJoCo. */
export interface Surroundings {
  /** Puts the floor at a height in metres, and fits light and haze to what the camera frames. */
  fit: (height: number, frame: Frame) => void;
  /** Moves the shadows to what the camera looks at. */
  lookAt: (target: Vector3) => void;
  /** Keeps the sky around the camera. */
  follow: (camera: Camera) => void;
  setDark: (dark: boolean) => void;
  dispose: () => void;
}

export function addSurroundings(scene: Scene, anisotropy: number): Surroundings {
  const floor = createFloor(anisotropy);
  const sun = new DirectionalLight('#fff6e8', 2.1);
  sun.castShadow = true;
  sun.shadow.mapSize.set(SHADOW_PX, SHADOW_PX);
  sun.shadow.bias = -0.0005;
  sun.shadow.normalBias = 0.02;
  const ambient = new HemisphereLight('#ffffff', '#8a9099', 1.2);
  const sky = createSky();
  const fog = new FogExp2('#ffffff', 0.01);
  scene.fog = fog;
  scene.add(ambient, sun, sun.target, floor.root, sky.mesh);
  let distance = 10;
  const lookAt = (target: Vector3) => {
    sun.target.position.copy(target);
    sun.position.copy(target).addScaledVector(SUN, distance);
    sun.target.updateMatrixWorld();
  };
  return {
    fit(height, frame) {
      floor.fit(height, frame);
      const half = frame.radius * SHADOW_RADII;
      distance = half * 4;
      const { camera } = sun.shadow;
      camera.left = camera.bottom = -half;
      camera.right = camera.top = half;
      camera.near = half * 0.1;
      camera.far = half * 9;
      camera.updateProjectionMatrix();
      // The floor is hidden by haze before it ends.
      fog.density = 5 / (frame.radius * FLOOR_RADII);
      lookAt(frame.center);
    },
    lookAt,
    follow(camera) {
      sky.mesh.position.copy(camera.position);
    },
    setDark(dark) {
      const { zenith, horizon } = SKIES[dark ? 'dark' : 'light'];
      sky.colour(zenith, horizon);
      fog.color.set(horizon);
      ambient.intensity = dark ? 0.9 : 1.2;
      sun.intensity = dark ? 1.7 : 2.1;
      floor.setDark(dark);
    },
    dispose() {
      floor.dispose();
      sun.dispose();
      sky.dispose();
    },
  };
}

/** A sphere around the camera whose colour depends on the height above the horizon only. */
function createSky() {
  const uniforms = { zenith: { value: new Color() }, horizon: { value: new Color() } };
  const material = new ShaderMaterial({
    side: BackSide,
    depthWrite: false,
    depthTest: false,
    fog: false,
    uniforms,
    vertexShader: `
      varying vec3 direction;
      void main() {
        direction = position;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }`,
    fragmentShader: `
      uniform vec3 zenith;
      uniform vec3 horizon;
      varying vec3 direction;
      void main() {
        float height = clamp(normalize(direction).y, 0.0, 1.0);
        gl_FragColor = vec4(mix(horizon, zenith, pow(height, 0.6)), 1.0);
        #include <colorspace_fragment>
      }`,
  });
  const mesh = new Mesh(new SphereGeometry(1, 24, 12), material);
  mesh.renderOrder = -2;
  mesh.frustumCulled = false;
  return {
    mesh,
    colour(zenith: string, horizon: string) {
      uniforms.zenith.value.set(zenith);
      uniforms.horizon.value.set(horizon);
    },
    dispose() {
      mesh.geometry.dispose();
      material.dispose();
    },
  };
}
