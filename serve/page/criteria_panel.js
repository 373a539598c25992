// criteria_panel.js - the findings of pepperpot assess, and changes that would help. They are
// requested after a pause in the input, if the tab is open.

import { board } from './board.js';
import { engine } from './engine.js';
import { $, h, figure, replaceChildren } from './dom.js';

const VERDICTS = { met: 'met', 'not met': 'not met', undecided: 'undecided' };

let asked = null;

function drawFinding(finding) {
    const verdict = finding.verdict ?? 'stated';
    const bound = finding.wanted === undefined || finding.wanted === null ? '' : `${finding.bound === 'most' ? 'at most' : 'at least'} ${figure(finding.wanted)}`;
    return h('tr', { class: `verdict-${verdict.replace(/ /g, '-')}` }, h('th', { scope: 'row' }, finding.of),
        h('td', {}, `${figure(finding.figure ?? null, finding.se ?? null)} ${finding.unit ?? ''}`), h('td', {}, bound),
        h('td', {}, VERDICTS[verdict] ?? verdict, finding.note && h('span', { class: 'note' }, ` ${finding.note}`)));
}

function drawHelp(help) {
    const list = Array.isArray(help?.changes) ? help.changes : Array.isArray(help) ? help : [];
    const shown = list.filter((c) => c.change);
    return shown.length > 0 && [h('h3', {}, 'What would help'), h('ul', {}, shown.map((c) => h('li', {}, `${c.change}${Number.isFinite(c.average) ? `: average ${figure(c.average)} %` : ''}`)))];
}

// Finds the list of changes anywhere in the answer.
function changesIn(answer) {
    const found = [];
    const look = (value) => {
        if (Array.isArray(value)) value.forEach(look);
        else if (value && typeof value === 'object') {
            if (typeof value.change === 'string') found.push(value);
            else Object.values(value).forEach(look);
        }
    };
    look(answer);
    return found;
}

function draw(answer) {
    const box = $('criteria');
    const room = Array.isArray(answer) ? answer[0] : answer;
    const judged = (room.criteria ?? []).filter((c) => c.findings?.length);
    const left = (room.criteria ?? []).filter((c) => !c.findings?.length);
    replaceChildren(box, judged.map((c) => [h('h3', {}, c.title ?? c.criterion, c.source && h('span', { class: 'note' }, ` ${c.source}`)), h('table', {}, h('tbody', {}, c.findings.map(drawFinding)))]),
        drawHelp(changesIn(answer)), left.length > 0 && h('p', { class: 'note' }, `Not applicable: ${left.map((c) => c.title ?? c.criterion).join(', ')}.`));
}

export async function updateCriteria() {
    if ($('panel-criteria').hidden || !board.text) return;
    asked?.abort();
    const own = asked = new AbortController();
    $('criteria').setAttribute('aria-busy', 'true');
    try {
        const options = { 'by-hand': true };
        if (board.rooms.length > 1 && board.roomName) options.room = board.roomName;
        draw(await engine.assess(board.text, options, own.signal));
    } catch (error) {
        if (error.name !== 'AbortError') replaceChildren($('criteria'), h('p', { class: 'bad' }, error.message));
    }
    if (own === asked) $('criteria').removeAttribute('aria-busy');
}

export function setUpCriteria() {
    board.on('rested', updateCriteria);
    board.on('tab', updateCriteria);
}
