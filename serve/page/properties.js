// properties.js - the list of the room's parts, and fields for the values of the selected one.

import { board } from './board.js';
import { $, h, replaceChildren } from './dom.js';
import { KINDS, NEW_PARTS, attributesOf, labelOf } from './kinds.js';
import { insertBehind, insertInto, readElements, removeElement, setAttributes, textOf, valueOf } from './room_text.js';
import { pointsOf, rangeOf } from './geometry.js';

const PLACED = ['window', 'rooflight', 'opening', 'block', 'point', 'line', 'surface', 'skyline', 'furniture', 'column', 'garden'];

function levelOf(element) {
    let level = 0;
    for (let at = element.parent; at && at !== board.room && at.name !== 'building'; at = at.parent) level++;
    return level;
}

function drawParts() {
    const list = $('parts');
    const room = board.room;
    const shown = [room, ...board.parts].filter((e) => e && KINDS[e.name] && e.name !== 'vertex');
    replaceChildren(list, h('option', { value: -1 }, shown.length ? 'Choose a part to change it' : 'The text does not contain a room'),
        shown.map((e) => h('option', { value: e.index }, '\u2003'.repeat(levelOf(e)) + labelOf(e))));
    list.value = String(shown.some((e) => e.index === board.selected) ? board.selected : -1);
}

function setValue(element, name, value) {
    const text = value.trim();
    const changes = { [name]: text === '' ? null : text };
    // A pitched roof needs a pitch, and a flat one must not have any.
    if (name === 'roof' && ['', 'flat'].includes(text)) Object.assign(changes, { pitch: null, teeth: null });
    else if (name === 'roof' && valueOf(element, 'pitch', '') === '') changes.pitch = '30';
    board.change(setAttributes(board.text, element, changes));
}

function drawValue(element, [name, unit, choices]) {
    const id = `value-${name}`;
    const value = valueOf(element, name, '');
    const input = choices
        ? h('input', { id, type: 'text', value, list: `${id}-list`, autocomplete: 'off' })
        : h('input', { id, type: 'text', value, inputmode: unit ? 'decimal' : null, autocomplete: 'off', spellcheck: 'false' });
    input.addEventListener('change', () => setValue(board.elements[element.index], name, input.value));
    input.addEventListener('keydown', (event) => {
        const step = { ArrowUp: 1, ArrowDown: -1 }[event.key];
        const number = parseFloat(input.value);
        if (!step || !unit || !Number.isFinite(number)) return;
        event.preventDefault();
        const by = unit === '\u00b0' ? 1 : 0.05;
        input.value = String(Number((number + step * by).toFixed(3)));
        setValue(board.elements[element.index], name, input.value);
    });
    const isWide = choices?.some((c) => c.length > 10);
    return h('div', { class: isWide ? 'value wide' : 'value' }, h('label', { for: id }, name), h('span', { class: 'field' }, input, unit && h('span', { class: 'unit' }, unit)),
        choices && h('datalist', { id: `${id}-list` }, choices.map((c) => h('option', { value: c }))));
}

function drawValues() {
    const element = board.element;
    const box = $('values');
    if (!element) {
        replaceChildren(box, h('p', { class: 'hint' }, 'Select a part in the drawing or in the list. Move its handles with the pointer or the arrow keys, in steps of 5 cm; hold Alt to move them freely.'));
        return;
    }
    replaceChildren(box, h('h3', {}, labelOf(element)), h('div', { class: 'value-grid' }, attributesOf(element).map((a) => drawValue(element, a))));
}

function boundsOfRoom() {
    const scene = board.results.scene;
    if (!scene) return [0, 4, 0, 5];
    const points = scene.surfaces.slice(0, scene.faces).flatMap((f) => pointsOf(f.xyz));
    return [...rangeOf(points, 0), ...rangeOf(points, 1)];
}

function wallForNew() {
    const used = valueOf(board.element, 'wall') ?? valueOf(board.parts.find((e) => e.name === 'window'), 'wall');
    return used ?? board.results.scene?.surfaces.find((f) => f.role === 'wall')?.name ?? 'south';
}

// Adds a part and selects it: after the last one of its kind or, if there is none, at its position
// in the order of a room file.
function add(kind) {
    const xml = NEW_PARTS[kind](boundsOfRoom(), wallForNew());
    const room = board.room;
    if (!room) return;
    const isChild = kind === 'blind';
    const parent = isChild ? (board.element?.name === 'window' ? board.element : board.parts.find((e) => e.name === 'window')) : room;
    if (!parent) return;
    const same = parent.children.filter((e) => e.name === kind).pop();
    const text = same ? insertBehind(board.text, same, xml) : insertInto(board.text, parent, xml);
    choose(text, (e) => e.name === kind && textOf(text, e).startsWith(xml));
}

// Changes the text and selects the last element that fits.
function choose(text, fits) {
    const made = readElements(text).filter(fits).pop();
    board.change(text, { select: made?.index ?? -1 });
}

export function copySelected() {
    const element = board.element;
    if (!element || !PLACED.includes(element.name)) return;
    let xml = textOf(board.text, element);
    const moved = { left: 0.2, x: 0.2 };
    const own = readElements(xml)[0];
    for (const [name, by] of Object.entries(moved)) {
        const value = parseFloat(own.attributes[name]?.value);
        if (Number.isFinite(value)) {
            xml = setAttributes(xml, own, { [name]: String(Number((value + by).toFixed(3))) });
            break;
        }
    }
    const text = insertBehind(board.text, element, xml);
    choose(text, (e) => e.from > element.from && e.name === element.name && textOf(text, e) === xml);
}

export function deleteSelected() {
    const element = board.element;
    if (!element || ['room', 'building', 'plan', 'envelope'].includes(element.name)) return;
    board.change(removeElement(board.text, element), { select: -1 });
}

export function setUpProperties() {
    $('parts').addEventListener('change', (event) => board.select(Number(event.target.value)));
    $('add').append(...Object.keys(NEW_PARTS).map((kind) => h('option', { value: kind }, KINDS[kind].label)));
    $('add').addEventListener('change', (event) => {
        add(event.target.value);
        event.target.value = '';
    });
    $('copy').addEventListener('click', copySelected);
    $('delete').addEventListener('click', deleteSelected);
    const draw = () => {
        drawParts();
        drawValues();
        const name = board.element?.name;
        $('copy').disabled = !PLACED.includes(name);
        $('delete').disabled = !name || ['room', 'building', 'plan', 'envelope'].includes(name);
    };
    board.on('text selection', draw);
    draw();
}
