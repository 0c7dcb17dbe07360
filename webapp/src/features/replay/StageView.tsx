import { Alert, Loader, useComputedColorScheme } from '@mantine/core';
import { useEffect, useRef, useState, type KeyboardEvent } from 'react';
import type { Recording } from './recording';
import classes from './replay.module.css';
import type { Stage } from './stage';

interface StageViewProps {
  recording: Recording;
  time: number;
  following: boolean;
  /** What is to be seen, in words. */
  label: string;
  /** Called with the body that can be followed, or null, once the recording is on the stage. */
  onReady: (followable: string | null) => void;
}

const NO_WEBGL =
  'This browser shows no 3D: WebGL is missing or switched off. The readings say the same in numbers.';
const TURN = Math.PI / 24;
const NEARER = 1.15;

/** The 3D view of a recording; its library is loaded with the first one that is shown. */
export function StageView({ recording, time, following, label, onReady }: StageViewProps) {
  const place = useRef<HTMLDivElement>(null);
  const [stage, setStage] = useState<Stage | null>(null);
  const [loaded, setLoaded] = useState<Recording | null>(null);
  const [failure, setFailure] = useState(() => (hasWebGl() ? null : NO_WEBGL));
  const dark = useComputedColorScheme('light') === 'dark';
  const ready = useRef(onReady);
  useEffect(() => {
    ready.current = onReady;
  }, [onReady]);

  useEffect(() => {
    let opened: Stage | undefined;
    let gone = false;
    import('./stage')
      .then(({ openStage }) => {
        if (gone || !place.current) return;
        opened = openStage(place.current);
        setStage(opened);
      })
      .catch(() => {
        setFailure(NO_WEBGL);
      });
    return () => {
      gone = true;
      opened?.dispose();
      setStage(null);
    };
  }, []);

  useEffect(() => {
    if (!stage) return;
    let gone = false;
    stage
      .load(recording)
      .then(() => {
        if (gone) return;
        setLoaded(recording);
        ready.current(stage.followable());
      })
      .catch((cause: unknown) => {
        setFailure(`The recording cannot be drawn: ${String(cause)}`);
      });
    return () => {
      gone = true;
    };
  }, [stage, recording]);

  useEffect(() => {
    stage?.dark(dark);
  }, [stage, dark]);
  useEffect(() => {
    if (loaded === recording) stage?.seek(time);
  }, [stage, loaded, recording, time]);
  useEffect(() => {
    if (loaded === recording) stage?.follow(following);
  }, [stage, loaded, recording, following]);

  function steer(event: KeyboardEvent) {
    const done =
      stage && !event.ctrlKey && !event.altKey && !event.metaKey && act(stage, event.key);
    if (done) {
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
    <div
      ref={place}
      className={classes.stage}
      role="application"
      aria-roledescription="3D view"
      aria-label={`${label}. Arrow keys turn the camera, plus and minus bring it nearer or farther, R shows all.`}
      tabIndex={0}
      data-loaded={loaded === recording}
      onKeyDown={steer}
    >
      {loaded !== recording && <Loader size="sm" className={classes.loading ?? ''} aria-hidden />}
    </div>
  );
}

/** Asked before the library is loaded, which is useless without. */
function hasWebGl(): boolean {
  const context = document.createElement('canvas').getContext('webgl2');
  context?.getExtension('WEBGL_lose_context')?.loseContext();
  return context !== null;
}

/** Whether the key means something to the camera. */
function act(stage: Stage, key: string): boolean {
  switch (key) {
    case 'ArrowLeft':
      stage.turn(-TURN, 0);
      return true;
    case 'ArrowRight':
      stage.turn(TURN, 0);
      return true;
    case 'ArrowUp':
      stage.turn(0, -TURN);
      return true;
    case 'ArrowDown':
      stage.turn(0, TURN);
      return true;
    case '+':
    case '=':
      stage.approach(NEARER);
      return true;
    case '-':
      stage.approach(1 / NEARER);
      return true;
    case 'r':
    case 'R':
      stage.reset();
      return true;
    default:
      return false;
  }
}
