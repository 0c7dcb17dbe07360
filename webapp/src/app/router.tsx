import {
  createRootRoute,
  createRoute,
  createRouter,
  type RouterHistory,
} from '@tanstack/react-router';
import { ActivityPage } from './ActivityPage';
import { BuildPage } from './BuildPage';
import { HomePage } from './HomePage';
import { NotFound, PageError } from './NotFound';
import { activitySearch, buildSearch, homeSearch } from './search';
import { Shell } from './Shell';

const root = createRootRoute({
  component: Shell,
  notFoundComponent: NotFound,
  errorComponent: PageError,
});

const home = createRoute({
  getParentRoute: () => root,
  path: '/',
  validateSearch: homeSearch,
  component: function Home() {
    const navigate = home.useNavigate();
    return (
      <HomePage
        shown={home.useSearch()}
        onShow={(search) => void navigate({ search, resetScroll: false })}
      />
    );
  },
});

const activity = createRoute({
  getParentRoute: () => root,
  path: '/activities/$activityId',
  validateSearch: activitySearch,
  component: function Activity() {
    const navigate = activity.useNavigate();
    return (
      <ActivityPage
        activityId={activity.useParams().activityId}
        shown={activity.useSearch()}
        onShow={(search) => void navigate({ search, resetScroll: false })}
      />
    );
  },
});

const build = createRoute({
  getParentRoute: () => root,
  path: '/builds/$buildId',
  validateSearch: buildSearch,
  component: function Build() {
    const navigate = build.useNavigate();
    return (
      <BuildPage
        buildId={build.useParams().buildId}
        shown={build.useSearch()}
        onShow={(search) => void navigate({ search, resetScroll: false })}
      />
    );
  },
});

/** Every page has an address of its own; the server answers unknown paths with the portal. */
export function createPortalRouter(history?: RouterHistory) {
  return createRouter({
    routeTree: root.addChildren([home, activity, build]),
    scrollRestoration: true,
    ...(history && { history }),
  });
}

declare module '@tanstack/react-router' {
  interface Register {
    router: ReturnType<typeof createPortalRouter>;
  }
}
