export { ModelEditor } from './ModelEditor';
export { useModelDocument } from './queries';
export { readModel } from './document';
