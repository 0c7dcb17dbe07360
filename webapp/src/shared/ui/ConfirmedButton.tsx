import { Button, type ButtonProps } from '@mantine/core';
import { useState } from 'react';

interface ConfirmedButtonProps extends Pick<ButtonProps, 'size' | 'loading'> {
  label: string;
  /** What it acts on, for the accessible name. */
  name: string;
  onConfirm: () => void;
}

/** A button that acts when it is pressed a second time; leaving it takes the first press back. */
export function ConfirmedButton({
  label,
  name,
  onConfirm,
  size = 'compact-xs',
  loading = false,
}: ConfirmedButtonProps) {
  const [confirming, setConfirming] = useState(false);
  return (
    <Button
      size={size}
      loading={loading}
      variant={confirming ? 'filled' : 'default'}
      {...(confirming && { color: 'red.9' })}
      aria-label={confirming ? `Confirm: ${label} ${name}` : `${label} ${name}`}
      onClick={() => {
        if (confirming) onConfirm();
        setConfirming(!confirming);
      }}
      onBlur={() => {
        setConfirming(false);
      }}
    >
      {confirming ? `Confirm: ${label}` : label}
    </Button>
  );
}
