// criteria_panel.js - the findings of pepperpot assess, and changes that would help. They are
// requested after a pause in the input, if the tab is open.

import { board } from './board.js';
import { engine } from './engine.js';
import { $, h, figure, replaceChildren } from './dom.js';

let asked = null;

const UNITS = { m2: 'm\u00b2', degrees: '\u00b0' };

// A figure with its unit.
function withUnit(text, unit = '') {
    return unit === 'degrees' ? `${text}\u00b0` : `${text} ${UNITS[unit] ?? unit}`.trim();
}

// A finding as a row, and its note as a second one. Optional findings are targets above the one
// that a criterion requires.
function drawFinding(finding) {
    const { unit, optional, note } = finding, wanted = finding.wanted ?? null;
    const judged = finding.verdict && finding.verdict !== 'not judged' ? finding.verdict : '';
    const verdict = optional && judged === 'not met' ? 'not reached' : judged;
    const bound = wanted === null ? 'no target' : `${finding.bound === 'most' ? 'at most' : 'at least'} ${withUnit(String(Number(wanted.toPrecision(3))), unit)}`;
    return [h('tr', { class: `verdict-${verdict.replace(/ /g, '-') || 'none'}` }, h('th', { scope: 'row' }, finding.of),
        h('td', {}, withUnit(figure(finding.figure ?? null, finding.se ?? null), unit), h('span', { class: 'bound' }, bound)), h('td', {}, verdict)),
    note && h('tr', { class: 'remark' }, h('td', { colspan: 3 }, note))];
}

function drawHelp(gains) {
    const changes = (gains?.changes ?? []).filter((c) => c.change);
    const now = Number.isFinite(gains?.average) ? ` Now: ${figure(gains.average)} %.` : '';
    return changes.length > 0 && [h('h2', {}, 'What would help'),
        h('p', { class: 'note' }, `Single changes, with the average daylight factor after each${gains.method ? `, by ${gains.method}` : ''}.${now}`),
        h('ul', {}, changes.map((c) => h('li', {}, `${c.change}${Number.isFinite(c.average) ? `: ${figure(c.average)} %` : ''}`)))];
}

function draw(answer) {
    const room = Array.isArray(answer) ? answer[0] : answer;
    const judged = (room.criteria ?? []).filter((c) => c.findings?.length);
    const left = (room.criteria ?? []).filter((c) => !c.findings?.length);
    replaceChildren($('criteria'), judged.map((c) => [h('h2', {}, c.title ?? c.criterion, c.source && h('span', { class: 'note' }, ` ${c.source}`)),
        h('table', { class: 'findings' }, h('tbody', {}, c.findings.map(drawFinding)))]),
    drawHelp(room.gains), room.reliability?.relied_on === false && h('p', { class: 'note' }, `${room.reliability.why}.`),
    left.length > 0 && h('p', { class: 'note' }, `Not applicable: ${left.map((c) => c.title ?? c.criterion).join(', ')}.`));
}

export async function updateCriteria() {
    if ($('panel-criteria').hidden || !board.text) return;
    asked?.abort();
    const own = asked = new AbortController();
    $('criteria').setAttribute('aria-busy', 'true');
    try {
        draw(await engine.assess(board.text, { 'by-hand': true, ...board.roomOption }, own.signal));
    } catch (error) {
        if (error.name !== 'AbortError') replaceChildren($('criteria'), h('p', { class: 'bad' }, error.message));
    }
    if (own === asked) $('criteria').removeAttribute('aria-busy');
}

export function setUpCriteria() {
    board.on('rested', updateCriteria);
    board.on('tab', updateCriteria);
}
