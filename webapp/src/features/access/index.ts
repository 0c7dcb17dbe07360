export { Tokens } from './Tokens';
export { Users } from './Users';
