export { useSession, useSignOut } from './queries';
export { SignIn } from './SignIn';
