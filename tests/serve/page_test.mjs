// page_test.mjs ADDRESS - the drawing board in Chromium, by what the page shows. Prints TAP.
//
// PUPPETEER and AXE name the modules puppeteer-core and axe-core, CHROMIUM the browser.

import { readFileSync, mkdtempSync, readdirSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const { default: puppeteer } = await import(process.env.PUPPETEER);
const address = process.argv[2], room = process.argv[3];
const origin = new URL(address).origin;
const folder = mkdtempSync(join(tmpdir(), 'pepperpot-page-'));
let count = 0;
const wrong = [];

function check(name, holds, about = '') {
    console.log(`${holds ? 'ok' : 'not ok'} ${++count} - ${name}`);
    if (!holds && about !== '') console.log(`# ${JSON.stringify(about)}`);
}

const browser = await puppeteer.launch({ executablePath: process.env.CHROMIUM, args: ['--no-sandbox', '--disable-gpu'] });
const page = await browser.newPage();
page.on('console', (m) => m.type() === 'error' && wrong.push(`console: ${m.text()}`));
page.on('pageerror', (e) => wrong.push(`error: ${e.message}`));
page.on('request', (r) => /^(blob|data):/.test(r.url()) || r.url().startsWith(`${origin}/`) || wrong.push(`request: ${r.url()}`));
await page.setViewport({ width: 1440, height: 900 });
const client = await page.createCDPSession();
await client.send('Browser.setDownloadBehavior', { behavior: 'allow', downloadPath: folder, eventsEnabled: true });

const idle = () => page.waitForFunction(() => window.pepperpot && !window.pepperpot.isBusy() && document.querySelector('#plan .contour'), { timeout: 60000 });
const until = (test, ...values) => page.waitForFunction(test, { timeout: 60000 }, ...values).then(() => true, () => false);
const text = () => page.evaluate(() => window.pepperpot.board.text);
const attribute = (name, key, nth = 0) => page.evaluate((n, k, i) => window.pepperpot.board.elements.filter((e) => e.name === n)[i]?.attributes[k]?.value, name, key, nth);
const select = (name, nth = 0) => page.evaluate((n, i) => window.pepperpot.board.select(window.pepperpot.board.elements.filter((e) => e.name === n)[i].index), name, nth);
const tab = (name) => page.click(`#tab-${name}`);
// Elements are found and used in one step: the page draws anew between two, and puppeteer's $eval has two.
const average = () => page.evaluate(() => document.querySelector('#averages tbody tr:first-child td').textContent);
// The example comes from the server: wait until it has replaced the room.
async function example(name) {
    const former = await page.evaluateHandle((n) => { const s = document.getElementById('example'); s.value = n; s.dispatchEvent(new Event('change')); return window.pepperpot.board.variants; }, name);
    await page.waitForFunction((f) => window.pepperpot.board.variants !== f, { timeout: 60000 }, former);
}

const screens = [[1440, 900, 'light'], [1440, 900, 'dark'], [390, 844, 'light'], [390, 844, 'dark']];
async function shots(name) {
    for (const [width, height, scheme] of screens) {
        await page.setViewport({ width, height });
        await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: scheme }]);
        writeFileSync(join(process.env.SHOTS, `${name}-${width}-${scheme}.png`), await page.screenshot({ fullPage: true }));
    }
    await page.setViewport({ width: 1440, height: 900 });
}

async function drag(handle, dx, dy) {
    await idle();
    const reach = `[data-handle="${handle}"] .reach`;
    await page.waitForSelector(reach, { timeout: 20000 });
    const [x, y] = await page.evaluate((r) => { const b = document.querySelector(r).getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2]; }, reach);
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let i = 1; i <= 4; i++) await page.mouse.move(x + dx * i / 4, y + dy * i / 4);
    await page.mouse.up();
    await idle();
}

// ---- figures ----

