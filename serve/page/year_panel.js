// year_panel.js - the temporal map: illuminances by hour and day from a weather file, simulated by
// the engine, coarse at first; of the mean of the room's points, or of the position under the
// pointer; with a legend, the figures of the year and a table by month.

import { board } from './board.js';
import { engine } from './engine.js';
import { $, h, figure, replaceChildren } from './dom.js';

const MONTHS = ['January', 'February', 'March', 'April', 'May', 'June', 'July', 'August', 'September', 'October', 'November', 'December'];
// Lower limits of the classes, lx. Class 0 is the dark; limits of useful daylight are among them.
const LIMITS = [1, 100, 300, 500, 1000, 2000, 3000, 10000];
const LABELS = ['below 1', '1', '100', '300', '500', '1000', '2000', '3000', '10 000 lx and more'];
const REST_MS = 400;

let weather = null, running = null, shown = null, cursor = null, restTimer = 0;

const isOpen = () => !$('panel-year').hidden;
const isAtPointer = () => $('year-of').value === 'pointer';
export const isRunningYear = () => running !== null;

// Illuminance as text: two digits if the error is above 3 %, otherwise three.
function lux(value) {
    if (value === null || value === undefined || !Number.isFinite(value)) return 'not known';
    return `${Number(value.toPrecision(shown.error > 3 ? 2 : 3))} lx`;
}

// The hours of the answer as days of slots: { days: [[month, day]], slots, at(day, slot) }.
function arrange(hourly, values) {
    const days = [];
    for (let i = 0; i < values.length; i++) {
        const last = days[days.length - 1];
        if (!last || last.month !== hourly.month[i] || last.day !== hourly.day[i]) days.push({ month: hourly.month[i], day: hourly.day[i], from: i });
    }
    const slots = Math.round(values.length / days.length);
    return { days, slots, length: 24 / slots, at: (day, slot) => values[days[day].from + slot] };
}

function classOf(value) {
    return LIMITS.filter((limit) => value >= limit).length;
}

// ---- the map ----

function drawMap() {
    const canvas = $('year-map');
    canvas.hidden = !shown;
    $('year-axes').hidden = !shown;
    if (!shown) return;
    const { days, slots, at } = shown.map;
    const style = getComputedStyle(document.documentElement);
    const colours = LABELS.map((_, i) => style.getPropertyValue(`--band-${i}`).trim());
    canvas.width = days.length;
    canvas.height = slots;
    const drawing = canvas.getContext('2d');
    for (let day = 0; day < days.length; day++)
        for (let slot = 0; slot < slots; slot++) {
            const value = at(day, slot);
            if (value === null || value === undefined) continue;
            drawing.fillStyle = colours[classOf(value)];
            drawing.fillRect(day, slots - 1 - slot, 1, 1);
        }
    canvas.setAttribute('aria-label', `Illuminance by hour and day, ${shown.about}. Arrow keys read single hours; the table below has the months.`);
}

function readHour() {
    const box = $('year-hour');
    if (!shown || !cursor) {
        box.textContent = shown ? 'Point at the map, or use the arrow keys in it, to read an hour.' : '';
        return;
    }
    const { days, length, at } = shown.map;
    const { month, day } = days[cursor.day];
    const time = (t) => `${Math.floor(t)}:${String(Math.round(60 * (t % 1))).padStart(2, '0')}`;
    box.textContent = `${day} ${MONTHS[month - 1]}, ${time(cursor.slot * length)} to ${time((cursor.slot + 1) * length)}: ${lux(at(cursor.day, cursor.slot))}`;
}

function moveCursor(day, slot) {
    const { days, slots } = shown.map;
    const within = (value, count) => Math.min(Math.max(0, value), count - 1);
    cursor = { day: within(day, days.length), slot: within(slot, slots) };
    readHour();
}

// ---- figures ----

function pairOf(found) {
    return found && Number.isFinite(found.value) ? figure(found.value, found.se || null) : '\u2013';
}

function drawFigures() {
    if (!shown) {
        replaceChildren($('year-figures'));
        return;
    }
    const { annual, hourly, values } = shown;
    const a = annual.average, row = (name, found, unit) => found && h('div', {}, h('dt', {}, name), h('dd', {}, `${pairOf(found)} ${unit}`));
    const months = MONTHS.map((name, m) => {
        let hours = 0, light = 0, enough = 0;
        for (let i = 0; i < values.length; i++) {
            if (hourly.month[i] !== m + 1 || !Number.isFinite(values[i])) continue;
            hours += hourly.occupied_h[i];
            light += hourly.occupied_h[i] * values[i];
            if (values[i] >= 300) enough += hourly.occupied_h[i];
        }
        return h('tr', {}, h('th', { scope: 'row' }, name), h('td', {}, hours > 0 ? lux(light / hours) : '\u2013'),
            h('td', {}, hours > 0 ? `${(100 * enough / hours).toFixed(0)} %` : '\u2013'));
    });
    replaceChildren($('year-figures'),
        h('dl', {}, row('Occupied hours with 300 lx or more', a.da300, '%'), row('Occupied hours with 100 to 3000 lx', sumOf(a['udi-low'], a['udi-good']), '%'),
            row('Mean illuminance in occupied hours', a['mean-lux'], 'lx'), row('Points with 300 lx in half of the hours', annual.grid && annual.plane?.['da300/50-area'], '%')),
        h('p', { class: 'note' }, `Occupied: ${annual.hours}. Blinds are open.`),
        h('table', { id: 'year-months' }, h('caption', {}, `Occupied hours by month, ${shown.about}`),
            h('thead', {}, h('tr', {}, ['Month', 'mean', '300 lx or more'].map((t) => h('th', { scope: 'col' }, t)))), h('tbody', {}, months)),
        annual.warnings.map((w) => h('p', { class: 'note' }, `Warning: ${w}.`)));
}

