// sheets_panel.js - chart sheets with the room's windows, pictures, sizes and the report: shown here
// and downloaded as files.

import { board } from './board.js';
import { engine } from './engine.js';
import { labelOf } from './kinds.js';
import { $, h, download, fileName, replaceChildren, say } from './dom.js';

// Kinds that need a point: the room's first one.
const FROM_POINT = ['waldram', 'pepper-pot', 'protractor', 'brs-table', 'position-nomogram'];
const SHOWN = ['waldram', 'pepper-pot', 'protractor', 'nomogram', 'brs-table', 'section', 'plan', 'elevation', 'vertical-sky', 'skylight-indicator', 'sun-path', 'availability', 'position-nomogram', 'note'];

let charts = []; // of the engine: { name, summary }
let asked = null, url = null, weather = null, rendering = null;

function optionsFor(kind) {
    const options = { ...board.roomOption };
    if (FROM_POINT.includes(kind)) {
        const point = board.pointer ?? (() => { const p = board.results.scene?.points[0]; return p && [p.x, p.y]; })();
        if (point) options.points = [point.map((c) => Number(c.toFixed(3)))];
    }
    if (kind === 'plan') options.fill = 'colour';
    if (kind === 'availability' && weather) options.weather = weather.hash;
    return options;
}

function show(blob, alt) {
    if (url) URL.revokeObjectURL(url);
    url = URL.createObjectURL(blob);
    replaceChildren($('sheet'), h('img', { src: url, alt, onclick: enlarge }));
    replaceChildren($('large-sheet'), h('img', { src: url, alt }));
}

function enlarge() {
    if ($('large-sheet').firstChild) $('sheet-dialog').showModal();
}

export async function updateSheet() {
    if ($('panel-sheets').hidden || !board.text) return;
    asked?.abort();
    const own = asked = new AbortController(), kind = $('sheet-kind').value;
    const { summary } = charts.find((c) => c.name === kind);
    $('sheet-about').textContent = `${summary[0].toUpperCase()}${summary.slice(1)}.`;
    $('sheet').setAttribute('aria-busy', 'true');
    try {
        show(await engine.file(`chart/${kind}`, board.text, { ...optionsFor(kind), format: 'svg' }, own.signal), `${kind} of ${board.roomName || 'the room'}`);
    } catch (error) {
        if (error.name !== 'AbortError') {
            replaceChildren($('sheet'), h('p', { class: 'bad' }, error.message));
            replaceChildren($('large-sheet'));
        }
    }
    if (own === asked) $('sheet').removeAttribute('aria-busy');
}

async function downloadChart(format) {
    const kind = $('sheet-kind').value;
    await saved(async () => download(fileName(`${board.roomName}-${kind}`, format), '', await engine.file(`chart/${kind}`, board.text, { ...optionsFor(kind), format })));
}

async function saved(work) {
    say('The file is being made\u2026');
    try {
        await work();
    } catch (error) {
        say(error.message, true);
        return;
    }
    say('The file is in the downloads of the browser.');
}

export async function downloadFile(what) {
    const name = board.roomName, room = board.roomOption;
    const jobs = {
        room: async () => download(fileName(name, 'xml'), 'application/xml', board.text),
        report: async () => download(fileName(name, 'html'), 'text/html', await engine.file('report', board.text, { ...room, format: 'html' })),
        'report-pdf': async () => download(fileName(name, 'pdf'), 'application/pdf', await engine.file('report', board.text, { ...room, format: 'pdf' })),
        csv: async () => download(fileName(name, 'csv'), 'text/csv', await engine.file('df', board.text, { ...room, format: 'csv' })),
        json: async () => download(fileName(name, 'json'), 'application/json', await engine.file('df', board.text, { ...room, format: 'json' })),
    };
    await saved(jobs[what]);
}

async function render() {
    rendering?.abort();
    const own = rendering = new AbortController();
    const options = { view: $('picture-view').value, size: '480x360', ...board.roomOption };
    if ($('picture-quantity').value !== 'luminance') Object.assign(options, { quantity: $('picture-quantity').value, 'false-colour': true });
    $('picture-state').textContent = 'Drawing\u2026';
    try {
        for await (const { data } of engine.render(board.text, options, own.signal)) {
            replaceChildren($('picture'), h('img', { src: `data:image/png;base64,${data.png}`, alt: `Picture of ${board.roomName || 'the room'}, pass ${data.pass}` }));
            $('picture-state').textContent = `Pass ${data.pass} of ${data.passes}, ${data.samples} paths per pixel`;
        }
    } catch (error) {
        $('picture-state').textContent = error.name === 'AbortError' ? 'Stopped' : error.message;
    }
    if (own === rendering) rendering = null;
}

async function size() {
    const box = $('size-answer');
    box.textContent = 'Looking\u2026';
    try {
        const answer = await engine.size(board.text, { target: `${Number($('size-target').value)}%`, change: $('size-change').value, 'by-hand': true, ...board.roomOption });
        box.textContent = answer.answer ? `${answer.answer[0].toUpperCase()}${answer.answer.slice(1)}.` : 'There is no answer.';
        const elements = (answer.windows ?? []).filter((w) => w.is === 'changed').map((w) => [board.elements.find((e) => e.line === w.line && e.name === 'window'), w]).filter(([e]) => e);
        if (!elements.length) return;
        const sizes = elements.map(([e, w]) => `${labelOf(e)}: ${['left', 'sill', 'width', 'height'].filter((k) => Number.isFinite(w[k])).map((k) => `${k} ${Number(w[k].toFixed(3))} m`).join(', ')}`);
        box.append(h('ul', {}, sizes.map((text) => h('li', {}, text))), h('button', { type: 'button', onclick: () => board.tell('size', elements) }, 'Use it'));
    } catch (error) {
        box.textContent = error.message;
    }
}

export function useWeather(found) {
    weather = found;
    $('weather-name').textContent = `Weather: ${found.place}`;
    $('sheet-kind').value = 'availability';
    updateSheet();
}

export function setUpSheets(about) {
    charts = about.charts;
    const kinds = SHOWN.filter((kind) => about.charts.some((c) => c.name === kind));
    $('sheet-kind').append(...kinds.map((kind) => h('option', { value: kind }, kind)));
    $('sheet-kind').addEventListener('change', updateSheet);
    $('sheet-enlarge').addEventListener('click', enlarge);
    for (const format of ['pdf', 'svg', 'png']) $(`sheet-${format}`).addEventListener('click', () => downloadChart(format));
    $('picture-start').addEventListener('click', render);
    $('picture-stop').addEventListener('click', () => rendering?.abort());
    $('size-form').addEventListener('submit', (event) => {
        event.preventDefault();
        size();
    });
    board.on('rested tab', updateSheet);
    board.on('pointer', () => { if (board.isPointerKept && FROM_POINT.includes($('sheet-kind').value)) updateSheet(); });
}
