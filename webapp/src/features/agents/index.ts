export { AgentsStatus } from './AgentsStatus';
export { AgentTable } from './AgentTable';
