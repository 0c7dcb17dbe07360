import { QueryClient, QueryClientProvider, useQuery } from '@tanstack/react-query';
import { render, screen, waitFor } from '@testing-library/react';
import { describe, expect, test } from 'vitest';
import { WholePage } from '@/app/WholePage';
import { useArrived } from '@/shared/lib/arrival';

/** A page with a request, and a further one that follows from its answer. */
function Page({ first, second }: { first: Promise<string>; second: Promise<string> }) {
  const name = useQuery({ queryKey: ['first'], queryFn: () => first });
  const value = useQuery({
    queryKey: ['second'],
    queryFn: () => second,
    enabled: name.isSuccess,
  });
  const arrived = useArrived();
  return <p>{`${name.data ?? 'loading'} ${value.data ?? 'loading'} ${arrived ? 'seen' : ''}`}</p>;
}

/** An answer that comes when it is given. */
function later() {
  let give: (answer: string) => void = () => undefined;
  const answer = new Promise<string>((resolve) => {
    give = resolve;
  });
  return { answer, give };
}

function open(first: Promise<string>, second: Promise<string>) {
  render(
    <QueryClientProvider client={new QueryClient()}>
      <WholePage>
        <Page first={first} second={second} />
      </WholePage>
    </QueryClientProvider>,
  );
  const page = screen.getByText(/loading/).parentElement;
  if (!page) throw new Error('The page has no place');
  return page;
}

describe('the first page', () => {
  test('is shown when its data and what follows from them are there', async () => {
    const first = later();
    const second = later();
    const page = open(first.answer, second.answer);
    expect(page.className).toMatch(/arriving/);
    first.give('one');
    await screen.findByText(/^one loading/);
    expect(page.className).toMatch(/arriving/);
    second.give('two');
    await screen.findByText('one two seen');
    expect(page.className).not.toMatch(/arriving/);
  });

  test('does not wait long for a slow answer', async () => {
    const never = new Promise<string>(() => undefined);
    const page = open(never, never);
    await waitFor(() => {
      expect(page.className).not.toMatch(/arriving/);
    });
    expect(screen.getByText(/^loading loading seen/)).toBeVisible();
  });
});
