// bench_page.mjs ADDRESS - the drawing board in headless Chromium: times from a pointer event to the
// updated contours while a window is dragged, and to simulated values after the hand rests, in
// milliseconds of one run. PUPPETEER names the module puppeteer-core, CHROMIUM the browser.

const { default: puppeteer } = await import(process.env.PUPPETEER);
const address = process.argv[2], MOVES = Number(process.env.MOVES ?? 40);
const rooms = process.env.ROOMS?.split(' ') ?? ['deep-office', 'deep-office-obstructed', 'office', 'classroom', 'l-shaped', 'studio', 'workshop'];

const browser = await puppeteer.launch({ executablePath: process.env.CHROMIUM, args: ['--no-sandbox', '--disable-gpu'] });
const page = await browser.newPage();
await page.setViewport({ width: 1440, height: 900 });
await page.goto(address);
const settled = () => page.waitForFunction(() => window.pepperpot && !window.pepperpot.isBusy() && document.querySelector('#plan .contour'), { timeout: 60000 });
await settled();

async function open(name) {
    const former = await page.evaluateHandle((n) => { const s = document.getElementById('example'); s.value = n; s.dispatchEvent(new Event('change')); return window.pepperpot.board.variants; }, name);
    await page.waitForFunction((f) => window.pepperpot.board.variants !== f, {}, former);
    await settled();
}

// Simulation when the hand rests, on or off: while a real hand drags, its events come too fast for it.
const live = (on) => page.evaluate((o) => { const box = document.getElementById('trace-live'); if (box.checked !== o) box.click(); }, on);

// Drags the handle by steps of 5 cm or more, each when the contours of the former one are drawn.
// Returns the times of each: total, and of server, transfer, drawing.
async function drag() {
    await page.evaluate(() => { const { board } = window.pepperpot; board.select(board.elements.find((e) => e.name === 'window').index); });
    await page.waitForSelector('[data-handle="plan right"] .reach');
    await settled();
    const [x, y] = await page.evaluate(() => { const b = document.querySelector('[data-handle="plan right"] .reach').getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2]; });
    return page.evaluate(async (px, py, moves) => {
        const plan = document.getElementById('plan'), times = [];
        const isAcross = document.querySelector('[data-handle="plan right"]').classList.contains('y');
        const send = (type, by) => plan.dispatchEvent(new PointerEvent(type, { bubbles: true, button: 0, pointerId: 1, clientX: px + (isAcross ? 0 : by), clientY: py + (isAcross ? by : 0) }));
        plan.setPointerCapture = () => {};
        document.querySelector('[data-handle="plan right"] .reach').dispatchEvent(new PointerEvent('pointerdown', { bubbles: true, button: 0, pointerId: 1, clientX: px, clientY: py }));
        for (let i = 0; i < moves; i++) {
            performance.clearResourceTimings();
            const { board, timings } = window.pepperpot;
            const former = board.results.plan, count = timings.length, text = board.text, from = performance.now();
            send('pointermove', i % 2 ? 0 : -14);
            if (board.text === text) continue;
            while (board.results.plan === former && !board.results.error) await new Promise((done) => setTimeout(done, 0));
            await new Promise((done) => requestAnimationFrame(() => setTimeout(done, 0)));
            const total = performance.now() - from;
            if (board.results.error) continue;
            while (window.pepperpot.isBusy()) await new Promise((done) => setTimeout(done, 1));
            const asked = performance.getEntriesByType('resource').filter((e) => e.startTime >= from && /api\/(plan|df)/.test(e.name));
            times.push({ total, server: Math.max(...asked.map((e) => e.responseStart - e.requestStart)), transfer: Math.max(...asked.map((e) => e.responseEnd - e.responseStart)), drawn: timings[count].drawn });
        }
        send('pointerup', 0);
        return times;
    }, x, y, MOVES);
}

// After the hand rests: times until the first estimate, and until every point is known to 1 %.
async function rest() {
    return page.evaluate(async () => {
        const { board } = window.pepperpot;
        await new Promise((done) => setTimeout(done, 300));
        const from = performance.now(), times = {};
        const ended = new Promise((done) => board.addEventListener('results', (event) => {
            if (!('trace' in event.detail) || !event.detail.trace) return;
            times.first ??= performance.now() - from;
            if (event.detail.trace.isDone) done();
        }));
        const element = board.elements.find((e) => e.name === 'window');
        const width = String(Number((parseFloat(element.attributes.width.value) - 0.01).toFixed(3)));
        board.change(window.pepperpot.setAttributes(board.text, element, { width }));
        await Promise.race([ended, new Promise((done) => setTimeout(done, 20000))]);
        times.all = performance.now() - from;
        return times;
    });
}

const at = (list, share) => [...list].sort((a, b) => a - b)[Math.min(list.length - 1, Math.floor(share * list.length))];
const all = [];
console.log('room                     drag: median  95 %   server  transfer  drawing   simulated: first  to 1 %');
for (const name of rooms) {
    await open(name);
    await live(false);
    const times = await drag();
    await live(true);
    const rested = await rest();
    all.push(...times.map((t) => t.total));
    const median = (key) => (at(times.map((t) => t[key]), 0.5) ?? NaN).toFixed(0).padStart(7);
    console.log(`${name.padEnd(26)}${median('total')}${at(times.map((t) => t.total), 0.95).toFixed(0).padStart(9)}${median('server')}${median('transfer').padStart(9)}${median('drawn').padStart(9)}${(rested.first ?? NaN).toFixed(0).padStart(17)}${rested.all.toFixed(0).padStart(8)}`);
}
console.log(`all rooms                 ${at(all, 0.5).toFixed(0).padStart(7)}${at(all, 0.95).toFixed(0).padStart(9)}`);
await browser.close();
