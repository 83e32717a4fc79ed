// SPDX-License-Identifier: GPL-3.0-or-later
// Opens the page of a run that is served in a browser, wide and on a phone, light and dark, in
// English and Spanish: node page_in_browser.js HITOS-CLI LOG OUT [PICTURES]; the last is a folder
// for screenshots. Prints what it has looked at.
'use strict';
const fs = require('fs');
const path = require('path');
const browsers = require('./browser.js');
const {parts, start} = require('./served_run.js');

const kWords = {
  en: {waiting: 'Waiting for the first scan', live: 'Live', scans: 'Scans', whole: 'Show all',
       over: 'The run is over; connection closed', delay: ['Delay', /^\d+\.\d s$/],
       standing: ['Last picture', '7 s ago']},
  es: {waiting: 'A la espera del primer barrido', live: 'En directo', scans: 'Barridos',
       whole: 'Ver todo', over: 'El recorrido ha terminado; conexión cerrada',
       delay: ['Retraso', /^\d+,\d s$/], standing: ['Última imagen', 'hace 7 s']},
};
const kScreens = {
  desk: {width: 1366, height: 768, deviceScaleFactor: 1, mobile: false},
  turned: {width: 844, height: 390, deviceScaleFactor: 3, mobile: true},
  phone: {width: 390, height: 844, deviceScaleFactor: 3, mobile: true},
};

const expect = (is, what) => {
  if (!is) throw new Error(`expected ${what}`);
};

/// In the page: waits until the state has this word.
const stateIs = (word) => `new Promise((done) => {
  const state = document.getElementById('state');
  const look = () => state.textContent === ${JSON.stringify(word)} ? done(true) : 0;
  new MutationObserver(look).observe(state, {childList: true, characterData: true, subtree: true});
  look();
})`;

/// In the page: waits until it knows all of so many scans.
const hasAll = (scans) => `new Promise((done) => {
  const time = (topic) => JSON.stringify(told[topic] && told[topic].timestamp);
  const look = () => told['/run'] && told['/run'].scans === ${scans} && gridPicture &&
      time('/grid') === time('/run') ? done(true) : setTimeout(look, 20);
  look();
})`;

/// In the page: what can be measured of how it looks, once it has drawn what it was told.
const kLooks = `new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => {
  const panel = document.getElementById('panel').getBoundingClientRect();
  const canvas = document.getElementById('map');
  const pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
  const box = [Infinity, Infinity, -Infinity, -Infinity];
  const colours = new Set();
  let drawn = 0;
  for (let at = 0; at < pixels.length; at += 4) {
    if (pixels[at + 3] === 0) continue;
    ++drawn;
    colours.add(pixels[at] << 16 | pixels[at + 1] << 8 | pixels[at + 2]);
    const x = at / 4 % canvas.width, y = Math.floor(at / 4 / canvas.width);
    box[0] = Math.min(box[0], x);
    box[1] = Math.min(box[1], y);
    box[2] = Math.max(box[2], x);
    box[3] = Math.max(box[3], y);
  }
  const ratio = canvas.width / canvas.clientWidth;
  const numbers = (colour) => colour.match(/[\\d.]+/g).map(Number);
  const light = (colour) => {
    const [r, g, b] = colour.slice(0, 3).map((value) => value / 255).map(
        (value) => value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const style = (element) => getComputedStyle(element);
  const ground = light(numbers(style(document.getElementById('panel')).backgroundColor));
  const texts = [...document.querySelectorAll('#panel *')].filter(
      (one) => one.children.length === 0 && one.textContent.trim());
  done({
    lang: document.documentElement.lang,
    texts: texts.map((one) => one.textContent),
    cut: texts.filter((one) => one.scrollWidth > one.clientWidth + 1 && one.clientWidth > 0)
             .map((one) => one.textContent),
    faint: texts.filter((one) => {
      const [a, b] = [ground, light(numbers(style(one).color))].sort((p, q) => q - p);
      return (a + 0.05) / (b + 0.05) < 4.5;
    }).map((one) => one.textContent),
    scrolls: document.documentElement.scrollWidth > innerWidth ||
             document.documentElement.scrollHeight > innerHeight,
    panel: [panel.left, panel.top, panel.right, panel.bottom],
    button: document.getElementById('whole').getBoundingClientRect().height,
    screen: [innerWidth, innerHeight],
    drawn, colours: colours.size, map: box.map((value) => value / ratio),
  });
})))`;

/// In the page: what it says of the delay, now and as after seven seconds without news, and how far
/// to the right it goes with a long name.
const kLater = `(() => {
  const words = () => ['delay-of', 'delay'].map((id) => document.getElementById(id).textContent);
  const now = words();
  lastTold = performance.now() - 7000;
  tellDelay();
  document.getElementById('name').textContent = 'Hitos: ' + 'tour'.repeat(50);
  return [now, words(), document.getElementById('panel').getBoundingClientRect().right];
})()`;

