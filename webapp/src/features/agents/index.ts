export { AgentsStatus } from './AgentsStatus';