await page.goto(address);
await idle();
check('the room of the command line is drawn', (await text()) === readFileSync(room, 'utf8'));
check('the average follows', await until(() => /\d/.test(document.querySelector('#averages tbody td')?.textContent ?? '')));
const answer = await page.evaluate(async (body) => (await fetch('/api/df', { method: 'POST', headers: { 'Content-Type': 'application/json' }, body })).json(), JSON.stringify({ room: await text() }));
check('and is that of df', Math.abs(parseFloat(await average()) - answer.average.df['exact+bre'].value) < 0.0051, await average());
check('simulated points stream in with errors', await until(() => /\u00b1/.test(document.querySelector('#points tbody td:last-child')?.textContent ?? '')));
check('the address has the room', await until(() => location.hash.startsWith('#room=')));

// ---- handles ----

const handles = [
    ['window', 'plan', 'plan right', 25, 0, 'width'], ['window', 'plan', 'plan left', 8, 0, 'left'], ['window', 'plan', 'plan middle', 20, 0, 'left'],
    ['window', 'section', 'section head', 0, 15, 'height'], ['window', 'section', 'section sill', 0, 10, 'sill'],
    ['window', 'elevation', 'elevation middle', -15, -5, 'left'], ['window', 'elevation', 'elevation left', -10, 0, 'left'], ['window', 'elevation', 'elevation right', -10, 0, 'width'],
    ['window', 'elevation', 'elevation sill', 0, 10, 'sill'], ['window', 'elevation', 'elevation head', 0, 10, 'height'],
    ['plan', 'plan', 'plan width', 20, 0, 'width'], ['plan', 'plan', 'plan depth', 0, -20, 'depth'], ['plan', 'section', 'section height', 0, -10, 'height'],
    ['skyline', 'section', 'section angle', 0, -15, 'angle'], ['working-plane', 'section', 'section plane', 0, -10, 'height'],
];
await example('office');
for (const [element, view, handle, dx, dy, name] of handles) {
    if (view !== 'plan') await tab(view);
    await select(element);
    const before = await attribute(element, name), comments = (await text()).match(/<!--[\s\S]*?-->/g).join('');
    try {
        await drag(handle, dx, dy);
        const after = await attribute(element, name), kept = (await text()).match(/<!--[\s\S]*?-->/g).join('') === comments;
        check(`handle "${handle}" of ${element} sets ${name}`, after !== before && kept, [before, after]);
    } catch (error) {
        check(`handle "${handle}" of ${element} sets ${name}`, false, error.message);
    }
}
const steps = parseFloat(await attribute('window', 'width'));
check('in steps of 5 cm', Math.abs(steps * 20 - Math.round(steps * 20)) < 1e-6, steps);

// The windows of this room are 0.6 m apart.
await example('office');
await idle();
await select('window');
await drag('plan right', 300, 0);
const [end, next] = [parseFloat(await attribute('window', 'left')) + parseFloat(await attribute('window', 'width')), parseFloat(await attribute('window', 'left', 1))];
check('an edge of a window stops at the next window', Math.abs(end - next) < 1e-6, [end, next]);
await select('plan');
await idle();
await page.evaluate(() => document.querySelector('[data-handle="plan width"]').scrollIntoView({ block: 'center' }));
const widthBefore = parseFloat(await attribute('plan', 'width'));
const perMetre = await page.evaluate((w) => document.querySelector('#plan .walls').getBBox().width / w, widthBefore);
await drag('plan width', perMetre, 0);
check('a wall follows the pointer while the room grows', Math.abs(parseFloat(await attribute('plan', 'width')) - widthBefore - 1) < 0.06, [widthBefore, await attribute('plan', 'width')]);

// ---- keys, typing, undo ----

