// plan_view.js - the plan: the room's outline, openings, blocks, points, contours with colours
// between them, the no-sky line, and the handles of what is selected.

import { board } from './board.js';
import { s, pathOf, figure, replaceChildren } from './dom.js';
import { isInPlane, pairsOf, pointsOf, rangeOf, scenePlanBounds, wallAxes } from './geometry.js';
import { handlesOf, openingOf } from './handles.js';
import { drawHandles, listenToDrags } from './drag.js';
import { labelOf } from './kinds.js';

// Lower limits (per cent) of the colours from the second one on, which are classes of the style
// sheet.
const STEPS = [0.2, 0.5, 1, 2, 3, 5, 10, 20];
export function bandOf(level) {
    return STEPS.filter((step) => level >= step - 1e-9).length;
}

// One scale for plan and section: pixels per metre.
export function scaleFor(bounds, width, height, margin) {
    return Math.max(2, Math.min((width - 2 * margin) / (bounds[1] - bounds[0]), (height - 2 * margin) / (bounds[3] - bounds[2])));
}

export function mappingOf(bounds, width, height, scale) {
    const left = (width - scale * (bounds[1] - bounds[0])) / 2 - scale * bounds[0];
    const bottom = (height + scale * (bounds[3] - bounds[2])) / 2 + scale * bounds[2];
    return {
        toScreen: ([x, y]) => [left + scale * x, bottom - scale * y],
        toPlace: ([x, y]) => [(x - left) / scale, (bottom - y) / scale],
    };
}

// Fills the plane with the colour of the highest value, then, from the highest level down, the area
// below each level with the colour of the next lower one.
function drawBands(plan, plane, to) {
    if (!plan?.contours.length) return [];
    const levels = [...new Set(plan.contours.map((c) => c.level))].sort((a, b) => b - a);
    const outline = plane.map((ring) => pathOf(pairsOf(ring).map(to), true)).join('');
    const ground = s('path', { class: `band band-${bandOf(plan.highest.value)}`, d: outline, 'fill-rule': 'evenodd' });
    return [ground, ...levels.map((level, i) => {
        const rings = plan.below.filter((b) => Math.abs(b.level - level) < 1e-9).map((b) => pathOf(pairsOf(b.xy).map(to), true)).join('');
        const under = levels[i + 1] ?? plan.lowest.value;
        return rings && s('path', { class: `band band-${bandOf(under)}`, d: rings, 'fill-rule': 'evenodd' });
    })];
}

// Labels of contours leave the places `taken` on the screen free, and the edge of the plane; also
// the `points` of the room, unless a label then has no place at all.
function drawContours(scene, plan, to, taken) {
    if (!plan) return [];
    const labels = [], points = scene.points.map((p) => to([p.x, p.y])), plane = scene.plane.flatMap((ring) => pairsOf(ring).map(to));
    const [left, right] = rangeOf(plane, 0), [top, bottom] = rangeOf(plane, 1);
    const isNear = (list, x, y, dx, dy) => list.some(([a, b]) => Math.abs(a - x) < dx && Math.abs(b - y) < dy);
    const isFree = ([x, y]) => x > left + 18 && x < right - 18 && y > top + 9 && y < bottom - 9 && !isNear(labels.map((l) => [l.x, l.y]), x, y, 44, 16) && !isNear(taken, x, y, 26, 16);
    const isClear = ([x, y]) => !isNear(points, x, y, 20, 9);
    const lines = plan.contours.map((c) => {
        const points = pairsOf(c.xy).map(to);
        const places = [0.5, 0.42, 0.58, 0.35, 0.65, 0.27, 0.73, 0.2, 0.8].map((share) => points[Math.floor(share * (points.length - 1))]).filter(isFree);
        const place = places.find(isClear) ?? places[0];
        const length = points.reduce((sum, q, i) => (i ? sum + Math.hypot(q[0] - points[i - 1][0], q[1] - points[i - 1][1]) : 0), 0);
        if (length > 45 && place) labels.push({ x: place[0], y: place[1], level: c.level });
        return s('path', { class: 'contour', d: pathOf(points, c.closed) });
    });
    const noSky = plan['no-sky'].map((c) => pathOf(pairsOf(c.xy).map(to), c.closed)).map((d) => [s('path', { class: 'no-sky under', d }), s('path', { class: 'no-sky', d })]);
    const numbers = labels.map((l) => s('text', { class: 'level', x: l.x, y: l.y + 4 }, `${Number(l.level.toPrecision(3))} %`));
    return [...lines, ...noSky, ...numbers];
}

// Makes the drawing of an element selectable by pointer and by keys.
function pickable(element, node) {
    node.setAttribute('data-element', element.index);
    node.setAttribute('tabindex', -1);
    if (element.index === board.selected) node.classList.add('selected');
    node.append(s('title', {}, labelOf(element)));
    return node;
}

