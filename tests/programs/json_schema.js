// SPDX-License-Identifier: GPL-3.0-or-later
// The part of JSON Schema that channels advertise, taken at its word: a member that no schema has is
// wrong too, and so is a word of a schema that is not known here.
'use strict';

const kWords = new Set(['type', 'title', 'properties', 'required', 'items', 'enum', 'minimum',
                        'contentEncoding']);
const kTypes = {
  object: (value) => typeof value === 'object' && value !== null && !Array.isArray(value),
  array: Array.isArray,
  string: (value) => typeof value === 'string',
  number: Number.isFinite,
  integer: Number.isSafeInteger,
  boolean: (value) => typeof value === 'boolean',
};

/// Throws at the first thing that is wrong. `seen` collects the members that were there, and those
/// that might have been, by their places.
exports.check = function check(schema, value, place, seen) {
  const fail = (what) => {
    throw new Error(`${place}: ${what}`);
  };
  for (const word of Object.keys(schema)) {
    if (!kWords.has(word)) fail(`the schema has "${word}"`);
  }
  if (!kTypes[schema.type]) fail(`the schema has the type ${schema.type}`);
  if (!kTypes[schema.type](value)) fail(`expected ${schema.type}, found ${JSON.stringify(value)}`);
  if (schema.enum && !schema.enum.includes(value)) fail(`${value} is none of ${schema.enum}`);
  if (schema.minimum !== undefined && value < schema.minimum) fail(`${value} < ${schema.minimum}`);
  if (schema.contentEncoding !== undefined) {
    if (schema.contentEncoding !== 'base64') fail(`encoded as ${schema.contentEncoding}`);
    if (Buffer.from(value, 'base64').toString('base64') !== value) fail('is no base64');
  }
  if (schema.type === 'array') {
    for (const item of value) check(schema.items, item, `${place}[]`, seen);
  }
  if (schema.type !== 'object') return;
  for (const name of schema.required) {
    if (!(name in value)) fail(`"${name}" is missing`);
  }
  for (const name of Object.keys(value)) {
    if (!(name in schema.properties)) fail(`"${name}" is not advertised`);
  }
  for (const [name, part] of Object.entries(schema.properties)) {
    const member = `${place}.${name}`;
    seen.set(member, seen.get(member) || name in value);
    if (name in value) check(part, value[name], member, seen);
  }
};