await example('office');
await idle();
await select('window');
await idle();
const left = parseFloat(await attribute('window', 'left'));
await page.evaluate(() => document.querySelector('[data-handle="plan middle"]').focus());
await page.keyboard.press('ArrowRight');
await idle();
check('an arrow key moves it by 5 cm', Math.abs(Math.abs(parseFloat(await attribute('window', 'left')) - left) - 0.05) < 0.026, [left, await attribute('window', 'left')]);
check('and the handle keeps the focus', await page.evaluate(() => document.activeElement?.dataset.handle === 'plan middle'));
const before = await text();
await page.evaluate(() => { const e = document.getElementById('value-sill'); e.value = '1.1'; e.dispatchEvent(new Event('change')); });
await idle();
check('a typed value is taken', (await attribute('window', 'sill')) === '1.1');
const type = (name, value) => page.evaluate((n, v) => { const e = document.getElementById(`value-${n}`); e.value = v; e.dispatchEvent(new Event('change')); }, name, value);
for (const [written, metres] of [['1,15', '1.15'], ['90 cm', '0.9'], ['1050 mm', '1.05'], ['1.1 m', '1.1']]) {
    await type('sill', written);
    check(`"${written}" is ${metres} m`, (await attribute('window', 'sill')) === metres, await attribute('window', 'sill'));
}
await idle();
await page.focus('#value-sill');
await page.keyboard.down('Control');
await page.keyboard.press('z');
await page.keyboard.up('Control');
check('Ctrl-Z in a field that was not changed undoes the last change', (await attribute('window', 'sill')) === '1.05', await attribute('window', 'sill'));
for (let i = 0; i < 3; i++) await page.click('#undo');
check('four values are undone one by one', (await attribute('window', 'sill')) === '1.1');
await page.click('#undo');
check('undone', (await text()) === before);
await page.click('#redo');
check('and done again', (await attribute('window', 'sill')) === '1.1');
const parts = await page.evaluate(() => window.pepperpot.board.elements.length);
for (const kind of ['window', 'rooflight', 'block', 'point', 'skyline']) {
    await page.select('#add', kind);
    check(`a ${kind} is added and selected`, await page.evaluate((k) => window.pepperpot.board.element?.name === k, kind));
}
await idle();
check('nothing that was added overlaps another part', await page.evaluate(() => document.getElementById('status').hidden), await page.evaluate(() => document.getElementById('status').textContent));
check('a block shows the surroundings', await page.evaluate(() => document.getElementById('outside').getAttribute('aria-pressed') === 'true'));
await page.click('#outside');
await page.click('#delete');
await select('block');
await page.click('#copy');
check('a block is copied', await page.evaluate(() => window.pepperpot.board.elements.filter((e) => e.name === 'block').length === 2));
while (await page.evaluate((n) => window.pepperpot.board.elements.length > n, parts)) await page.click('#undo');
check('all of it is undone', (await attribute('window', 'sill')) === '1.1');

// ---- text, mistakes ----

await page.evaluate(() => window.pepperpot.board.change(window.pepperpot.board.text.replace('sill="1.1"', 'sill="high"'), { from: 'text' }));
check('a mistake is said', await until(() => !document.getElementById('status').hidden && /sill is "high"/.test(document.getElementById('status').textContent)));
check('and its field is marked', await until(() => document.getElementById('value-sill')?.getAttribute('aria-invalid') === 'true'));
await page.evaluate(() => window.pepperpot.board.select(-1));
await page.evaluate(() => window.pepperpot.board.change(window.pepperpot.board.text.replace('sill="high"', 'sill="higher"'), { from: 'text' }));
check('a button leads to the part with the mistake', await until(() => document.querySelector('#status button')));
await page.evaluate(() => document.querySelector('#status button').click());
check('which is the window', (await page.evaluate(() => window.pepperpot.board.element?.name)) === 'window');
await page.click('#undo');
await tab('text');
check('and listed with its place', await until(() => /Line \d+, column \d+: window: sill/.test(document.getElementById('mistakes').textContent)));
check('the editor is there', await page.evaluate(() => Boolean(document.querySelector('#editor > div')?.shadowRoot?.querySelector('.cm-content') ?? document.getElementById('text'))));
if (process.env.SHOTS) await shots('text');
await tab('drawing');
check('the former drawing is dimmed', await page.evaluate(() => getComputedStyle(document.getElementById('lower')).opacity < 0.6));
await page.click('#undo');
check('undo takes the mistake back', await until(() => document.getElementById('status').hidden), await page.evaluate(() => document.getElementById('status').textContent));

// ---- files ----

