import { Button, Group, NativeSelect, SegmentedControl, TextInput } from '@mantine/core';
import { useState, type SyntheticEvent } from 'react';
import type { ResultParameter, ResultSummary } from '@/shared/api';
import { formatCount } from '@/shared/lib/format';
import { VERDICTS, VERDICT_LABELS, countOf } from '@/shared/lib/verdicts';
import type { CaseFilter } from './queries';

interface CaseFiltersProps {
  summary: ResultSummary;
  parameters: readonly ResultParameter[];
  filter: CaseFilter;
  onFilter: (filter: CaseFilter) => void;
}

/** Filters the cases by verdict and by the value of a parameter. */
export function CaseFilters({ summary, parameters, filter, onFilter }: CaseFiltersProps) {
  return (
    <Group justify="space-between" gap="sm">
      <SegmentedControl
        aria-label="Filter by verdict"
        style={{ overflowX: 'auto' }}
        size="sm"
        value={filter.verdict ?? 'ALL'}
        onChange={(value) => {
          onFilter({ ...filter, verdict: VERDICTS.find((known) => known === value) });
        }}
        data={[
          { value: 'ALL', label: `All ${formatCount(summary.total)}` },
          ...VERDICTS.map((known) => ({
            value: known,
            label: `${VERDICT_LABELS[known].label} ${formatCount(countOf(summary, known))}`,
          })),
        ]}
      />
      <ValueFilter
        key={`${filter.parameter ?? ''} ${filter.value ?? ''}`}
        parameters={parameters}
        filter={filter}
        onFilter={onFilter}
      />
    </Group>
  );
}

function ValueFilter({ parameters, filter, onFilter }: Omit<CaseFiltersProps, 'summary'>) {
  const [parameter, setParameter] = useState(filter.parameter ?? parameters[0]?.name ?? '');
  const [value, setValue] = useState(filter.value ?? '');
  if (parameters.length === 0) return null;

  function submit(event: SyntheticEvent) {
    event.preventDefault();
    onFilter(
      value === ''
        ? { verdict: filter.verdict }
        : { verdict: filter.verdict, parameter, value: value.trim() },
    );
  }

  return (
    <form onSubmit={submit}>
      <Group gap="xs" wrap="nowrap">
        <NativeSelect
          aria-label="Parameter to filter by"
          size="sm"
          value={parameter}
          onChange={(event) => {
            setParameter(event.currentTarget.value);
          }}
          data={parameters.map(({ name }) => name)}
        />
        <TextInput
          aria-label="Value of the parameter"
          placeholder="Value"
          size="sm"
          w={110}
          value={value}
          onChange={(event) => {
            setValue(event.currentTarget.value);
          }}
        />
        <Button type="submit" size="sm" variant="default">
          Filter
        </Button>
        {filter.parameter && (
          <Button
            size="sm"
            variant="subtle"
            onClick={() => {
              onFilter({ verdict: filter.verdict });
            }}
          >
            Clear
          </Button>
        )}
      </Group>
    </form>
  );
}
