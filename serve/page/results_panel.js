// results_panel.js - figures: averages by method and simulated, of both variants; the points; and
// the components by opening at the place under the pointer.

import { board } from './board.js';
import { $, h, figure, replaceChildren } from './dom.js';
import { KINDS, labelOf } from './kinds.js';
import { partAt } from './room_text.js';
import { isTracing, startTrace, stopTrace, switches } from './live.js';

let methods = []; // of the engine: { name, summary }

function valueRow(label, values, note) {
    return h('tr', {}, h('th', { scope: 'row' }, label), values.map((v) => h('td', {}, v)), note !== undefined && h('td', { class: 'note' }, note));
}

function averageOf(df, name) {
    return df?.average?.df?.[name]?.value ?? null;
}

function drawAverages() {
    const all = board.results.all ?? [board.results.df];
    const shown = board.variants.map((_, i) => all[i]);
    // A method that does not cover the room has no average.
    const names = [...new Set(shown.flatMap((df) => Object.keys(df?.average?.df ?? {}).filter((name) => averageOf(df, name) !== null)))];
    const head = h('tr', {}, h('th', { scope: 'col' }, 'Average daylight factor'), board.variants.map((_, i) => h('th', { scope: 'col' }, board.variants.length > 1 ? `${'AB'[i]}, %` : '%')));
    const rows = names.map((name) => valueRow(name, shown.map((df) => df?.error ? 'error' : figure(averageOf(df, name)))));
    rows.push(valueRow('simulated', board.variants.map((v) => v.simulated?.text === v.text && v.simulated.room === board.roomName ? figure(...v.simulated.average) : '\u2013')));
    replaceChildren($('averages'), h('thead', {}, head), h('tbody', {}, rows));
    drawMethods(names);
}

// Explains the methods in the table of averages.
function drawMethods(names) {
    const parts = [...new Set(names.flatMap((name) => name.split('+')))].map((name) => methods.find((m) => m.name === name)).filter(Boolean);
    replaceChildren($('method-notes'), h('summary', {}, 'About these methods'),
        h('p', { class: 'note' }, 'Hand methods approximate. The simulated value is accurate to within its standard error, the number after \u00b1.'),
        h('ul', { class: 'note' }, parts.map((m) => h('li', {}, h('b', {}, m.name), `: ${m.summary}`))));
}

function drawPlanFigures() {
    const { plan, why, error } = board.results;
    const box = $('plan-figures');
    if (error || !plan) {
        replaceChildren(box, !error && why && h('p', { class: 'note' }, `No contours: ${why}. The drawing shows the simulated values at the points instead.`));
        return;
    }
    replaceChildren(box, h('dl', {},
        h('div', {}, h('dt', {}, `Contours by ${plan.method}`), h('dd', {}, `${figure(plan.lowest.value)} to ${figure(plan.highest.value)} %`)),
        h('div', {}, h('dt', {}, 'Working plane with a view of the sky'), h('dd', {}, `${plan['sky-share'].toFixed(plan['sky-share'] > 99.95 ? 0 : 1)} %`))),
        plan.note && h('p', { class: 'note' }, plan.note));
}

function errors(trace) {
    return Number.isFinite(trace?.error) ? `standard errors up to ${Number(trace.error.toPrecision(2))} % of the value` : isTracing() ? 'no result yet' : 'no light at the points';
}

function drawTrace() {
    const { trace, traceError, scene, df } = board.results;
    $('trace-progress').value = trace?.progress ?? 0;
    $('trace-state').textContent = traceError || (isTracing() ? `Simulating: ${errors(trace)}` : trace?.isDone ? `Simulated: ${errors(trace)}` : 'Not simulated');
    $('trace-button').textContent = isTracing() ? 'Stop' : 'Simulate';
    if (!scene) return;
    const hand = df && !df.error ? df.points : [];
    // The first method that covers the room.
    const names = Object.keys(hand[0]?.df ?? {});
    const name = names.find((n) => hand.some((p) => Number.isFinite(p.df[n]?.value))) ?? names[0];
    const rows = scene.points.map((p, i) => h('tr', {}, h('th', { scope: 'row' }, `${p.x.toFixed(2)}, ${p.y.toFixed(2)}`),
        h('td', {}, figure(hand[i]?.df?.[name]?.value ?? null)), h('td', {}, trace?.points[i] ? figure(trace.points[i][0], trace.points[i][1]) : '\u2013')));
    replaceChildren($('points'), h('thead', {}, h('tr', {}, h('th', { scope: 'col' }, 'Point, m'), h('th', { scope: 'col' }, name ? `${name}, %` : 'by hand, %'), h('th', { scope: 'col' }, 'simulated, %'))),
        h('tbody', {}, rows.slice(0, 400)));
}