const drop = (name, content) => page.evaluate((n, c) => {
    const data = new DataTransfer();
    data.items.add(new File([c], n));
    document.dispatchEvent(new DragEvent('drop', { dataTransfer: data, cancelable: true }));
}, name, content);
await drop('odd.xml', '<room version="1" name="&lt;script&gt;alert(1)&lt;/script&gt;"><plan width="3" depth="4" height="2.5"/><window wall="south" left="1" sill="1" width="1" height="1"/></room>');
check('a dropped room opens, and its name is only text', await until(() => document.title.startsWith('<script>')) && !(await page.$('main script')));
await drop('millimetres.xml', '<room version="1" units="mm" name="In mm"><plan width="4000" depth="5000" height="2500"/><window wall="south" left="1000" sill="900" width="1500" height="1200"/></room>');
await until(() => document.title.startsWith('In mm'));
await idle();
await select('window');
check('a file in millimetres has fields in mm', await until(() => document.querySelector('#values .unit')?.textContent === 'mm'));
await drag('plan right', 40, 0);
const wider = parseFloat(await attribute('window', 'width'));
check('and a drag sets millimetres, in steps of 5 cm', wider > 1700 && wider < 3000 && Math.abs(wider / 50 - Math.round(wider / 50)) < 1e-6, wider);
await page.select('#add', 'window');
await idle();
check('a new window is in millimetres, too', parseFloat(await attribute('window', 'width', 1)) >= 500 && await page.evaluate(() => document.getElementById('status').hidden), await text());
await drop('bare.xml', '<room version="1" name="Bare"><plan width="3" depth="4" height="2.5"/></room>');
await until(() => document.title.startsWith('Bare'));
check('a room without windows has no light', await until(() => /no light/.test(document.getElementById('trace-state').textContent)), await page.evaluate(() => document.getElementById('trace-state').textContent));
for (let i = 0; i < 5; i++) {
    await page.select('#add', 'window');
    await idle();
    await page.click('#copy');
    await idle();
}
check('ten new and copied windows are side by side, in several walls', await page.evaluate(() => document.getElementById('status').hidden && new Set(window.pepperpot.board.elements.filter((e) => e.name === 'window').map((e) => e.attributes.wall.value)).size > 1), await text());
await drop('rooflight.xml', '<room version="1" name="Studio"><plan width="5" depth="8" height="3"/><rooflight x="2" y="3" width="1" depth="1"/><window wall="north" left="1" sill="0.9" width="1.5" height="1.5"/><point x="2" y="2"/></room>');
await until(() => document.title.startsWith('Studio'));
check('a room with a rooflight has hand figures, and a curve of the method that covers it', await until(() => /split-flux/.test(document.querySelector('#points thead')?.textContent ?? '') && /\d/.test(document.querySelector('#points tbody td')?.textContent ?? '') && document.querySelector('#lower .curve path')));
await drop('odd.xml', '<room version="1" name="&lt;script&gt;alert(1)&lt;/script&gt;"><plan width="3" depth="4" height="2.5"/><window wall="south" left="1" sill="1" width="1" height="1"/></room>');
await until(() => document.title.startsWith('<script>'));
await drop('house.obj', 'v 1 1 0\nv 2 1 0\nv 2 1 1\nf 1 2 3\n');
check('OBJ becomes surfaces', await until(() => window.pepperpot.board.elements.some((e) => e.name === 'surface')));
await drop('nothing.txt', 'hello');
check('another file is refused', await until(() => /not a room file/.test(document.getElementById('message').textContent)));
await page.select('#download', 'room');
const saved = await (async () => {
    for (let i = 0; i < 50; i++) {
        const file = readdirSync(folder).find((f) => f.endsWith('.xml'));
        // Chromium reserves the name by an empty file, and replaces that by the complete one.
        const content = file ? readFileSync(join(folder, file), 'utf8') : '';
        if (content) return content;
        await new Promise((done) => setTimeout(done, 100));
    }
    return null;
})();
check('the room downloads as it is', saved === await text());

// ---- simulation, variants, tabs ----

