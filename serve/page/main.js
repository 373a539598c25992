// main.js - assembles the page.

import { board } from './board.js';
import { engine, setKey, setToken } from './engine.js';
import { readAddress, writeAddress } from './address.js';
import { $, h, replaceChildren, say } from './dom.js';
import { setMany, setAttributes, writtenLength } from './room_text.js';
import { boundsWith, createOtherPlan, createPlanView, scaleFor } from './plan_view.js';
import { bottomOf, createSectionView } from './section_view.js';
import { createAxonView } from './axon_view.js';
import { setUpProperties, copySelected, deleteSelected } from './properties.js';
import { setUpLive, isBusy, timings } from './live.js';
import { setUpResults } from './results_panel.js';
import { setUpCriteria } from './criteria_panel.js';
import { setUpSheets, downloadFile } from './sheets_panel.js';
import { setUpYear } from './year_panel.js';
import { setUpText } from './text_tab.js';
import { setUpFiles } from './files.js';

// ---- views ----

let lowerMode = 'section', withOutside = false;

function fitting(scene, bounds) {
    const box = $('plan').getBoundingClientRect(), low = $('lower').getBoundingClientRect();
    const tall = Math.max(20, (low.height - 50) / Math.max(0.5, scene.height - bottomOf(scene)));
    const deep = (low.width - 100) / Math.max(bounds[1] - bounds[0], bounds[3] - bounds[2]);
    return Math.min(scaleFor(bounds, box.width, box.height, 36), withOutside ? Infinity : Math.min(tall, deep));
}

// One scale for plan and section, and for the plans of both variants, so that they can be compared.
function scaleOf() {
    const scenes = board.variants.map((v, i) => (i === board.active ? board.results.scene : v.drawn?.scene)).filter(Boolean);
    const all = scenes.map((s) => boundsWith(s, withOutside));
    const bounds = [0, 1, 2, 3].map((k) => (k % 2 ? Math.max : Math.min)(...all.map((b) => b[k])));
    return { bounds, scale: Math.min(...scenes.map((s) => fitting(s, bounds))), withOutside };
}

const drawPlan = createPlanView($('plan'), scaleOf);
const drawOther = createOtherPlan($('other-plan'), scaleOf);
const drawSection = createSectionView($('lower'), scaleOf);
const drawAxon = createAxonView($('lower'), () => {
    const [, month, day] = $('sun-date').value.split('-').map(Number);
    const [hours, minutes] = $('sun-time').value.split(':').map(Number);
    return { month: month || 3, day: day || 21, time: (hours || 0) + (minutes || 0) / 60 };
});

function drawLower() {
    $('lower').dataset.mode = lowerMode;
    if (lowerMode === 'axon') drawAxon();
    else drawSection(lowerMode);
}

function draw() {
    drawOther();
    drawPlan();
    drawLower();
}

// ---- tabs: buttons of a tablist, by pointer and arrow keys ----

function setUpTabs(list, chosen) {
    const tabs = [...list.querySelectorAll('[role=tab]')];
    const choose = (tab) => {
        for (const other of tabs) {
            other.setAttribute('aria-selected', String(other === tab));
            other.tabIndex = other === tab ? 0 : -1;
        }
        chosen(tab.dataset.tab);
    };
    list.addEventListener('click', (event) => {
        const tab = event.target.closest('[role=tab]');
        if (tab) choose(tab);
    });
    list.addEventListener('keydown', (event) => {
        const at = tabs.indexOf(document.activeElement), by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
        if (at < 0 || !by) return;
        const next = tabs[(at + by + tabs.length) % tabs.length];
        next.focus();
        choose(next);
        event.preventDefault();
    });
}

// ---- rooms and variants ----

function drawChoices() {
    const rooms = board.rooms;
    $('room-choice').hidden = rooms.length < 2;
    replaceChildren($('room-choice'), rooms.map((r, i) => h('option', { value: i }, r.attributes.name?.value ?? `Room ${i + 1}`)));
    $('room-choice').value = String(board.roomIndex);
    const two = board.variants.length === 2;
    $('compare').setAttribute('aria-pressed', String(two));
    $('variants').hidden = !two;
    for (const [i, id] of ['variant-a', 'variant-b'].entries()) $(id).setAttribute('aria-pressed', String(board.active === i));
    $('undo').disabled = !board.variant?.undo.length;
    $('redo').disabled = !board.variant?.redo.length;
    $('room-name').textContent = rooms.length > 1 ? '' : board.roomName;
    $('room-name').title = board.roomName; // a long name is shortened
    document.title = `${board.roomName || 'Room'} \u2013 pepperpot`;
}

function showOutside(on) {
    withOutside = on;
    $('outside').setAttribute('aria-pressed', String(on));
}

// Parts that stand outside the room: they are out of sight until the surroundings are shown.
const OUTSIDE = ['block', 'tree'];

async function copyLink() {
    try {
        await navigator.clipboard.writeText(location.href);
        say(`The link is copied. It contains the whole room, and opens as long as the server at ${location.host} runs. To keep the room, download the room file.`);
    } catch {
        say('The browser does not allow copying; copy the address of this page instead. It contains the whole room.');
    }
}

