export { StateDiagramView } from './StateDiagramView';
export { useStateDiagram } from './queries';