/// Of a page that shows the whole map.
function checkLooks(looks, words, name) {
  const [width, height] = looks.screen;
  expect(!looks.scrolls, `${name}: nothing to scroll`);
  expect(looks.cut.length === 0, `${name}: no cut words: ${looks.cut}`);
  expect(looks.faint.length === 0, `${name}: words of enough contrast: ${looks.faint}`);
  for (const word of [words.live, words.scans, words.whole])
    expect(looks.texts.includes(word), `${name}: "${word}" in ${looks.texts}`);
  const panel = looks.panel;
  expect(panel[0] >= 0 && panel[1] >= 0 && panel[2] <= width && panel[3] <= height,
         `${name}: the panel on the screen: ${panel}`);
  expect(looks.drawn > 1000 && looks.colours > 4, `${name}: a map, not ${looks.drawn} pixels`);
  const map = looks.map;
  expect(map[0] > 0 && map[1] > 0 && map[2] < width - 1 && map[3] < height - 1,
         `${name}: the whole map on the screen: ${map}`);
  expect(map[0] > panel[2] || map[1] > panel[3], `${name}: map ${map} beside the panel ${panel}`);
  const room = map[0] > panel[2] ? [width - panel[2], height] : [width, height - panel[3]];
  expect(Math.max((map[2] - map[0]) / room[0], (map[3] - map[1]) / room[1]) > 0.8,
         `${name}: the map ${map} as large as it may be`);
}

async function main(cli, log, out, pictures) {
  const browser = browsers.start();
  const run = await start(cli, out, ['--set', 'filter.particles=20']);
  try {
    const tour = parts(log, 2);
    const scans = tour[0].toString().split('\nLASER').length - 1;
    let fed = false;
    for (const [screen, metrics] of Object.entries(kScreens)) {
      for (const scheme of ['light', 'dark']) {
        for (const [language, words] of Object.entries(kWords)) {
          const name = `${screen}-${scheme}-${language}`;
          const page = await browser.open();
          await page.call('Emulation.setDeviceMetricsOverride', metrics);
          await page.call('Emulation.setTouchEmulationEnabled', {enabled: metrics.mobile});
          await page.call('Emulation.setEmulatedMedia',
                          {features: [{name: 'prefers-color-scheme', value: scheme}]});
          await page.call('Emulation.setUserAgentOverride',
                          {userAgent: 'Chromium', acceptLanguage: language});
          await page.navigate(`http://${run.host}/`);
          if (!fed) {
            await page.evaluate(stateIs(words.waiting));
            run.feed(tour[0]);
            fed = true;
          }
          // The robot stands still: what is known comes without any other scan, the grid last.
          await page.evaluate(stateIs(words.live));
          await page.evaluate(hasAll(scans));
          const looks = await page.evaluate(kLooks);
          if (pictures) {
            const {data} = await page.call('Page.captureScreenshot', {format: 'png'});
            fs.mkdirSync(pictures, {recursive: true});
            fs.writeFileSync(path.join(pictures, `${name}.png`), Buffer.from(data, 'base64'));
          }
          expect(looks.lang === language, `${name}: a page in ${language}, not ${looks.lang}`);
          checkLooks(looks, words, name);
          const [delay, standing, named] = await page.evaluate(kLater);
          expect(delay[0] === words.standing[0] ||
                     (delay[0] === words.delay[0] && words.delay[1].test(delay[1])),
                 `${name}: how late it is, not ${delay}`);
          expect(`${standing}` === `${words.standing}`,
                 `${name}: how long ago its picture was, not ${standing}`);
          expect(named <= metrics.width, `${name}: a long name on the screen, to ${named}`);
          expect(page.complaints.length === 0, `${name}: no complaints: ${page.complaints}`);
          for (const url of page.requests) {
            expect([`http://${run.host}/`, `ws://${run.host}/`, 'data:,'].includes(url),
                   `${name}: no request to ${url}`);
          }
          console.log(name, looks.drawn, 'pixels');
          if (screen === 'phone' && scheme === 'dark' && language === 'es') {
            run.feed(tour[1]);
            const ended = run.end();
            await page.evaluate(stateIs(words.over));
            const {status, said} = await ended;
            expect(status === 0, `hitos-cli to end well: ${said}`);
          }
          await page.close();
        }
      }
    }
  } finally {
    run.kill();
    await browser.end();
  }
}

main(...process.argv.slice(2)).catch((error) => {
  console.log(error.stack);
  process.exit(1);
});
