// properties.js - the list of the room's parts, and fields for the values of the selected one.

import { board } from './board.js';
import { $, h, replaceChildren, say } from './dom.js';
import { ABOUT_NEW, HINTS, KINDS, NEW_PARTS, USUAL, attributesOf, labelOf } from './kinds.js';
import { insertBehind, insertInto, lengthOf, metresPer, partAt, readElements, removeElement, setAttributes, textOf, valueOf, written, writtenLength } from './room_text.js';
import { pointsOf, rangeOf, wallAxes } from './geometry.js';
import { surfaceOfWall } from './handles.js';

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

// A number as people write it, with a decimal comma or a unit of length, as the file requires it;
// other text stays as it is.
function numberText(text, element) {
    const found = /^([+-]?\d*[.,]?\d+)\s*(mm|cm|m|\u00b0)?$/.exec(text);
    if (!found) return text;
    const number = Number(found[1].replace(',', '.')), scale = { mm: 0.001, cm: 0.01, m: 1 }[found[2]];
    return scale ? written(number * scale / metresPer(element), 6) : found[1].replace(',', '.');
}

function setValue(element, name, value, unit) {
    const text = unit ? numberText(value.trim(), element) : value.trim();
    const changes = { [name]: text === '' ? null : text };
    // A pitched roof needs a pitch, and a flat one must not have any.
    if (name === 'roof' && ['', 'flat'].includes(text)) Object.assign(changes, { pitch: null, teeth: null });
    else if (name === 'roof' && valueOf(element, 'pitch', '') === '') changes.pitch = '30';
    board.change(setAttributes(board.text, element, changes));
}

function drawValue(element, [name, unit, choices]) {
    const id = `value-${name}`;
    const value = valueOf(element, name, '');
    const listed = name === 'wall' ? wallNames() : choices;
    const input = listed?.length
        ? h('select', { id }, [...new Set(['', ...listed, value])].map((c) => h('option', { value: c }, c || USUAL[name] || '\u2013')))
        : h('input', { id, type: 'text', value, placeholder: USUAL[name], inputmode: unit ? 'decimal' : null, autocomplete: 'off', spellcheck: 'false' });
    input.value = value;
    input.dataset.value = value;
    input.addEventListener('change', () => setValue(board.elements[element.index], name, input.value, unit));
    input.addEventListener('focus', () => { $('value-hint').textContent = HINTS[name] ?? ''; });
    input.addEventListener('keydown', (event) => {
        const step = { ArrowUp: 1, ArrowDown: -1 }[event.key];
        const number = parseFloat(input.value);
        if (!step || !unit || listed || !Number.isFinite(number)) return;
        event.preventDefault();
        const by = unit === '\u00b0' ? 1 : 0.05 / metresPer(element);
        input.value = String(Number((number + step * by).toFixed(3)));
        setValue(board.elements[element.index], name, input.value, unit);
    });
    const isWide = choices?.some((c) => c.length > 10);
    return h('div', { class: isWide ? 'value wide' : 'value' }, h('label', { for: id }, name), h('span', { class: 'field' }, input, unit && h('span', { class: 'unit' }, unit === 'm' && metresPer(element) < 1 ? 'mm' : unit)));
}

function drawValues() {
    const element = board.element;
    const box = $('values');
    if (!element) {
        replaceChildren(box, h('p', { class: 'hint' }, 'Click a window, a wall or another part in the drawing, or choose it in the list. Drag its handles, or move them with the arrow keys, in steps of 5 cm; hold Alt to move them freely.'));
        return;
    }
    replaceChildren(box, h('h2', {}, labelOf(element)), h('div', { class: 'value-grid' }, attributesOf(element).map((a) => drawValue(element, a))));
}

function boundsOfRoom() {
    const scene = board.results.scene;
    if (!scene) return [0, 4, 0, 5];
    const points = scene.surfaces.slice(0, scene.faces).flatMap((f) => pointsOf(f.xyz));
    return [...rangeOf(points, 0), ...rangeOf(points, 1)];
}

function wallNames() {
    return [...new Set((board.results.scene?.surfaces ?? []).filter((f) => f.role === 'wall' && f.name).map((f) => f.name))];
}

// Names of the walls: first that of the selected part, or of the first window.
function wallsForNew() {
    const used = valueOf(board.element, 'wall') ?? valueOf(board.parts.find((e) => e.name === 'window'), 'wall');
    const names = wallNames();
    return [...new Set([...(used ? [used] : []), ...names, ...(names.length ? [] : ['south'])])];
}

// A free place in a wall for a window, to the right of `from` if possible, 0.2 m from other windows
// and from the ends; null if there is none.
function placeInWall(wall, width, from = 0) {
    const { scene } = board.results, face = scene ? surfaceOfWall(scene, wall) : -1;
    if (face < 0) return null;
    const length = rangeOf(wallAxes(scene.surfaces[face]).outline, 0)[1];
    const taken = board.parts.filter((e) => e.name === 'window' && valueOf(e, 'wall') === wall)
        .map((e) => [lengthOf(e, 'left') - 0.2, lengthOf(e, 'left') + lengthOf(e, 'width') + 0.2]);
    const isFree = (left) => left + width <= length - 0.2 + 1e-9 && taken.every(([a, b]) => left + width <= a + 1e-9 || left >= b - 1e-9);
    const lefts = [0.2, ...taken.map(([, b]) => Math.max(0.2, b))].sort((a, b) => a - b).filter(isFree);
    const left = lefts.find((l) => l >= from) ?? lefts[0];
    return left === undefined ? null : { wall, left: written(left, 2), width: written(width, 2) };
}

