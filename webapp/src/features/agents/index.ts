export { AgentsStatus } from './AgentsStatus';
export { AgentTable } from './AgentTable';
export { Enrolments } from './Enrolments';
export { useOffersOfAgents } from './queries';
