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
          // Only a page of the portal: anybody can write a link.
          const page = to?.startsWith('/') && !to.startsWith('//') ? to : '/';
          void navigate({ href: page, replace: true });
        }}
      />
    </>
  );
}
