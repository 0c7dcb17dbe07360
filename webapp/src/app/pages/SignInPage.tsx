import { getRouteApi } from '@tanstack/react-router';
import { SignIn } from '@/features/session';

const route = getRouteApi('/sign-in');

export function SignInPage() {
  const { to, link } = route.useSearch();
  const navigate = route.useNavigate();
  return (
    <>
      <title>Sign in · SITAF</title>
      <SignIn
        expiredLink={link === 'expired'}
        onSignedIn={() => {
          // Only a place within the portal: an address is anybody's.
          const place = to?.startsWith('/') && !to.startsWith('//') ? to : '/';
          void navigate({ href: place, replace: true });
        }}
      />
    </>
  );
}