function drawRoom(scene, to) {
    const floors = scene.surfaces.slice(0, scene.faces).filter((f) => f.role === 'floor');
    const plan = board.parts.find((e) => e.name === 'plan');
    const outline = floors.map((f) => pathOf(pointsOf(f.xyz).map(to), true)).join('');
    const shape = s('path', { class: 'walls', d: outline });
    return [plan ? pickable(plan, shape) : shape];
}

// The name of each window in the results, outside its wall.
function drawLabels(scene, to) {
    if (scene.openings.length < 2) return [];
    return scene.openings.filter((o) => o.slope >= 85).map((o) => {
        const { outwards } = wallAxes(scene.surfaces[o.face]), corners = pointsOf(o.outer).map(to);
        const [x, y] = [0, 1].map((k) => corners.reduce((sum, p) => sum + p[k], 0) / corners.length);
        const anchor = outwards[0] > 0.7 ? 'start' : outwards[0] < -0.7 ? 'end' : 'middle';
        return s('text', { class: 'opening-name', 'text-anchor': anchor, x: x + 12 * outwards[0], y: y - 17 * outwards[1] + 4 }, o.label);
    });
}

function drawOpenings(scene, to) {
    return board.parts.filter((e) => ['window', 'rooflight', 'opening'].includes(e.name)).map((element) => {
        const opening = openingOf(scene, board.elements, element);
        if (!opening) return null;
        const inner = pointsOf(opening.inner).map(to), outer = pointsOf(opening.outer).map(to);
        const isFlat = opening.slope < 85;
        const d = pathOf(inner, true) + pathOf(outer, true);
        return pickable(element, s('g', {}, s('path', { class: 'grab', d: pathOf([...inner, ...outer], true) }), s('path', { class: isFlat ? 'glass flat' : 'glass', d })));
    });
}

// Places along the openings, 0.25 m or less apart.
function openingsAlong(scene) {
    return scene.openings.flatMap((o) => {
        const corners = pointsOf(o.inner);
        return corners.flatMap((a, i) => {
            const b = corners[(i + 1) % corners.length], count = Math.ceil(Math.hypot(b[0] - a[0], b[1] - a[1]) / 0.25) || 1;
            return Array.from({ length: count }, (_, k) => [a[0] + (b[0] - a[0]) * k / count, a[1] + (b[1] - a[1]) * k / count]);
        });
    });
}

// isDrawn: the scene is that of the variant which is being changed, and its blocks can be selected.
function drawOutside(scene, to, isDrawn = true) {
    const byLine = new Map();
    scene.surfaces.filter((f) => f.role === 'block' && f.owner !== undefined).forEach((f) => {
        const block = scene.blocks[f.owner];
        byLine.set(block, [...(byLine.get(block) ?? []), f]);
    });
    const blocks = [...byLine].map(([block, faces]) => {
        const lowest = faces.reduce((a, f) => Math.min(...pointsOf(f.xyz).map((p) => p[2])) === Math.max(...pointsOf(f.xyz).map((p) => p[2])) ? f : a, faces[0]);
        const shape = s('path', { class: 'block', d: pathOf(pointsOf(lowest.xyz).map(to), true) });
        const element = isDrawn && board.parts.find((e) => e.name === 'block' && e.line === block.line);
        return element ? pickable(element, shape) : shape;
    });
    const inside = scene.surfaces.filter((f) => f.role === 'surface').map((f) => s('path', { class: 'furniture', d: pathOf(pointsOf(f.xyz).map(to), true) }));
    return [...blocks, ...inside];
}

function drawPoints(scene, to) {
    const traced = board.results.trace;
    const isClose = to([1, 0])[0] - to([0, 0])[0] >= 30; // pixels per metre, so that values fit between points
    return scene.points.map((p, i) => {
        const [x, y] = to([p.x, p.y]);
        const element = board.parts.find((e) => ['point', 'line', 'grid'].includes(e.name) && e.line === p.line);
        const dot = s('circle', { class: 'point', cx: x, cy: y, r: 3 });
        const value = traced?.points[i]?.[0];
        if (element) pickable(element, dot);
        if (value === undefined || value === null) return dot;
        dot.append(s('title', {}, `${figure(value, traced.points[i][1])} %`));
        if (board.results.plan) return dot;
        // Without contours the simulated values are written.
        dot.setAttribute('class', `simulated band-${bandOf(value)}`);
        dot.setAttribute('r', 6);
        return [dot, isClose && s('text', { class: 'level', x, y: y + 17 }, figure(value))];
    });
}

export function drawScale(scale, width, height) {
    const length = [0.5, 1, 2, 5, 10, 20].find((m) => m * scale >= 50) ?? 20;
    const x = width - 14 - length * scale, y = height - 12;
    return s('g', { class: 'scale-bar', 'aria-hidden': 'true' },
        s('path', { d: `M${x} ${y - 4}v4h${(length * scale).toFixed(1)}v-4` }),
        s('text', { x: x + length * scale / 2, y: y - 6 }, `${length} m`));
}

