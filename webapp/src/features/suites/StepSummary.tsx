import { Fragment } from 'react';
import type { SuiteCase } from '@/shared/api';
import { UserText } from '@/shared/ui';
import { stepText } from './steps';
import classes from './suites.module.css';

interface StepSummaryProps {
  item: SuiteCase;
  onOpen: () => void;
}

/** The steps of a sequence in one line; a click shows their values. */
export function StepSummary({ item, onOpen }: StepSummaryProps) {
  return (
    <button type="button" className={classes.summary} title="Show the values" onClick={onOpen}>
      {item.steps.map((step, index) => (
        <Fragment key={index}>
          {index > 0 && ' → '}
          <span data-class={step.valid ? 'valid' : 'invalid'}>
            <UserText>{stepText(step)}</UserText>
          </span>
        </Fragment>
      ))}
    </button>
  );
}
