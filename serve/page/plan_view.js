// plan_view.js - the plan: the room's outline, openings, blocks, points, contours with colours
// between them, the no-sky line, and the handles of what is selected.

import { board } from './board.js';
import { s, pathOf, figure, replaceChildren } from './dom.js';
import { pairsOf, pointsOf, scenePlanBounds } from './geometry.js';
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

// taken: places of the screen that labels leave free.
function drawContours(plan, to, taken) {
    if (!plan) return [];
    const labels = [];
    const isFree = (x, y) => !labels.some((l) => Math.abs(l.x - x) < 44 && Math.abs(l.y - y) < 16) && !taken.some((t) => Math.abs(t[0] - x) < 26 && Math.abs(t[1] - y) < 16);
    const lines = plan.contours.map((c) => {
        const points = pairsOf(c.xy).map(to);
        const place = [0.5, 0.35, 0.65, 0.2, 0.8].map((share) => points[Math.floor(share * (points.length - 1))]).find(([x, y]) => isFree(x, y));
        const length = points.reduce((sum, q, i) => (i ? sum + Math.hypot(q[0] - points[i - 1][0], q[1] - points[i - 1][1]) : 0), 0);
        if (length > 45 && place) labels.push({ x: place[0], y: place[1], level: c.level });
        return s('path', { class: 'contour', d: pathOf(points, c.closed) });
    });
    const noSky = plan['no-sky'].map((c) => s('path', { class: 'no-sky', d: pathOf(pairsOf(c.xy).map(to), c.closed) }));
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

function drawOpenings(scene, to) {
    return board.parts.filter((e) => ['window', 'rooflight', 'opening'].includes(e.name)).map((element) => {
        const opening = openingOf(scene, board.elements, element);
        if (!opening) return null;
        const inner = pointsOf(opening.inner).map(to), outer = pointsOf(opening.outer).map(to);
        const isFlat = opening.slope < 85;
        return pickable(element, s('path', { class: isFlat ? 'glass flat' : 'glass', d: pathOf(inner, true) + pathOf(outer, true) }));
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

function drawOutside(scene, to) {
    const byLine = new Map();
    scene.surfaces.filter((f) => f.role === 'block' && f.owner !== undefined).forEach((f) => {
        const block = scene.blocks[f.owner];
        byLine.set(block, [...(byLine.get(block) ?? []), f]);
    });
    const blocks = [...byLine].map(([block, faces]) => {
        const lowest = faces.reduce((a, f) => Math.min(...pointsOf(f.xyz).map((p) => p[2])) === Math.max(...pointsOf(f.xyz).map((p) => p[2])) ? f : a, faces[0]);
        const shape = s('path', { class: 'block', d: pathOf(pointsOf(lowest.xyz).map(to), true) });
        const element = board.parts.find((e) => e.name === 'block' && e.line === block.line);
        return element ? pickable(element, shape) : shape;
    });
    const inside = scene.surfaces.filter((f) => f.role === 'surface').map((f) => s('path', { class: 'furniture', d: pathOf(pointsOf(f.xyz).map(to), true) }));
    return [...blocks, ...inside];
}

function drawPoints(scene, to) {
    const traced = board.results.trace;
    return scene.points.map((p, i) => {
        const [x, y] = to([p.x, p.y]);
        const element = board.parts.find((e) => ['point', 'line', 'grid'].includes(e.name) && e.line === p.line);
        const dot = s('circle', { class: 'point', cx: x, cy: y, r: 3 });
        const value = traced?.points[i]?.[0];
        if (element) pickable(element, dot);
        if (value !== undefined && value !== null) dot.append(s('title', {}, `${figure(value, traced.points[i][1])} %`));
        return dot;
    });
}

function drawScale(scale, width, height) {
    const length = [0.5, 1, 2, 5, 10, 20].find((m) => m * scale >= 50) ?? 20;
    const x = width - 14 - length * scale, y = height - 12;
    return s('g', { class: 'scale-bar', 'aria-hidden': 'true' },
        s('path', { d: `M${x} ${y - 4}v4h${(length * scale).toFixed(1)}v-4` }),
        s('text', { x: x + length * scale / 2, y: y - 6 }, `${length} m`));
}

function drawNorth(scene) {
    return s('g', { class: 'north', transform: `translate(22 26) rotate(${-scene.north})`, 'aria-hidden': 'true' },
        s('path', { d: 'M0 -14 L6 10 L0 5 L-6 10 Z' }), s('text', { y: -16 }, 'N'));
}

export function createPlanView(svg, scaleOf) {
    let drawn = null;
    listenToDrags(svg, () => drawn);
    svg.addEventListener('pointermove', (event) => {
        if (!drawn || svg.classList.contains('dragging')) return;
        const box = svg.getBoundingClientRect();
        board.pointer = drawn.toPlace([event.clientX - box.left, event.clientY - box.top]);
        board.tell('pointer');
    });
    return function draw() {
        const { scene, plan } = board.results;
        if (!scene) return;
        const { width, height } = svg.getBoundingClientRect();
        const { bounds, scale } = scaleOf(scene);
        const mapping = mappingOf(bounds, width, height, scale);
        const to = mapping.toScreen;
        drawn = { name: 'plan', ...mapping, handles: handlesOf('plan', board.element, scene) };
        const taken = [...drawn.handles.map((h) => to(h.at)), ...openingsAlong(scene).map(to)];
        svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
        replaceChildren(svg,
            s('title', {}, `Plan of ${board.roomName || 'the room'}`),
            drawOutside(scene, to), drawBands(plan, scene.plane, to), drawRoom(scene, to), drawContours(plan, to, taken),
            drawOpenings(scene, to), drawPoints(scene, to), drawCut(drawn), drawNorth(scene), drawScale(scale, width, height), drawHandles(drawn));
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
