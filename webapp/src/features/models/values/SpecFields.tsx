import { Button, Checkbox, Group, NativeSelect, Stack, TextInput } from '@mantine/core';
import { CLASSES, type ClassDraft, type SpecDraft } from '../document';

interface SpecFieldsProps {
  spec: SpecDraft;
  /** Names of the other inputs, which a related value can follow. */
  others?: readonly string[];
  onChange: (spec: SpecDraft) => void;
}

const SPECIAL = [
  { value: '', label: 'None' },
  { value: 'true', label: 'Combined like all values' },
  { value: 'each', label: 'One case each' },
];

const FORMS = [
  { value: '', label: 'By the type' },
  { value: 'quaternion_xyzw', label: 'Quaternion x, y, z, w' },
  { value: 'quaternion_wxyz', label: 'Quaternion w, x, y, z' },
  { value: 'matrix', label: 'Matrix' },
  { value: 'rpy', label: 'Roll, pitch, yaw' },
];

/** The settings of a specification; they depend on its scheme. */
export function SpecFields({ spec, others = [], onChange }: SpecFieldsProps) {
  const setting = (name: string, label: string, placeholder = '') => (
    <TextInput
      key={name}
      label={label}
      placeholder={placeholder}
      w={150}
      value={spec.settings[name] ?? ''}
      onChange={(event) => {
        onChange({ ...spec, settings: { ...spec.settings, [name]: event.currentTarget.value } });
      }}
    />
  );
  const option = (name: string, label: string) => (
    <Checkbox
      key={name}
      label={label}
      checked={spec.settings[name] === 'true'}
      onChange={(event) => {
        onChange({
          ...spec,
          settings: { ...spec.settings, [name]: String(event.currentTarget.checked) },
        });
      }}
    />
  );
  const choice = (name: string, label: string, data: { value: string; label: string }[]) => (
    <NativeSelect
      label={label}
      data={data}
      value={spec.settings[name] ?? ''}
      onChange={(event) => {
        onChange({ ...spec, settings: { ...spec.settings, [name]: event.currentTarget.value } });
      }}
    />
  );
  const special = choice('special', 'NaN, infinities and limits of the type', SPECIAL);
  const form = choice('as', 'Written as', FORMS);
  switch (spec.type) {
    case 'BVA':
      return (
        <Stack gap="sm">
          <Group align="end">
            <ClassFields spec={spec} onChange={onChange} kinds={['TWO_BOUNDARY', 'ONE_BOUNDARY']} />
            {setting('offset', 'Offset')}
          </Group>
          <Group>{special}</Group>
        </Stack>
      );
    case 'ECP':
      return (
        <Group align="end">
          <ClassFields spec={spec} onChange={onChange} />
          {spec.classes[0]?.type !== 'NEC_BOOLEAN' && [
            setting('representatives', 'Values per class', '1'),
            setting('offset', 'Offset', '1'),
          ]}
          {special}
        </Group>
      );
    case 'RANDOM':
      return (
        <Stack gap="sm">
          <Group align="end">
            {setting('count', 'Count')}
            {setting('min', 'From')}
            {setting('max', 'To')}
            <NativeSelect
              label="Distribution"
              data={['uniform', 'normal', 'weighted']}
              value={spec.settings['distribution'] ?? 'uniform'}
              onChange={(event) => {
                const distribution = event.currentTarget.value;
                // The server refuses settings that have no effect.
                const { mean = '', standard_deviation = '', ...settings } = spec.settings;
                onChange({
                  ...spec,
                  settings: {
                    ...settings,
                    distribution,
                    ...(distribution === 'normal' && { mean, standard_deviation }),
                  },
                  ranges: distribution === 'weighted' ? spec.ranges : [],
                });
              }}
            />
            {spec.settings['distribution'] === 'normal' && [
              setting('mean', 'Mean'),
              setting('standard_deviation', 'Standard deviation'),
            ]}
            {special}
          </Group>
          {spec.settings['distribution'] === 'weighted' && (
            <Ranges spec={spec} onChange={onChange} />
          )}
        </Stack>
      );
    case 'RANDOM_STRING':
      return (
        <Stack gap="sm">
          <Group align="end">
            {setting('min_length', 'Minimum length')}
            {setting('max_length', 'Maximum length')}
            {setting('negative_char_list', 'Excluded characters')}
          </Group>
          <Group>
            {option('alphabet', 'Letters')}
            {option('number', 'Digits')}
            {option('special_char', 'Special characters')}
            {option('space', 'Spaces')}
          </Group>
        </Stack>
      );
    case 'ROTATION':
      return (
        <Group align="end">
          {form}
          {setting('count', 'Count', '48')}
        </Group>
      );
    case 'DIRECTION':
      return (
        <Group align="end">
          {setting('count', 'Count', '26')}
          {setting('length', 'Length', '1')}
        </Group>
      );
    case 'POSE':
      return (
        <Group align="end">
          {form}
          {setting('count', 'Count', '48')}
          {setting('min', 'Coordinates from', '-1')}
          {setting('max', 'Coordinates to', '1')}
        </Group>
      );
    case 'RELATED':
      return (
        <Group align="end">
          {choice('to', 'Next to', [
            { value: '', label: 'Select an input' },
            ...others.map((name) => ({ value: name, label: name })),
          ])}
          {setting('offsets', 'Offsets', '0 1ulp -10%')}
        </Group>
      );
  }
}

