export { BeginActivity, type BegunActivity } from './BeginActivity';
