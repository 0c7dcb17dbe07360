import { Table, type TableProps } from '@mantine/core';

/** A table that scrolls horizontally, so that the page does not. */
export function ScrollTable({
  label,
  minWidth,
  ...table
}: TableProps & { label: string; minWidth: number }) {
  return (
    <Table.ScrollContainer
      minWidth={minWidth}
      type="native"
      tabIndex={0}
      role="group"
      aria-label={label}
    >
      <Table aria-label={label} verticalSpacing="xs" highlightOnHover {...table} />
    </Table.ScrollContainer>
  );
}