await example('deep-office');
await idle();
await page.select('#trace-error', '0.5');
check('a simulation runs', await until(() => document.getElementById('trace-button').textContent === 'Stop'));
await page.click('#trace-button');
check('and stops', await until(() => document.getElementById('trace-button').textContent === 'Simulate'));
await page.evaluate(() => scrollTo(0, 0));
const inside = await page.evaluate(() => { const b = document.querySelector('#plan .walls').getBoundingClientRect(); return [b.x + 0.3 * b.width, b.y + 0.55 * b.height]; });
await page.mouse.click(...inside);
const kept = await page.evaluate(() => window.pepperpot.board.pointer);
await page.mouse.move(inside[0] + 60, inside[1] + 20);
check('a click keeps the position whose figures are shown', await page.evaluate((k) => window.pepperpot.board.pointer.join() === k.join() && Boolean(document.querySelector('#plan .place.kept path')), kept));
await page.type('#place-text', '1.5, 2');
await page.evaluate(() => document.querySelector('#place button').click());
check('components at a place are shown by opening', await until(() => /Window, south/.test(document.getElementById('point-figures').textContent)));
await page.select('#trace-error', '5');
await until(() => /^Simulated:/.test(document.getElementById('trace-state').textContent));
await page.click('#compare');
check('a second variant stands beside the first', await until(() => document.querySelectorAll('#averages thead th').length === 3));
check('with its plan', await until(() => document.querySelectorAll('#other-plan .contour').length > 3));
const unchanged = await page.evaluate(() => document.querySelector('#averages tbody td:nth-child(2)').textContent);
await page.evaluate(() => { const { board } = window.pepperpot; board.change(board.text.replace(/(<window [^>]*width=")[^"]*/, '$11')); });
check('the variants have different averages, the simulated ones, too', await until((u) => {
    const values = (row) => [...row.querySelectorAll('td')].map((d) => parseFloat(d.textContent));
    const rows = [...document.querySelectorAll('#averages tbody tr')], first = values(rows[0]), last = values(rows[rows.length - 1]);
    return first[0] === parseFloat(u) && first[1] < first[0] && last[1] < last[0];
}, unchanged));
if (process.env.SHOTS) await shots('compare');
await page.click('#compare');
await tab('criteria');
check('criteria are judged', await until(() => /no-sky line/i.test(document.getElementById('criteria').textContent)));
check('and changes that would help are listed', await until(() => /What would help/.test(document.getElementById('criteria').textContent)));
if (process.env.SHOTS) await shots('criteria');
await tab('sheets');
check('a sheet is drawn', await until(() => document.querySelector('#sheet img')?.naturalWidth > 0));
await page.click('#sheet-enlarge');
check('and enlarged', await page.evaluate(() => document.getElementById('sheet-dialog').open && document.querySelector('#large-sheet img').getBoundingClientRect().width > 800));
if (process.env.SHOTS) await shots('sheet');
await page.keyboard.press('Escape');
await tab('axon');
check('the axonometric view is drawn', await until(() => document.querySelectorAll('#lower .face').length > 2));

// ---- a year ----