// Sum of both shares. Their errors are not independent, so the larger one is shown.
function sumOf(a, b) {
    return a && b && { value: a.value + b.value, se: Math.max(a.se, b.se) };
}

function draw() {
    drawMap();
    readHour();
    drawFigures();
}

function tellState(sentence) {
    $('year-state').textContent = sentence;
    $('year-button').textContent = running ? 'Stop' : 'Simulate';
    $('year-button').disabled = !weather;
}

// ---- the stream ----

function show(data, about) {
    const { annual } = data, { hourly } = annual, values = hourly.average_lux;
    shown = { annual, hourly, values, map: arrange(hourly, values), about, error: data.error };
    $('year-progress').value = data.progress;
    draw();
}

function optionsOf() {
    const options = { weather: weather.hash, error: Number($('year-error').value), ...board.roomOption };
    if (isAtPointer()) options.points = [board.pointer.map((c) => Number(c.toFixed(2)))];
    return options;
}

export function stopYear(why = 'Stopped') {
    if (!running) return;
    running.abort();
    running = null;
    tellState(why);
}

export async function startYear() {
    stopYear();
    if (!weather || !board.text) return;
    if (isAtPointer() && !board.pointer) {
        tellState('Click a position on the plan, or enter one under Figures.');
        return;
    }
    const own = running = new AbortController();
    const options = optionsOf();
    const about = options.points ? `at ${options.points[0].join(', ')} m` : 'mean of the points of the room';
    let last = null;
    $('year-progress').value = 0;
    tellState('Simulating: no result yet');
    try {
        for await (const { event, data } of engine.annual(board.text, options, own.signal)) {
            if (own !== running) return;
            if (event !== 'estimate') continue;
            last = data;
            show(data, about);
            tellState(`Simulating ${about}: largest error ${figure(data.error)} % of the annual light`);
        }
        if (own !== running) return;
        running = null;
        tellState(last ? `Simulated ${about}: largest error ${figure(last.error)} % of the annual light, with ${last.paths} paths` : 'There is no result.');
    } catch (error) {
        if (own !== running) return;
        running = null;
        tellState(error.message);
    }
}

function startAtRest() {
    clearTimeout(restTimer);
    restTimer = setTimeout(() => { if (isOpen()) startYear(); }, REST_MS);
}

// Sets the weather file of the year, and opens the tab.
export function useYearWeather(found) {
    weather = found;
    $('year-weather').textContent = `Weather: ${found.place}`;
    $('tab-year').click();
}

export function setUpYear() {
    replaceChildren($('year-legend'), LABELS.map((label, i) => h('span', { class: 'pair' }, h('span', { class: `swatch swatch-${i}` }), label)));
    const canvas = $('year-map');
    canvas.addEventListener('pointermove', (event) => {
        if (!shown) return;
        const box = canvas.getBoundingClientRect();
        moveCursor(Math.floor((event.clientX - box.left) / box.width * shown.map.days.length),
            shown.map.slots - 1 - Math.floor((event.clientY - box.top) / box.height * shown.map.slots));
    });
    canvas.addEventListener('keydown', (event) => {
        const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1], PageUp: [-30, 0], PageDown: [30, 0] }[event.key];
        if (!shown || !step) return;
        const from = cursor ?? { day: 171, slot: Math.floor(shown.map.slots / 2) };
        moveCursor(from.day + step[0], from.slot + step[1]);
        event.preventDefault();
    });
    $('year-button').addEventListener('click', () => (running ? stopYear() : startYear()));
    $('year-open').addEventListener('click', () => $('file').click());
    for (const id of ['year-of', 'year-error']) $(id).addEventListener('change', startYear);
    board.on('text', () => {
        stopYear('The room has changed.');
        shown = null;
        draw();
    });
    board.on('rested', () => { if (isOpen() && !running && !shown) startYear(); });
    board.on('tab', () => { if (!isOpen()) stopYear(); else if (!shown && !running) startYear(); });
    board.on('pointer', () => { if (isOpen() && isAtPointer() && board.isPointerKept) startAtRest(); });
    // The colours of the map are those of the theme.
    new MutationObserver(drawMap).observe(document.documentElement, { attributes: true, attributeFilter: ['data-theme'] });
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', drawMap);
    tellState('');
}
