// Every key of a scene file as the schema has it: what it means, in which unit, and what holds without it.
import {existsSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {BookError} from './results.mjs';
import {table} from './tables.mjs';
import {escape} from './text.mjs';

const schema_file = 'tools/scenes/scene.schema.json';

// The longer of two that begin alike comes first.
const units = ['kg m^2', 'kg/m^3', 'm^3/s^2', 'm/s^2', 'N s/m', 'N/m', 'kg/m', 'rad/s', 'm/s', '1/s', 'rad', 'kg', 'ns', 's', 'm', 'N'];
const unit_pattern = new RegExp(
  `(^|, )(${units.map(unit => unit.replace(/[/^]/g, '\\$&')).join('|')})(?=[.,;:]|$)(,(?= \\w+ axes))?`,
);
const raised = text => text.replace(/\^2\b/g, '²').replace(/\^3\b/g, '³');
const sentence = text => text && text[0].toUpperCase() + text.slice(1) + (/[.!?]$/.test(text) ? '' : '.');

/** {meaning, unit, otherwise} of a description such as "Of the balls, m; without it 1." */
export function parts_of(description) {
  const unit = unit_pattern.exec(description)?.[2] ?? '';
  let rest = unit ? description.replace(unit_pattern, '') : description;
  const otherwise = /(?:; w|(?:^|\. )W)ithout (?:it|them),? (.*?)(?:\.(?!\d)|$)/.exec(rest)?.[1] ?? '';
  rest = rest.replace(/(?:; without (?:it|them),? .*?(?=\.(?!\d)|$))|(?:(^|\. )Without (?:it|them),? .*?(?:\.(?!\d)|$))/, '$1').trim();
  return {meaning: sentence(raised(rest.replace(/^[;,:.\s]+|[;,\s]+$/g, '').replace(/\s+\./g, '.'))), unit: raised(unit), otherwise: raised(otherwise)};
}

const kinds_of_values = {
  vector: 'three numbers',
  box_of_vectors: 'two corners',
  positive: 'a number above 0',
  not_negative: 'a number, 0 or more',
  name: 'a name',
  names: 'names',
  orientation: 'a quaternion, or axis and angle',
  step: 'a step',
  solid: 'a solid',
  many: 'an object, many',
};

/** What may stand there. */
function value_of(property) {
  const [, named] = /\$defs\/(\w+)$/.exec(property.$ref ?? '') ?? [];
  if (named) return kinds_of_values[named] ?? named;
  if (property.const !== undefined) return `"${property.const}"`;
  if (property.enum) return `one of ${property.enum.map(each => `"${each}"`).join(', ')}`;
  if (property.anyOf) return property.anyOf.map(value_of).join(', or ');
  const article = {array: 'a list', boolean: 'true or false', integer: 'a whole number', number: 'a number', string: 'a text', object: 'an object'};
  return article[property.type] ?? '';
}

export function scene_keys(source) {
  if (!existsSync(join(source, schema_file))) throw new BookError(`there is no ${schema_file}`);
  const {$defs} = JSON.parse(readFileSync(join(source, schema_file), 'utf8'));
  const in_full = property => {
    const [, named] = /\$defs\/(\w+)$/.exec(property.$ref ?? '') ?? [];
    const far = $defs[named];
    // What is described once for several, and is a value in itself.
    return far && !kinds_of_values[named] && far.type !== 'object' ? {...far, ...property, $ref: far.$ref} : property;
  };
  const columns = ['key', 'value', 'meaning', 'unit', 'without it'].map(text => ({text}));
  const rows_of = ({properties, required = []}) =>
    Object.entries(properties).map(([key, property]) => {
      const full = in_full(property);
      const {meaning, unit, otherwise} = parts_of(full.description ?? '');
      const without = required.includes(key) ? 'it must be there' : otherwise;
      return [{html: `<code>${escape(key)}</code>`}, value_of(full), meaning, unit, without];
    });
  const of = name => {
    const what = $defs[name].description ? raised($defs[name].description) : '';
    return `<h2 id="keys_${name}"><code>${name}</code></h2>${what ? `<p>${escape(what)}</p>` : ''}${table('', columns, rows_of($defs[name]), 'table keys')}`;
  };
  const kinds = name => $defs[name].oneOf.map(({$ref}) => $ref.replace(/.*\//, ''));
  const group = (title, names) => `<h1>${title}</h1>${names.map(of).join('')}`;
  return (
    group('The scene and its bodies', ['scene', 'step', 'body', 'axis_angle', 'many', 'part']) +
    group('Solids, by their shape', kinds('solid')) +
    group('Effects, by their kind', kinds('effect'))
  );
}
