// SPDX-License-Identifier: GPL-3.0-or-later
// Looks at a run by the protocol's public implementation for JavaScript, and holds every message
// against the schema that its channel advertised:
// node foxglove_client.js HITOS-CLI LOG OUT; prints how many of each topic came.
'use strict';
const {check} = require('./json_schema.js');
const {modules} = require('./needed.js');
const {parts, start} = require('./served_run.js');

const [{FoxgloveClient}, WebSocket] = modules(['@foxglove/ws-protocol', 'ws']);

const kTopics = ['/covariance', '/grid', '/landmarks', '/loops', '/particles', '/path', '/pose',
                 '/run', '/scan', '/tf'];
const kBytes = {1: 1, 2: 1, 3: 2, 4: 2, 5: 4, 6: 4, 7: 4, 8: 8};  // foxglove.NumericType

/// Bytes that one element's fields take, which stand one behind the other.
function size(fields, topic) {
  let bytes = 0;
  for (const field of fields) {
    if (field.offset !== bytes) throw new Error(`${topic}: ${field.name} is at ${field.offset}`);
    if (!(field.type in kBytes)) throw new Error(`${topic}: a field of the type ${field.type}`);
    bytes += kBytes[field.type];
  }
  return bytes;
}

function checkData(topic, message) {
  const expect = (is, expected, what) => {
    if (is !== expected) throw new Error(`${topic}: ${what} is ${is}, expected ${expected}`);
  };
  if (message.data === undefined) return;
  const bytes = Buffer.from(message.data, 'base64').length;
  if (topic === '/grid') {
    expect(message.cell_stride, size(message.fields, topic), 'cell_stride');
    expect(message.row_stride, message.column_count * message.cell_stride, 'row_stride');
    expect(bytes % message.row_stride, 0, 'the rest behind the last row');
  } else if (topic === '/scan') {
    expect(message.point_stride, size(message.fields, topic), 'point_stride');
    expect(bytes % message.point_stride, 0, 'the rest behind the last point');
  } else {
    throw new Error(`${topic} has data`);
  }
  if (bytes === 0) throw new Error(`${topic} has no data`);
}

async function main(cli, log, out) {
  const tour = parts(log, 12);
  const run = await start(cli, out, ['--set', 'filter.particles=20']);
  const client = new FoxgloveClient({
    ws: new WebSocket(`ws://${run.host}`, [FoxgloveClient.SUPPORTED_SUBPROTOCOL])});
  const channels = new Map();
  const count = new Map();
  const seen = new Map();
  let ending = null;
  let problem = null;
  const fail = (error) => {
    problem = problem || error;
    client.close();
  };
  client.on('error', fail);
  client.on('status', (status) => fail(new Error(`status: ${status.message}`)));
  client.on('advertise', (all) => {
    for (const channel of all) {
      if (channel.encoding !== 'json' || channel.schemaEncoding !== 'jsonschema')
        fail(new Error(`${channel.topic} is ${channel.encoding}, ${channel.schemaEncoding}`));
      channels.set(client.subscribe(channel.id),
                   {topic: channel.topic, name: channel.schemaName,
                    schema: JSON.parse(channel.schema)});
    }
    run.feed(tour.shift());
  });
  client.on('message', ({subscriptionId, timestamp, data}) => {
    if (problem) return;
    const {topic, name, schema} = channels.get(subscriptionId);
    try {
      const message = JSON.parse(Buffer.from(data.buffer, data.byteOffset, data.byteLength));
      if (schema.title !== name) throw new Error(`${topic}: the schema of ${schema.title}`);
      check(schema, message, topic, seen);
      checkData(topic, message);
      const time = message.timestamp;
      if (time && BigInt(time.sec) * 1000000000n + BigInt(time.nsec) !== timestamp)
        throw new Error(`${topic}: its time is not the frame's`);
      count.set(topic, (count.get(topic) || 0) + 1);
    } catch (error) {
      fail(error);
      return;
    }
    // A part after each state that was seen; that all is seen does not depend on who is faster.
    if (topic === '/run' && tour.length > 0) {
      run.feed(tour.shift());
    } else if (ending === null && tour.length === 0 && kTopics.every((one) => count.has(one))) {
      ending = run.end();
    }
  });
  const closed = await new Promise((resolve) => client.on('close', resolve));
  if (problem || ending === null) run.kill();
  if (problem) throw problem;
  if (ending === null) throw new Error(`closed (${closed.code}) before all had come: ` +
                                       `${[...count.keys()]}`);
  const {status, said} = await ending;
  if (status !== 0) throw new Error(`hitos-cli ended with ${status}: ${said}`);
  if (closed.code !== 1001) throw new Error(`closed with ${closed.code}, expected 1001`);
  for (const [member, there] of seen) {
    if (!there) throw new Error(`${member} is advertised and never came`);
  }
  for (const topic of kTopics) console.log(topic, count.get(topic));
}

main(...process.argv.slice(2)).catch((error) => {
  console.log(error.stack);
  process.exit(1);
});
