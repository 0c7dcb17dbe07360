import {
  createRootRoute,
  createRoute,
  createRouter,
  lazyRouteComponent,
  type RouterHistory,
} from '@tanstack/react-router';
import { NotFound, PageError } from './NotFound';
import {
  activitySearch,
  buildSearch,
  buildsSearch,
  caseHistorySearch,
  compareSearch,
  activitiesSearch,
  foundSearch,
  listSearch,
  newScheduleSearch,
  replaySearch,
  signInSearch,
  suiteSearch,
} from './search';
import { Shell } from './Shell';

const root = createRootRoute({
  component: Shell,
  notFoundComponent: NotFound,
  errorComponent: PageError,
});

const getParentRoute = () => root;

const home = createRoute({
  getParentRoute,
  path: '/',
  component: lazyRouteComponent(() => import('./pages/HomePage'), 'HomePage'),
});

const activities = createRoute({
  getParentRoute,
  path: '/activities',
  validateSearch: activitiesSearch,
  component: lazyRouteComponent(() => import('./pages/ActivitiesPage'), 'ActivitiesPage'),
});

const newActivity = createRoute({
  getParentRoute,
  path: '/activities/new',
  component: lazyRouteComponent(() => import('./pages/NewActivityPage'), 'NewActivityPage'),
});

const activity = createRoute({
  getParentRoute,
  path: '/activities/$activityId',
  validateSearch: activitySearch,
  component: lazyRouteComponent(() => import('./pages/ActivityPage'), 'ActivityPage'),
});

const newModel = createRoute({
  getParentRoute,
  path: '/activities/$activityId/new-model',
  component: lazyRouteComponent(() => import('./pages/ModelPage'), 'NewModelPage'),
});

const model = createRoute({
  getParentRoute,
  path: '/activities/$activityId/models/$model',
  component: lazyRouteComponent(() => import('./pages/ModelPage'), 'ModelPage'),
});

const caseHistory = createRoute({
  getParentRoute,
  path: '/activities/$activityId/history/$model',
  validateSearch: caseHistorySearch,
  component: lazyRouteComponent(() => import('./pages/CaseHistoryPage'), 'CaseHistoryPage'),
});

const suite = createRoute({
  getParentRoute,
  path: '/suites/$suiteId',
  validateSearch: suiteSearch,
  component: lazyRouteComponent(() => import('./pages/SuitePage'), 'SuitePage'),
});

const builds = createRoute({
  getParentRoute,
  path: '/builds',
  validateSearch: buildsSearch,
  component: lazyRouteComponent(() => import('./pages/BuildsPage'), 'BuildsPage'),
});

const build = createRoute({
  getParentRoute,
  path: '/builds/$buildId',
  validateSearch: buildSearch,
  component: lazyRouteComponent(() => import('./pages/BuildPage'), 'BuildPage'),
});

const live = createRoute({
  getParentRoute,
  path: '/builds/$buildId/live',
  component: lazyRouteComponent(() => import('./pages/LivePage'), 'LivePage'),
});

const replay = createRoute({
  getParentRoute,
  path: '/builds/$buildId/cases/$caseNo',
  validateSearch: replaySearch,
  component: lazyRouteComponent(() => import('./pages/ReplayPage'), 'ReplayPage'),
});

const compare = createRoute({
  getParentRoute,
  path: '/builds/$buildId/compare',
  validateSearch: compareSearch,
  component: lazyRouteComponent(() => import('./pages/ComparePage'), 'ComparePage'),
});

const signIn = createRoute({
  getParentRoute,
  path: '/sign-in',
  validateSearch: signInSearch,
  component: lazyRouteComponent(() => import('./pages/SignInPage'), 'SignInPage'),
});

const settings = createRoute({
  getParentRoute,
  path: '/settings',
  component: lazyRouteComponent(() => import('./pages/SettingsPage'), 'SettingsPage'),
});

const agents = createRoute({
  getParentRoute,
  path: '/agents',
  validateSearch: foundSearch,
  component: lazyRouteComponent(() => import('./pages/AgentsPage'), 'AgentsPage'),
});

const schedules = createRoute({
  getParentRoute,
  path: '/schedules',
  validateSearch: listSearch,
  component: lazyRouteComponent(() => import('./pages/SchedulesPage'), 'SchedulesPage'),
});

const newSchedule = createRoute({
  getParentRoute,
  path: '/schedules/new',
  validateSearch: newScheduleSearch,
  component: lazyRouteComponent(() => import('./pages/NewSchedulePage'), 'NewSchedulePage'),
});

const schedule = createRoute({
  getParentRoute,
  path: '/schedules/$scheduleId',
  validateSearch: listSearch,
  component: lazyRouteComponent(() => import('./pages/SchedulePage'), 'SchedulePage'),
});

/** Every page has an address. The server answers unknown paths with the portal. */
export function createPortalRouter(history?: RouterHistory) {
  return createRouter({
    routeTree: root.addChildren([
      home,
      activities,
      newActivity,
      activity,
      newModel,
      model,
      caseHistory,
      suite,
      builds,
      build,
      live,
      replay,
      compare,
      agents,
      schedules,
      newSchedule,
      schedule,
      signIn,
      settings,
    ]),
    scrollRestoration: true,
    defaultPreload: 'intent',
    ...(history && { history }),
  });
}

declare module '@tanstack/react-router' {
  interface Register {
    router: ReturnType<typeof createPortalRouter>;
  }
}