// Values of the steps that end an opening's sum, by the opening's line. With several openings the
// symbols are numbered.
function byOpening(reading, symbol) {
    const found = new Map();
    for (const step of reading?.steps ?? []) if (step.symbol.replace(/_\d+$/, '') === symbol && step.opening) found.set(step.opening, step.value);
    return found;
}

function openingName(line) {
    const element = board.elements.find((e) => e.line === line && ['window', 'rooflight', 'opening'].includes(e.name));
    return element ? labelOf(element) : `Opening, line ${line}`;
}

function drawPoint() {
    const { point, pointError } = board.results;
    const box = $('point-figures');
    const found = point?.points?.[0];
    if (!found) {
        replaceChildren(box, h('p', { class: 'hint' }, pointError || 'Point at the plan to see the components there. Click to keep a position, or enter it; Esc releases it.'));
        return;
    }
    const first = (part) => Object.values(found[part] ?? {})[0];
    const [sc, erc, irc, df] = ['sc', 'erc', 'irc', 'df'].map(first);
    const sky = byOpening(sc, 'SC'), external = byOpening(erc, 'ERC'), internal = byOpening(irc, 'IRC');
    const lines = [...new Set([...sky.keys(), ...external.keys(), ...internal.keys()])].sort((a, b) => a - b);
    replaceChildren(box, h('table', {},
        h('caption', {}, `At ${found.x.toFixed(2)}, ${found.y.toFixed(2)} m, ${found.z.toFixed(2)} m high, by ${Object.keys(found.df)[0]}`),
        h('thead', {}, h('tr', {}, ['Opening', 'Sky, %', 'Outside, %', 'Inside, %'].map((t) => h('th', { scope: 'col' }, t)))),
        h('tbody', {}, lines.map((line) => valueRow(openingName(line), [[sky, sc], [external, erc], [internal, irc]].map(([m, all]) => figure(Number.isFinite(all?.value) ? m.get(line) ?? 0 : null)))),
            h('tr', { class: 'sum' }, h('th', { scope: 'row' }, Number.isFinite(df?.value) ? `Daylight factor ${figure(df.value)} %` : 'No daylight factor by this method'), [sc, erc, irc].map((r) => h('td', {}, figure(r?.value ?? null)))))));
}

function drawMistakes() {
    const { mistakes, error } = board.results;
    const part = error && mistakes.length ? partAt(board.text, board.elements, mistakes[0].line, mistakes[0].column)?.element : null;
    replaceChildren($('status'), error && [`${mistakes.length > 1 ? `${mistakes.length} mistakes. ` : ''}${mistakes.length && !part ? `Line ${mistakes[0].line}: ` : ''}${error}. Drawing and figures are those of the last room without mistakes. `,
        part && part.index !== board.selected && KINDS[part.name] && h('button', { type: 'button', onclick: () => board.select(part.index) }, `Show ${labelOf(part)}`)]);
    $('status').hidden = !error;
    document.body.classList.toggle('stale', Boolean(error));
}

// One sentence for screen readers, when the figures have settled.
function speak() {
    const df = board.results.df;
    const name = Object.keys(df?.average?.df ?? {}).find((n) => averageOf(df, n) !== null);
    if (name) $('spoken').textContent = `Average daylight factor ${figure(averageOf(df, name))} per cent by ${name}.`;
}

export function setUpResults(about) {
    methods = about.methods;
    board.on('results', (event) => {
        if ('error' in event.detail) drawMistakes();
        if ('df' in event.detail || 'trace' in event.detail) drawAverages();
        if ('plan' in event.detail || 'error' in event.detail) drawPlanFigures();
        if ('trace' in event.detail || 'df' in event.detail || 'scene' in event.detail || 'traceError' in event.detail) drawTrace();
        if ('point' in event.detail) drawPoint();
        if ('df' in event.detail) speak();
        if (event.detail.df) for (const id of ['averages', 'points']) $(id).classList.remove('old');
    });
    board.on('trace', drawTrace);
    // Until new figures arrive the former ones are dimmed.
    board.on('text', () => { for (const id of ['averages', 'points']) $(id).classList.add('old'); });
    $('trace-button').addEventListener('click', () => (isTracing() ? stopTrace() : startTrace()));
    $('trace-live').addEventListener('change', (event) => { switches.trace = event.target.checked; });
    $('trace-error').addEventListener('change', (event) => {
        switches.error = Number(event.target.value);
        startTrace();
    });
    $('place').addEventListener('submit', (event) => {
        event.preventDefault();
        const numbers = $('place-text').value.split(/[\s,]+/).map(Number);
        if (numbers.length < 2 || numbers.some((n) => !Number.isFinite(n))) return;
        board.pointer = numbers.slice(0, 2);
        board.isPointerKept = true;
        board.tell('pointer');
    });
}