await tab('year');
check('without a weather file the year says what it needs', await page.evaluate(() => /weather file/.test(document.getElementById('year-weather').textContent) && document.getElementById('year-button').disabled));
await tab('figures');
await page.evaluate((n) => { document.getElementById('year-error').value = n; }, '5');
await drop('year.epw', readFileSync(process.argv[4], 'utf8'));
check('a dropped weather file opens the year', await until(() => !document.getElementById('panel-year').hidden && /Brussels/.test(document.getElementById('year-weather').textContent)));
check('its first map comes before the last', await until(() => /Simulating mean.*largest error/.test(document.getElementById('year-state').textContent) && document.getElementById('year-map').width === 365));
check('and then the whole', await until(() => /^Simulated mean/.test(document.getElementById('year-state').textContent)));
check('with a legend in lux and a table of the months', await page.evaluate(() => document.querySelectorAll('#year-legend .swatch').length === 9 && document.querySelectorAll('#year-months tbody tr').length === 12));
// Clear from 9 to 16 h: noon is lit and midnight dark, in the picture and in its values as text.
const colours = await page.evaluate(() => {
    const canvas = document.getElementById('year-map'), at = (slot) => [...canvas.getContext('2d').getImageData(171, 23 - slot, 1, 1).data].join();
    return [at(12), at(0)];
});
check('noon and midnight have different colours', colours[0] !== colours[1], colours);
await page.focus('#year-map');
await page.keyboard.press('ArrowRight');
check('an arrow key reads an hour', await until(() => /^\d+ June, 12:00 to 13:00: \d+ lx$/.test(document.getElementById('year-hour').textContent)), await page.evaluate(() => document.getElementById('year-hour').textContent));
const share = await page.evaluate(() => document.querySelector('#year-figures dd').textContent);
check('figures have their errors and units', /^[\d.]+( \u00b1 [\d.]+)? %$/.test(share), share);
await page.evaluate(() => { window.pepperpot.board.pointer = [1.5, 2]; });
await page.select('#year-of', 'pointer');
check('the position under the pointer has its own map', await until(() => /^Simulated at 1.5, 2 m/.test(document.getElementById('year-state').textContent)));
await page.select('#year-error', '1');
await until(() => document.getElementById('year-button').textContent === 'Stop');
await page.click('#year-button');
check('the year stops', await until(() => document.getElementById('year-state').textContent === 'Stopped' && document.getElementById('year-button').textContent === 'Simulate'));
if (process.env.SHOTS) await shots('year');
await tab('sheets');
check('the chart of availability uses the weather file, too', await until(() => document.getElementById('sheet-kind').value === 'availability' && document.querySelector('#sheet img')?.naturalWidth > 0));

// ---- roofs and blinds ----

await example('office');
await idle();
await select('plan');
await page.evaluate(() => { const e = document.getElementById('value-roof'); e.value = 'gable'; e.dispatchEvent(new Event('change')); });
await idle();
check('a roof gets a pitch', (await attribute('plan', 'pitch')) === '30');
await tab('section');
await drag('section pitch', 0, -12);
check('whose handle sets it', Number(await attribute('plan', 'pitch')) > 30, await attribute('plan', 'pitch'));
await page.evaluate(() => { const e = document.getElementById('value-roof'); e.value = 'flat'; e.dispatchEvent(new Event('change')); });
check('a flat roof has none', (await attribute('plan', 'pitch')) === undefined);
await page.select('#add', 'blind');
await until(() => window.pepperpot.board.element?.name === 'blind' && document.getElementById('value-angle'));
await page.focus('#value-angle');
await page.keyboard.press('ArrowUp');
check('an arrow key turns the slats of a blind by a degree', (await attribute('blind', 'angle')) === '1', await attribute('blind', 'angle'));

// ---- for everybody ----

if (process.env.AXE) {
    await page.evaluate(readFileSync(process.env.AXE, 'utf8'));
    for (const [name, scheme] of [['figures', 'light'], ['criteria', 'dark'], ['sheets', 'light'], ['year', 'dark'], ['pictures', 'light'], ['axon', 'dark'], ['text', 'dark']]) {
        await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: scheme }]);
        await tab(name);
        const found = await page.evaluate(async () => (await window.axe.run()).violations.filter((v) => ['serious', 'critical'].includes(v.impact)).map((v) => `${v.id}: ${v.nodes[0].html}`));
        check(`axe-core finds nothing serious: ${name}, ${scheme}`, found.length === 0, found);
    }
    await tab('drawing');
}
await tab('year');
for (const [width, height, scheme] of screens) {
    await page.setViewport({ width, height });
    await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: scheme }]);
    check(`nothing is wider than ${width} px, ${scheme}`, await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), await page.evaluate(() => document.documentElement.scrollWidth));
    if (process.env.SHOTS) writeFileSync(join(process.env.SHOTS, `board-${width}-${scheme}.png`), await page.screenshot({ fullPage: true }));
}
// Requests with a mistake are answered by status 422, which the browser writes to its console.
const rest = wrong.filter((w) => !/status of 422/.test(w));
check('no error in the console and no request elsewhere', rest.length === 0, rest);
await browser.close();
console.log(`1..${count}`);
