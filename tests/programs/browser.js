// SPDX-License-Identifier: GPL-3.0-or-later
// Chromium without a window, told what to do by its DevTools protocol through two pipes.
'use strict';
const {spawn, spawnSync} = require('child_process');
const fs = require('fs');
const os = require('os');
const path = require('path');

const found = [process.env.CHROMIUM, 'chromium', 'chromium-browser', 'google-chrome'].find(
    (name) => name && spawnSync(name, ['--version'], {stdio: 'ignore'}).status === 0);

exports.start = () => {
  if (!found) {
    console.log('chromium is missing; it would open the page (or name it in CHROMIUM)');
    process.exit(77);
  }
  const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'hitos-browser-'));
  const child = spawn(found, ['--headless=new', '--no-sandbox', '--disable-gpu',
                              '--disable-dev-shm-usage', '--no-first-run',
                              '--disable-background-networking', '--disable-component-update',
                              '--remote-debugging-pipe', `--user-data-dir=${folder}`,
                              'about:blank'],
                      {stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe']});
  const waiting = new Map();
  const listeners = [];
  let last = 0;
  let left = Buffer.alloc(0);
  child.stdio[3].on('error', () => {});
  child.stdio[4].on('data', (bytes) => {
    left = Buffer.concat([left, bytes]);
    for (let end = left.indexOf(0); end >= 0; end = left.indexOf(0)) {
      const message = JSON.parse(left.subarray(0, end));
      left = left.subarray(end + 1);
      if (!message.id) {
        for (const listener of listeners) listener(message);
        continue;
      }
      const {resolve, reject, method} = waiting.get(message.id);
      waiting.delete(message.id);
      if (message.error) reject(new Error(`${method}: ${message.error.message}`));
      else resolve(message.result);
    }
  });
  const gone = new Promise((ended) => child.on('close', ended));
  gone.then(() => {
    for (const {reject} of waiting.values()) reject(new Error(`${found} has ended`));
  });
  const call = (method, params = {}, sessionId = undefined) => new Promise((resolve, reject) => {
    waiting.set(++last, {resolve, reject, method});
    child.stdio[3].write(JSON.stringify({id: last, method, params, sessionId}) + '\0');
  });
  return {
    /// A page of its own: what it asks for and complains of is kept.
    open: async () => {
      const {targetId} = await call('Target.createTarget', {url: 'about:blank'});
      const {sessionId} = await call('Target.attachToTarget', {targetId, flatten: true});
      const page = {
        requests: [],
        complaints: [],
        call: (method, params) => call(method, params, sessionId),
        evaluate: async (expression) => {
          const said = await page.call(
              'Runtime.evaluate', {expression, awaitPromise: true, returnByValue: true});
          if (said.exceptionDetails) throw new Error(JSON.stringify(said.exceptionDetails));
          return said.result.value;
        },
        navigate: async (url) => {
          const loaded = new Promise((done) => listeners.push(({sessionId: whose, method}) => {
            if (whose === sessionId && method === 'Page.loadEventFired') done();
          }));
          await page.call('Page.navigate', {url});
          await loaded;
        },
        close: () => call('Target.closeTarget', {targetId}),
      };
      listeners.push(({sessionId: whose, method, params}) => {
        if (whose !== sessionId) return;
        if (method === 'Network.requestWillBeSent') page.requests.push(params.request.url);
        if (method === 'Network.webSocketCreated') page.requests.push(params.url);
        if (method === 'Runtime.exceptionThrown' || method === 'Runtime.consoleAPICalled' ||
            method === 'Log.entryAdded') page.complaints.push(JSON.stringify(params));
      });
      for (const what of ['Page', 'Runtime', 'Log', 'Network']) await page.call(`${what}.enable`);
      return page;
    },
    end: async () => {
      // Killed, it would leave processes behind that still write into its folder.
      call('Browser.close').catch(() => {});
      await gone;
      fs.rmSync(folder, {recursive: true, force: true, maxRetries: 50, retryDelay: 100});
    },
  };
};