function setUpBar() {
    $('undo').addEventListener('click', () => board.undo());
    $('redo').addEventListener('click', () => board.redo());
    $('compare').addEventListener('click', () => board.compare(board.variants.length === 1));
    $('variant-a').addEventListener('click', () => board.use(0));
    $('variant-b').addEventListener('click', () => board.use(1));
    $('room-choice').addEventListener('change', (event) => board.chooseRoom(Number(event.target.value)));
    $('download').addEventListener('change', (event) => {
        downloadFile(event.target.value);
        event.target.value = '';
    });
    $('outside').addEventListener('click', () => {
        showOutside(!withOutside);
        draw();
    });
    $('link').addEventListener('click', copyLink);
    $('jump').addEventListener('click', (event) => $(event.target.dataset.to)?.scrollIntoView());
    $('theme').addEventListener('click', () => {
        const dark = document.documentElement.dataset.theme ? document.documentElement.dataset.theme === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
        document.documentElement.dataset.theme = dark ? 'light' : 'dark';
        localStorage.setItem('pepperpot-theme', document.documentElement.dataset.theme);
    });
    document.addEventListener('keydown', (event) => {
        // In a field whose value has not been changed, the keys act on the room.
        const field = event.target.closest?.('#values input');
        const isTyped = event.target.closest?.('input:not([type=checkbox]), textarea, #editor') && (!field || field.value !== field.dataset.value);
        const isText = isTyped || event.target.closest?.('input, select');
        const control = event.ctrlKey || event.metaKey;
        if (control && event.key.toLowerCase() === 'z' && !isTyped) {
            if (event.shiftKey) board.redo();
            else board.undo();
            event.preventDefault();
        } else if (control && event.key.toLowerCase() === 'y' && !isTyped) {
            board.redo();
            event.preventDefault();
        } else if (control && event.key.toLowerCase() === 'd' && !isText) {
            copySelected();
            event.preventDefault();
        } else if (event.key === 'Delete' && !isText) {
            deleteSelected();
        } else if (event.key === 'Escape' && !isText) {
            board.isPointerKept = false;
            board.select(-1);
            draw();
        }
    });
    board.on('size', (event) => {
        const changes = event.detail.map(([element, w]) => [element, Object.fromEntries(['left', 'sill', 'width', 'height'].filter((k) => Number.isFinite(w[k])).map((k) => [k, writtenLength(element, w[k])]))]);
        board.change(setMany(board.text, changes));
    });
    const wide = new ResizeObserver(draw);
    wide.observe($('plan'));
    wide.observe($('lower'));
}

async function askToken() {
    const dialog = $('token-dialog');
    dialog.showModal();
    await new Promise((done) => dialog.addEventListener('close', done, { once: true }));
    setToken($('token').value.trim());
}

async function about() {
    for (;;) {
        try {
            return await engine.about();
        } catch (error) {
            if (error.status !== 401) throw error;
            await askToken();
        }
    }
}

async function firstRoom(address, server) {
    if (address.room) return address.room;
    if (address.key || server.room) {
        try {
            return await engine.startRoom();
        } catch {
            // The room of another user may not be read: begin with an example.
        }
    }
    return engine.example('office');
}

async function start() {
    const theme = localStorage.getItem('pepperpot-theme');
    if (theme) document.documentElement.dataset.theme = theme;
    const address = await readAddress();
    if (address.token) setToken(address.token);
    if (address.key) setKey(address.key);
    const server = await about();
    $('version').textContent = server.version;
    $('method').append(...['exact+bre', 'exact+split-flux', 'brs-table+bre', 'protractor+bre', 'exact'].map((m) => h('option', { value: m }, m)));
    $('method').addEventListener('change', (event) => {
        board.method = event.target.value;
        board.tell('text', { from: 'method' });
    });
    setUpLive(); // first, so that a request leaves before the page is drawn
    setUpProperties();
    setUpResults(server);
    setUpCriteria();
    setUpSheets(server);
    setUpYear();
    setUpFiles();
    setUpBar();
    setUpTabs($('lower-tabs'), (mode) => {
        lowerMode = mode;
        $('sun').hidden = mode !== 'axon';
        draw();
    });
    setUpTabs($('main-tabs'), (tab) => {
        $('panel-drawing').hidden = tab !== 'drawing';
        $('panel-text').hidden = tab !== 'text';
        $('drawing-choices').hidden = tab !== 'drawing';
        draw();
    });
    setUpTabs($('result-tabs'), (tab) => {
        for (const name of ['figures', 'criteria', 'sheets', 'year', 'pictures']) $(`panel-${name}`).hidden = tab !== name;
        board.tell('tab');
    });
    for (const id of ['sun-date', 'sun-time']) $(id).addEventListener('input', draw);
    board.on('text', (event) => {
        if (event.detail.from !== 'open') say('');
        drawChoices();
        draw(); // so that handles and parts belong to the new text
        writeAddress(board.variants[0].text, board.variants[1]?.text);
    });
    board.on('selection', () => {
        if (OUTSIDE.includes(board.element?.name)) showOutside(true);
        draw();
    });
    board.on('other', drawOther);
    board.on('results', (event) => {
        if ('scene' in event.detail || 'trace' in event.detail) draw();
        else if ('section' in event.detail) drawLower();
    });
    board.open(await firstRoom(address, server));
    if (address.other) {
        board.variants.push({ text: address.other, undo: [], redo: [] });
        board.tell('text', { from: 'variant' });
    }
    if (address.isBroken) say('The room in the address could not be read; this is an example.');
    await setUpText();
}

// For tests and benchmarks, which read the page as a user sees it, and wait until it is up to date.
window.pepperpot = { board, isBusy, timings, setAttributes };

start().catch((error) => say(error.message, true));
