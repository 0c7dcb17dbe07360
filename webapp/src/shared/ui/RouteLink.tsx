import { Anchor, type AnchorProps } from '@mantine/core';
import { createLink } from '@tanstack/react-router';
import type { ComponentPropsWithRef } from 'react';

type AnchorElementProps = AnchorProps & Omit<ComponentPropsWithRef<'a'>, keyof AnchorProps>;

function PlainAnchor(props: AnchorElementProps) {
  return <Anchor {...props} />;
}

/** A link to a page of the portal; `to` is checked against the routes of the app. */
export const RouteLink = createLink(PlainAnchor);
