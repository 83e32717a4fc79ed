// SPDX-License-Identifier: GPL-3.0-or-later
// Replays an MCAP without compression by the protocol's public implementation for JavaScript:
// node foxglove_server.js FILE.mcap SECONDS; prints its port, and ends when all is said.
'use strict';
const fs = require('fs');
const {FoxgloveServer} = require('@foxglove/ws-protocol');
const {WebSocketServer} = require('ws');

const [, , file, seconds] = process.argv;
const schemas = new Map();
const channels = new Map();
const messages = [];

function text(data, at) {
  const length = data.readUInt32LE(at);
  return [data.toString('utf8', at + 4, at + 4 + length), at + 4 + length];
}

function readRecords(data, at) {
  while (at + 9 <= data.length) {
    const op = data[at];
    const length = Number(data.readBigUInt64LE(at + 1));
    const body = data.subarray(at + 9, at + 9 + length);
    at += 9 + length;
    if (op === 3) {
      const [name, next] = text(body, 2);
      const [encoding, end] = text(body, next);
      schemas.set(body.readUInt16LE(0), {name, encoding, data: text(body, end)[0]});
    } else if (op === 4) {
      const [topic, next] = text(body, 4);
      channels.set(body.readUInt16LE(0),
                   {topic, encoding: text(body, next)[0], schema: schemas.get(body.readUInt16LE(2))});
    } else if (op === 5) {
      messages.push({channel: body.readUInt16LE(0), time: body.readBigUInt64LE(6),
                     data: body.subarray(22)});
    } else if (op === 6) {
      const [compression, next] = text(body, 28);
      if (compression !== '') throw new Error(`compressed by ${compression}`);
      readRecords(body.subarray(next + 8), 0);
    } else if (op === 15) {
      return;
    }
  }
}
readRecords(fs.readFileSync(file), 8);

const server = new FoxgloveServer({name: 'replay'});
const ids = new Map();
for (const [id, channel] of channels) {
  ids.set(id, server.addChannel({
    topic: channel.topic, encoding: channel.encoding, schemaName: channel.schema.name,
    schemaEncoding: channel.schema.encoding, schema: channel.schema.data}));
}
const sockets = new WebSocketServer({
  port: 0, host: '127.0.0.1', handleProtocols: (offered) => server.handleProtocols(offered)});
sockets.on('connection', (socket) => server.handleConnection(socket, 'client'));
sockets.on('listening', () => console.log(sockets.address().port));

const wanted = new Set();
server.on('subscribe', (id) => wanted.add(id));
const all = () => [...channels.values()].filter(
    (c) => /LaserScan|Odometry|TFMessage/.test(c.schema.name)).length;
const waits = setInterval(() => {
  if (wanted.size < all()) return;
  clearInterval(waits);
  play();
}, 10);

function play() {
  const begin = Date.now();
  let said = 0;
  const timer = setInterval(() => {
    const until = messages.length * Math.min(1, (Date.now() - begin) / (1000 * seconds));
    for (; said < until; ++said) {
      const {channel, time, data} = messages[said];
      if (wanted.has(ids.get(channel))) server.sendMessage(ids.get(channel), time, data);
    }
    if (said < messages.length) return;
    clearInterval(timer);
    for (const socket of sockets.clients) socket.close();
    sockets.close();
  }, 5);
}
