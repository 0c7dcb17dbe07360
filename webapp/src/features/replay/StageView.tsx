import { Alert, Loader, useComputedColorScheme } from '@mantine/core';
import { useEffect, useRef, useState, type KeyboardEvent } from 'react';
import type { CameraPreset } from './cameraPresets';
import type { Verdict } from '@/shared/api';
import { formatCount } from '@/shared/lib/format';
import { VERDICT_COLOURS, VERDICT_LABELS } from '@/shared/lib/verdicts';
import { useArrived } from '@/shared/lib/arrival';
import type { Recording } from './recording';
import classes from './replay.module.css';
import { SceneMenu } from './SceneMenu';
import type { FrameCost, Stage } from './stage';
import { useSceneOptions } from './useSceneOptions';

interface StageViewProps {
  recording: Recording;
  /** The verdict of the case, if it is known. */
  verdict?: Verdict | undefined;
  time: number;
  following: boolean;
  /** Describes the scene for screen readers. */
  label: string;
  /** Called when the recording is loaded, with the body that the camera can follow or null. */
  onReady: (followable: string | null) => void;
}

const NO_WEBGL = 'WebGL is not available in this browser. The table of readings has the same data.';
const COST_INTERVAL_MS = 500;
const ROTATION = Math.PI / 24;
/** The colour of the trail without a verdict. */
const NEUTRAL = '#2a94a2';
const ZOOM = 1.15;

/** The 3D view of a recording. three.js is loaded when the first one is shown. */
export function StageView({ recording, verdict, time, following, label, onReady }: StageViewProps) {
  const place = useRef<HTMLDivElement>(null);
  const [stage, setStage] = useState<Stage | null>(null);
  const [loaded, setLoaded] = useState<Recording | null>(null);
  const [failure, setFailure] = useState(() => (hasWebGl() ? null : NO_WEBGL));
  const arrived = useArrived();
  const dark = useComputedColorScheme('light') === 'dark';
  const [options, setOptions] = useSceneOptions();
  const ready = useRef(onReady);
  useEffect(() => {
    ready.current = onReady;
  }, [onReady]);

  useEffect(() => {
    if (!arrived) return;
    let created: Stage | undefined;
    let disposed = false;
    import('./stage')
      .then(({ openStage }) => {
        if (disposed || !place.current) return;
        created = openStage(place.current);
        setStage(created);
      })
      .catch(() => {
        setFailure(NO_WEBGL);
      });
    return () => {
      disposed = true;
      created?.dispose();
      setStage(null);
    };
  }, [arrived]);

  useEffect(() => {
    if (!stage) return;
    let disposed = false;
    stage
      .load(recording, verdict ? VERDICT_COLOURS[verdict] : NEUTRAL)
      .then(() => {
        if (disposed) return;
        setLoaded(recording);
        ready.current(stage.followable());
      })
      .catch((cause: unknown) => {
        setFailure(`The recording cannot be shown: ${String(cause)}`);
      });
    return () => {
      disposed = true;
    };
  }, [stage, recording, verdict]);

  useEffect(() => {
    stage?.setDark(dark);
  }, [stage, dark]);
  useEffect(() => {
    stage?.setOptions(options);
  }, [stage, options]);
  useEffect(() => {
    if (loaded === recording) stage?.seek(time);
  }, [stage, loaded, recording, time]);
  useEffect(() => {
    if (loaded === recording) stage?.follow(following);
  }, [stage, loaded, recording, following]);

  function handleKey(event: KeyboardEvent) {
    const handled =
      stage && !event.ctrlKey && !event.altKey && !event.metaKey && moveCamera(stage, event.key);
    if (handled) {
      event.preventDefault();
      event.stopPropagation();
    }
  }

  if (failure) {
    return (
      <Alert role="status" color="gray" variant="light" title="No 3D view">
        {failure}
      </Alert>
    );
  }
  return (
    <div className={classes.scene}>
      <div
        ref={place}
        className={classes.stage}
        role="application"
        aria-roledescription="3D view"
        aria-label={`${label}. Arrow keys rotate the camera, plus and minus zoom, R resets the view.`}
        tabIndex={0}
        data-loaded={loaded === recording}
        onKeyDown={handleKey}
      >
        {verdict && (
          <span className={classes.verdict} style={{ borderColor: VERDICT_COLOURS[verdict] }}>
            <span aria-hidden>{VERDICT_LABELS[verdict].sign}</span> {VERDICT_LABELS[verdict].label}
          </span>
        )}
        {loaded !== recording && <Loader size="sm" className={classes.loading ?? ''} aria-hidden />}
      </div>
      <SceneMenu
        options={options}
        onOptions={setOptions}
        onView={(preset: CameraPreset) => stage?.setView(preset)}
      />
      {options.cost && stage && <Cost stage={stage} />}
    </div>
  );
}

/** What a frame costs. */
function Cost({ stage }: { stage: Stage }) {
  const [cost, setCost] = useState<FrameCost>(() => stage.cost());
  useEffect(() => {
    const timer = setInterval(() => {
      setCost(stage.cost());
    }, COST_INTERVAL_MS);
    return () => {
      clearInterval(timer);
    };
  }, [stage]);
  return (
    <div className={classes.cost} data-testid="cost">
      {formatCount(cost.drawCalls)} draw calls, {formatCount(cost.triangles)} triangles,{' '}
      {cost.scriptMs.toFixed(1)} ms of script per frame
    </div>
  );
}

/** Checked before three.js is loaded. */
function hasWebGl(): boolean {
  const context = document.createElement('canvas').getContext('webgl2');
  context?.getExtension('WEBGL_lose_context')?.loseContext();
  return context !== null;
}

/** Returns whether the key moves the camera. */
function moveCamera(stage: Stage, key: string): boolean {
  switch (key) {
    case 'ArrowLeft':
      stage.rotate(-ROTATION, 0);
      return true;
    case 'ArrowRight':
      stage.rotate(ROTATION, 0);
      return true;
    case 'ArrowUp':
      stage.rotate(0, -ROTATION);
      return true;
    case 'ArrowDown':
      stage.rotate(0, ROTATION);
      return true;
    case '+':
    case '=':
      stage.zoom(ZOOM);
      return true;
    case '-':
      stage.zoom(1 / ZOOM);
      return true;
    case 'r':
    case 'R':
      stage.setView('default');
      return true;
    default:
      return false;
  }
}