function drawNorth(scene) {
    return s('g', { class: 'north', transform: `translate(22 32) rotate(${-scene.north})`, 'aria-hidden': 'true' },
        s('path', { d: 'M0 -14 L6 10 L0 5 L-6 10 Z' }), s('text', { y: -16 }, 'N'));
}

export function createPlanView(svg, scaleOf) {
    let drawn = null, fit = null;
    listenToDrags(svg, () => drawn);
    // The position whose figures are shown follows the pointer until a click, or a typed position,
    // keeps it.
    const point = (event) => {
        const { scene } = board.results;
        const isClick = event.type === 'pointerdown';
        if (!drawn || !scene || svg.classList.contains('dragging') || (board.isPointerKept && !isClick)) return;
        if (isClick && event.target.closest('[data-handle], [data-element]')) return;
        const box = svg.getBoundingClientRect();
        const place = drawn.toPlace([event.clientX - box.left, event.clientY - box.top]);
        if (!isInPlane(scene.plane, place)) return;
        board.isPointerKept = isClick;
        board.pointer = place;
        board.tell('pointer');
    };
    svg.addEventListener('pointermove', point);
    svg.addEventListener('pointerdown', point);
    board.on('pointer', () => { if (drawn) svg.querySelector('.place')?.replaceWith(drawPlace(drawn.toScreen)); });
    return function draw() {
        const { scene, plan } = board.results;
        if (!scene) return;
        const { width, height } = svg.getBoundingClientRect();
        // While a handle is held, the scale stays: the handle would else run away from the pointer.
        if (!board.isHeld || !fit) fit = scaleOf();
        const { bounds, scale } = fit;
        const mapping = mappingOf(bounds, width, height, scale);
        const to = mapping.toScreen;
        drawn = { name: 'plan', ...mapping, handles: handlesOf('plan', board.element, scene) };
        const taken = [...drawn.handles.map((h) => to(h.at)), ...openingsAlong(scene).map(to)];
        svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
        replaceChildren(svg,
            s('title', {}, `Plan of ${board.roomName || 'the room'}`),
            drawOutside(scene, to), drawBands(plan, scene.plane, to), drawRoom(scene, to), drawContours(scene, plan, to, taken),
            drawLabels(scene, to), drawOpenings(scene, to), drawPoints(scene, to), drawCut(drawn), drawNorth(scene), drawScale(scale, width, height), drawVariant(board.active), drawPlace(to), drawHandles(drawn));
    };
}

// A cross at the position whose figures are shown.
function drawPlace(to) {
    if (!board.pointer) return s('g', { class: 'place' });
    const [x, y] = to(board.pointer).map((c) => c.toFixed(1)), d = `M${x} ${y}m-7 0h14m-7 -7v14`;
    return s('g', { class: board.isPointerKept ? 'place kept' : 'place' }, s('path', { class: 'under', d }), s('path', { d }));
}

function drawVariant(index) {
    return board.variants.length === 2 && s('text', { class: 'variant-name', x: 44, y: 24 }, 'AB'[index]);
}

// The plan of the variant that is not being changed; a click changes to it.
export function createOtherPlan(svg, scaleOf) {
    svg.addEventListener('click', () => board.use(1 - board.active));
    return function draw() {
        const other = 1 - board.active, drawn = board.variants[other]?.drawn, { scene, plan } = drawn ?? {};
        svg.toggleAttribute('hidden', board.variants.length < 2);
        svg.parentElement.classList.toggle('swapped', other === 0); // variant A is on the left
        if (board.variants.length < 2) return;
        const { width, height } = svg.getBoundingClientRect();
        svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
        if (!scene || drawn.room !== board.roomName) {
            replaceChildren(svg, drawVariant(other));
            return;
        }
        const { bounds, scale } = scaleOf();
        const to = mappingOf(bounds, width, height, scale).toScreen;
        const floors = scene.surfaces.slice(0, scene.faces).filter((f) => f.role === 'floor');
        replaceChildren(svg, s('title', {}, `Plan of variant ${'AB'[other]}; click to change it`), drawOutside(scene, to, false), drawBands(plan, scene.plane, to),
            floors.map((f) => s('path', { class: 'walls', d: pathOf(pointsOf(f.xyz).map(to), true) })), drawContours(scene, plan, to, openingsAlong(scene).map(to)),
            drawLabels(scene, to), scene.openings.map((o) => s('path', { class: o.slope < 85 ? 'glass flat' : 'glass', d: pathOf(pointsOf(o.inner).map(to), true) + pathOf(pointsOf(o.outer).map(to), true) })),
            drawNorth(scene), drawScale(scale, width, height), drawVariant(other));
    };
}

// The line of the section.
function drawCut({ toScreen }) {
    const cut = board.cut;
    if (!cut) return null;
    const ends = [cut.range[0], cut.range[1]].map((l) => toScreen([cut.at[0] + l * cut.direction[0], cut.at[1] + l * cut.direction[1]]));
    return s('path', { class: 'cut', d: pathOf(ends) });
}

export function boundsWith(scene, withOutside) {
    return scenePlanBounds(scene, withOutside);
}