function ClassFields({ spec, onChange, kinds }: SpecFieldsProps & { kinds?: string[] }) {
  const given = spec.classes[0] ?? {
    type: 'NEC_NUMERIC_TWO_BOUNDARY',
    attributes: {},
    values: [],
  };
  const set = (changed: ClassDraft) => {
    onChange({ ...spec, classes: [changed] });
  };
  const attribute = (name: string, label: string) => (
    <TextInput
      key={name}
      label={label}
      w={120}
      value={given.attributes[name] ?? ''}
      onChange={(event) => {
        set({ ...given, attributes: { ...given.attributes, [name]: event.currentTarget.value } });
      }}
    />
  );
  const inclusive = (name: string, label: string) => (
    <Checkbox
      key={name}
      label={label}
      checked={given.attributes[name] !== 'false'}
      onChange={(event) => {
        set({
          ...given,
          attributes: { ...given.attributes, [name]: event.currentTarget.checked ? '' : 'false' },
        });
      }}
    />
  );
  return (
    <>
      <NativeSelect
        label="Valid values"
        value={given.type}
        data={CLASSES.filter(({ value }) => !kinds || kinds.some((kind) => value.endsWith(kind)))}
        onChange={(event) => {
          const type = event.currentTarget.value;
          // The server refuses settings that have no effect.
          const { offset = '', representatives = '', ...settings } = spec.settings;
          onChange({
            ...spec,
            settings: {
              ...settings,
              ...(type !== 'NEC_BOOLEAN' && { offset, representatives }),
            },
            classes: [{ type, attributes: {}, values: [] }],
          });
        }}
      />
      {given.type === 'NEC_NUMERIC_TWO_BOUNDARY' && [
        attribute('min', 'From'),
        attribute('max', 'To'),
        <Stack key="inclusive" gap={4}>
          {inclusive('min_inclusive', 'From is valid')}
          {inclusive('max_inclusive', 'To is valid')}
        </Stack>,
      ]}
      {given.type === 'NEC_NUMERIC_ONE_BOUNDARY' && [
        attribute('min', 'From'),
        attribute('max', 'Or to'),
      ]}
      {given.type === 'NEC_NUMERIC_CONSTANT' && attribute('value', 'Value')}
      {given.type === 'NEC_NUMERIC_SET' && (
        <TextInput
          label="Values, separated by commas"
          value={given.values.join(', ')}
          onChange={(event) => {
            set({
              ...given,
              values: event.currentTarget.value.split(',').map((value) => value.trimStart()),
            });
          }}
        />
      )}
      {given.type === 'NEC_BOOLEAN' && (
        <Checkbox
          label="Only true is valid"
          checked={given.attributes['value_only'] === 'true'}
          onChange={(event) => {
            set({
              ...given,
              attributes: { value_only: event.currentTarget.checked ? 'true' : '' },
            });
          }}
        />
      )}
    </>
  );
}

function Ranges({ spec, onChange }: SpecFieldsProps) {
  return (
    <Stack gap="xs">
      {spec.ranges.map((range, index) => (
        <Group key={index} align="end">
          {(['min', 'max', 'weight'] as const).map((name) => (
            <TextInput
              key={name}
              aria-label={`${name} of range ${index + 1}`}
              placeholder={name}
              w={110}
              value={range[name]}
              onChange={(event) => {
                const changed = { ...range, [name]: event.currentTarget.value };
                onChange({ ...spec, ranges: spec.ranges.with(index, changed) });
              }}
            />
          ))}
          <Button
            variant="subtle"
            size="xs"
            onClick={() => {
              onChange({ ...spec, ranges: spec.ranges.toSpliced(index, 1) });
            }}
          >
            Remove
          </Button>
        </Group>
      ))}
      <Group>
        <Button
          variant="default"
          size="xs"
          onClick={() => {
            onChange({ ...spec, ranges: [...spec.ranges, { min: '', max: '', weight: '1' }] });
          }}
        >
          Add range
        </Button>
      </Group>
    </Stack>
  );
}
