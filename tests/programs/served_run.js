// SPDX-License-Identifier: GPL-3.0-or-later
// A run of hitos-cli that is shown while it goes on, fed through a pipe by whoever looks at it, so
// that it is never over before all was seen.
'use strict';
const {spawn} = require('child_process');
const fs = require('fs');
const zlib = require('zlib');

/// A tour in so many parts, cut between two lines.
exports.parts = (log, count) => {
  const bytes = log.endsWith('.gz') ? zlib.gunzipSync(fs.readFileSync(log)) : fs.readFileSync(log);
  const all = [];
  for (let at = 0, i = 1; i <= count; ++i) {
    const end = i === count ? bytes.length : bytes.lastIndexOf('\n', bytes.length * i / count) + 1;
    all.push(bytes.subarray(at, end));
    at = end;
  }
  return all;
};

/// Resolves to its address and what feeds and ends it, once it says where it is.
exports.start = (cli, out, more = []) => new Promise((resolve, reject) => {
  const child = spawn(cli, ['run', '-', '--follow', '--serve', '0', '--out', out, ...more],
                      {stdio: ['pipe', 'ignore', 'pipe']});
  let said = '';
  child.stdin.on('error', () => {});  // it ended before: its status says so
  const over = new Promise((ended) => child.on('close', (status) => ended({status, said})));
  child.stderr.on('data', (bytes) => {
    said += bytes;
    const found = /http:\/\/(127\.0\.0\.1:\d+)/.exec(said);
    if (!found) return;
    resolve({
      host: found[1],
      feed: (part) => child.stdin.write(part),
      end: () => {
        child.stdin.end();
        return over;
      },
      kill: () => child.kill('SIGKILL'),
    });
  });
  over.then(({status}) => reject(new Error(`hitos-cli ended with ${status}: ${said}`)));
});