function placeOfWindow() {
    for (const width of [1.2, 0.8, 0.5])
        for (const wall of wallsForNew()) {
            const place = placeInWall(wall, width);
            if (place) return place;
        }
    return { wall: wallsForNew()[0], left: '0.2', width: '0.5' };
}

// The middle of the room, or the nearest place without a rooflight within 0.2 m.
function placeOfRooflight(bounds) {
    const taken = board.parts.filter((e) => e.name === 'rooflight').map((e) => ['x', 'y', 'width', 'depth'].map((name) => lengthOf(e, name)));
    const middle = [(bounds[0] + bounds[1]) / 2 - 0.5, (bounds[2] + bounds[3]) / 2 - 0.5];
    const isFree = ([x, y]) => taken.every(([a, b, w, d]) => x >= a + w + 0.2 || x + 1.2 <= a || y >= b + d + 0.2 || y + 1.2 <= b);
    const places = [middle];
    for (let x = bounds[0] + 0.2; x + 1.2 <= bounds[1]; x += 0.2)
        for (let y = bounds[2] + 0.2; y + 1.2 <= bounds[3]; y += 0.2) places.push([x, y]);
    const far = ([x, y]) => Math.hypot(x - middle[0], y - middle[1]);
    const [x, y] = places.filter(isFree).sort((p, q) => far(p) - far(q))[0] ?? middle;
    return { x: written(x, 2), y: written(y, 2) };
}

const PLACES = { window: placeOfWindow, rooflight: placeOfRooflight, skyline: () => ({ wall: wallsWithoutSkyline()[0] }) };

// A wall may have one skyline.
function wallsWithoutSkyline() {
    return wallsForNew().filter((wall) => !board.parts.some((e) => e.name === 'skyline' && valueOf(e, 'wall') === wall));
}

const SINGLE = ['working-plane', 'sky'];

// The text of an element that is in metres, in the unit of the room's file.
function inFileUnits(xml) {
    const own = readElements(xml)[0], lengths = KINDS[own.name].attributes.filter(([name, unit]) => unit === 'm' && own.attributes[name]);
    const changes = lengths.map(([name]) => [name, own.attributes[name].value.split(' ').map((word) => writtenLength(board.room, Number(word))).join(' ')]);
    return setAttributes(xml, own, Object.fromEntries(changes));
}

// Adds a part and selects it: after the last one of its kind or, if there is none, at its position
// in the order of a room file.
function add(kind) {
    const room = board.room, present = board.parts.find((e) => e.name === kind);
    if (!room || !NEW_PARTS[kind]) return;
    if (present && (SINGLE.includes(kind) || (kind === 'skyline' && !wallsWithoutSkyline().length))) {
        board.select(present.index);
        return;
    }
    const bounds = boundsOfRoom();
    const xml = inFileUnits(NEW_PARTS[kind](bounds, PLACES[kind]?.(bounds)));
    const isChild = kind === 'blind';
    const parent = isChild ? (board.element?.name === 'window' ? board.element : board.parts.find((e) => e.name === 'window')) : room;
    if (!parent) return;
    const former = isChild && parent.children.find((e) => e.name === kind);
    if (former) {
        board.select(former.index);
        return;
    }
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
    let own = readElements(xml)[0];
    if (element.name === 'window') {
        const left = lengthOf(element, 'left'), width = lengthOf(element, 'width');
        const wall = valueOf(element, 'wall');
        const place = placeInWall(wall, width, left + width) ?? wallsForNew().map((other) => placeInWall(other, width)).find(Boolean);
        if (!place) {
            say('No wall has a free place for another window of this width.', true);
            return;
        }
        if (place.wall !== wall) xml = setAttributes(xml, own, { wall: place.wall, left: writtenLength(element, Number(place.left)) });
        moved.left = place.wall === wall ? Number(place.left) - left : 0;
    } else if (Number.isFinite(lengthOf(element, 'width'))) {
        moved.x = lengthOf(element, 'width') + 0.2;
    }
    own = readElements(xml)[0];
    for (const [name, by] of Object.entries(moved)) {
        const value = parseFloat(own.attributes[name]?.value);
        if (Number.isFinite(value)) {
            xml = setAttributes(xml, own, { [name]: written(value + by / metresPer(element)) });
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

// Marks the fields in which the engine found mistakes.
function markMistakes() {
    const wrong = board.results.mistakes.map((m) => partAt(board.text, board.elements, m.line, m.column)).filter((p) => p?.element === board.element);
    for (const input of $('values').querySelectorAll('input, select')) {
        if (wrong.some((p) => input.id === `value-${p.name}`)) input.setAttribute('aria-invalid', 'true');
        else input.removeAttribute('aria-invalid');
    }
}

export function setUpProperties() {
    $('parts').addEventListener('change', (event) => board.select(Number(event.target.value)));
    $('add').append(...Object.keys(NEW_PARTS).map((kind) => h('option', { value: kind }, `${KINDS[kind].label}${ABOUT_NEW[kind] ?? ''}`)));
    $('add').addEventListener('change', (event) => {
        add(event.target.value);
        event.target.value = '';
    });
    $('copy').addEventListener('click', copySelected);
    $('delete').addEventListener('click', deleteSelected);
    const draw = () => {
        drawParts();
        if (!$('values').contains(document.activeElement)) $('value-hint').textContent = '';
        drawValues();
        const name = board.element?.name;
        $('copy').disabled = !PLACED.includes(name);
        $('delete').disabled = !name || ['room', 'building', 'plan', 'envelope'].includes(name);
    };
    board.on('text selection', draw);
    board.on('results', (event) => { if ('mistakes' in event.detail) markMistakes(); });
    draw();
}
