// results_panel.js - figures: averages by method and simulated, of both variants; the points; and
// the components by opening at the place under the pointer.

import { board } from './board.js';
import { $, h, figure, replaceChildren } from './dom.js';
import { isTracing, startTrace, stopTrace, switches } from './live.js';

function valueRow(label, values, note) {
    return h('tr', {}, h('th', { scope: 'row' }, label), values.map((v) => h('td', {}, v)), note !== undefined && h('td', { class: 'note' }, note));
}

function averageOf(df, name) {
    return df?.average?.df?.[name]?.value ?? null;
}

function drawAverages() {
    const all = board.results.all ?? [board.results.df];
    const shown = board.variants.map((_, i) => all[i]);
    const names = [...new Set(shown.flatMap((df) => Object.keys(df?.average?.df ?? {})))];
    const traced = board.results.trace?.average;
    const head = h('tr', {}, h('th', { scope: 'col' }, 'Average daylight factor'), board.variants.map((_, i) => h('th', { scope: 'col' }, board.variants.length > 1 ? `${'AB'[i]}${i === board.active ? ' (drawn)' : ''}` : '%')));
    const rows = names.map((name) => valueRow(name, shown.map((df) => df?.error ? 'error' : figure(averageOf(df, name)))));
    rows.push(valueRow('simulated', board.variants.map((_, i) => i === board.active && traced ? figure(traced[0], traced[1]) : '\u2013')));
    replaceChildren($('averages'), h('thead', {}, head), h('tbody', {}, rows));
}

function drawPlanFigures() {
    const { plan, why, error } = board.results;
    const box = $('plan-figures');
    if (error || !plan) {
        replaceChildren(box, h('p', { class: 'bad' }, error ?? why));
        return;
    }
    replaceChildren(box, h('dl', {},
        h('div', {}, h('dt', {}, `Contours by ${plan.method}`), h('dd', {}, `${figure(plan.lowest.value)} to ${figure(plan.highest.value)} %`)),
        h('div', {}, h('dt', {}, 'Working plane with a view of the sky'), h('dd', {}, `${plan['sky-share'].toFixed(plan['sky-share'] > 99.95 ? 0 : 1)} %`))),
        plan.note && h('p', { class: 'note' }, plan.note));
}

function drawTrace() {
    const { trace, traceError, scene, df } = board.results;
    $('trace-progress').value = trace?.progress ?? 0;
    $('trace-state').textContent = traceError || (isTracing() ? `Simulating: largest error ${trace ? figure(trace.error) : '\u2013'} %` : trace?.isDone ? `Simulated to ${figure(trace.error)} % of each value` : 'Not simulated');
    $('trace-button').textContent = isTracing() ? 'Stop' : 'Simulate';
    if (!scene) return;
    const hand = df && !df.error ? df.points : [];
    const name = Object.keys(hand[0]?.df ?? {})[0];
    const rows = scene.points.map((p, i) => h('tr', {}, h('th', { scope: 'row' }, `${p.x.toFixed(2)}, ${p.y.toFixed(2)}`),
        h('td', {}, figure(hand[i]?.df?.[name]?.value ?? null)), h('td', {}, trace?.points[i] ? figure(trace.points[i][0], trace.points[i][1]) : '\u2013')));
    replaceChildren($('points'), h('thead', {}, h('tr', {}, h('th', { scope: 'col' }, 'Point, m'), h('th', { scope: 'col' }, name ? `${name}, %` : 'by hand, %'), h('th', { scope: 'col' }, 'simulated, %'))),
        h('tbody', {}, rows.slice(0, 400)));
}

// Values of the steps that end an opening's sum, by the opening's line.
function byOpening(reading, symbol) {
    const found = new Map();
    for (const step of reading?.steps ?? []) if (step.symbol === symbol && step.opening) found.set(step.opening, step.value);
    return found;
}

function openingName(line) {
    const element = board.elements.find((e) => e.line === line && ['window', 'rooflight', 'opening'].includes(e.name));
    const wall = element?.attributes.wall?.value;
    return `${element?.name ?? 'opening'}${wall ? ` in ${wall}` : ''}, line ${line}`;
}

function drawPoint() {
    const { point, pointError } = board.results;
    const box = $('point-figures');
    const found = point?.points?.[0];
    if (!found) {
        replaceChildren(box, h('p', { class: 'hint' }, pointError || 'Move the pointer over the plan to see the components there, or enter a position.'));
        return;
    }
    const first = (part) => Object.values(found[part] ?? {})[0];
    const [sc, erc, irc, df] = ['sc', 'erc', 'irc', 'df'].map(first);
    const sky = byOpening(sc, 'SC'), external = byOpening(erc, 'ERC'), internal = byOpening(irc, 'IRC');
    const lines = [...new Set([...sky.keys(), ...external.keys(), ...internal.keys()])].sort((a, b) => a - b);
    replaceChildren(box, h('table', {},
        h('caption', {}, `At ${found.x.toFixed(2)}, ${found.y.toFixed(2)} m, ${found.z.toFixed(2)} m high, by ${Object.keys(found.df)[0]}`),
        h('thead', {}, h('tr', {}, ['Opening', 'Sky, %', 'Outside, %', 'Inside, %'].map((t) => h('th', { scope: 'col' }, t)))),
        h('tbody', {}, lines.map((line) => valueRow(openingName(line), [sky, external, internal].map((m) => figure(m.get(line) ?? 0)))),
            h('tr', { class: 'sum' }, h('th', { scope: 'row' }, `Daylight factor ${figure(df?.value ?? null)} %`), [sc, erc, irc].map((r) => h('td', {}, figure(r?.value ?? null)))))));
}

function drawMistakes() {
    const { mistakes, error } = board.results;
    $('status').textContent = error ? `${mistakes.length > 1 ? `${mistakes.length} mistakes. ` : ''}${error}` : '';
    $('status').hidden = !error;
}

// One sentence for screen readers, when the figures have settled.
function speak() {
    const df = board.results.df;
    const name = Object.keys(df?.average?.df ?? {})[0];
    if (name) $('spoken').textContent = `Average daylight factor ${figure(averageOf(df, name))} per cent by ${name}.`;
}

export function setUpResults() {
    board.on('results', (event) => {
        drawMistakes();
        if ('df' in event.detail || 'trace' in event.detail) drawAverages();
        if ('plan' in event.detail || 'error' in event.detail) drawPlanFigures();
        if ('trace' in event.detail || 'df' in event.detail || 'scene' in event.detail || 'traceError' in event.detail) drawTrace();
        if ('point' in event.detail) drawPoint();
        if ('df' in event.detail) speak();
    });
    board.on('trace', drawTrace);
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
        board.tell('pointer');
    });
}
