import type { ResultParameter } from '@/shared/api';

/** An input column: the parameter and the index of its value in the values of a case. */
export interface Column {
  parameter: ResultParameter;
  index: number;
}

export interface ColumnGroup {
  type: ResultParameter['type'];
  label: string;
  columns: Column[];
}

/** The paper's three kinds of test data (section 3.2), in the order of its tables. */
const KINDS: readonly { type: ResultParameter['type']; label: string }[] = [
  { type: 'TDI', label: 'Input (TDI)' },
  { type: 'TDSD', label: 'Simulation (TDSD)' },
  { type: 'TDTS', label: 'Stub (TDTS)' },
];

/** The parameters grouped by kind, in the order of the suite. Kinds without parameters are omitted. */
export function groupColumns(parameters: readonly ResultParameter[]): ColumnGroup[] {
  const columns = parameters.map((parameter, index) => ({ parameter, index }));
  return KINDS.map(({ type, label }) => ({
    type,
    label,
    columns: columns.filter((column) => column.parameter.type === type),
  })).filter((group) => group.columns.length > 0);
}
