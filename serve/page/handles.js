// handles.js - the handles of the selected element, by view. A handle has a position in its view,
// and states which attributes a drag to another position sets.
//
//     { key, at: [a, b], label, drag: ([a, b]) => [[element, changes], ...], axes: 'xy' }
//
// Views: plan (x, y), elevation (u, v of a wall), section (s, z).

import { lengthOf, lengthsOf, numberOf, valueOf, written, writtenLength } from './room_text.js';
import { pointsOf, rangeOf, wallAxes } from './geometry.js';

const SMALLEST = 0.05; // m: of a window or block

export function surfaceOfWall(scene, name) {
    return scene.surfaces.findIndex((s, i) => i < scene.faces && s.role !== 'floor' && s.name === name);
}

// The opening of the scene that was made from an element, found by its line and its index among the
// openings on that line.
export function openingOf(scene, elements, element) {
    const same = elements.filter((e) => ['window', 'rooflight', 'opening'].includes(e.name) && e.line === element.line);
    return scene.openings.filter((o) => o.line === element.line)[same.indexOf(element)] ?? null;
}

function place(element, names, values) {
    return [[element, Object.fromEntries(names.map((name, i) => [name, writtenLength(element, values[i])]))]];
}

function vertexHandles(element) {
    return element.children.filter((c) => c.name === 'vertex').map((vertex, i) => ({
        key: `vertex-${i}`, at: [lengthOf(vertex, 'x'), lengthOf(vertex, 'y')], label: `corner ${i + 1}`, axes: 'xy',
        drag: (p) => place(vertex, ['x', 'y'], p),
    }));
}

function boxHandles(element, names = ['width', 'depth']) {
    const x = lengthOf(element, 'x'), y = lengthOf(element, 'y');
    const width = lengthOf(element, names[0]), depth = lengthOf(element, names[1]);
    const turn = numberOf(element, 'rotate', 0) * Math.PI / 180;
    const ex = [Math.cos(turn), Math.sin(turn)], ey = [-ex[1], ex[0]];
    const at = (a, b) => [x + a * ex[0] + b * ey[0], y + a * ex[1] + b * ey[1]];
    const into = (p, e) => (p[0] - x) * e[0] + (p[1] - y) * e[1];
    const handles = [
        { key: 'middle', at: at(width / 2, depth / 2), label: 'place', axes: 'xy',
          drag: (p) => { const m = at(width / 2, depth / 2); return place(element, ['x', 'y'], [x + p[0] - m[0], y + p[1] - m[1]]); } },
        { key: 'width', at: at(width, depth / 2), label: 'width', axes: Math.abs(ex[0]) > 0.7 ? 'x' : 'y',
          drag: (p) => place(element, [names[0]], [Math.max(SMALLEST, into(p, ex))]) },
        { key: 'depth', at: at(width / 2, depth), label: 'depth', axes: Math.abs(ey[1]) > 0.7 ? 'y' : 'x',
          drag: (p) => place(element, [names[1]], [Math.max(SMALLEST, into(p, ey))]) },
    ];
    if (element.name === 'block')
        handles.push({ key: 'rotate', at: at(width + 1, 0), label: 'turn', axes: 'xy', isFree: true,
            drag: (p) => [[element, { rotate: written(Math.round(Math.atan2(p[1] - y, p[0] - x) * 180 / Math.PI), 0) }]] });
    return handles;
}

// The part of a wall around a window that no other window beside it takes: [from, to].
function roomInWall(element, axes) {
    const side = (e, name, extent) => [lengthOf(e, name), lengthOf(e, name) + lengthOf(e, extent)];
    const [left, right] = side(element, 'left', 'width'), [sill, head] = side(element, 'sill', 'height');
    const others = (element.parent?.children ?? []).filter((e) => e !== element && e.name === 'window' && valueOf(e, 'wall') === valueOf(element, 'wall'))
        .filter((e) => { const [low, high] = side(e, 'sill', 'height'); return low < head && high > sill; }).map((e) => side(e, 'left', 'width'));
    const middle = (left + right) / 2, beside = (a, b) => (a + b) / 2 < middle;
    return [Math.max(0, ...others.filter(([a, b]) => beside(a, b)).map(([, b]) => b)),
            Math.min(rangeOf(axes.outline, 0)[1], ...others.filter(([a, b]) => !beside(a, b)).map(([a]) => a))];
}

function windowHandles(scene, element, view) {
    const face = surfaceOfWall(scene, valueOf(element, 'wall'));
    if (face < 0) return [];
    const axes = wallAxes(scene.surfaces[face]);
    const left = lengthOf(element, 'left'), width = lengthOf(element, 'width');
    const sill = lengthOf(element, 'sill'), height = lengthOf(element, 'height');
    const [from, to] = roomInWall(element, axes), top = rangeOf(axes.outline, 1)[1];
    const toPlace = (u) => Math.max(from, Math.min(u - width / 2, to - width));
    const toLeft = (u) => { const l = Math.min(Math.max(from, u), left + width - SMALLEST); return place(element, ['left', 'width'], [l, left + width - l]); };
    const toRight = (u) => place(element, ['width'], [Math.max(SMALLEST, Math.min(u, to) - left)]);
    const toSill = (v) => { const s = Math.min(Math.max(0, v), sill + height - SMALLEST); return place(element, ['sill', 'height'], [s, sill + height - s]); };
    const toHead = (v) => place(element, ['height'], [Math.max(SMALLEST, Math.min(v, top) - sill)]);
    if (view === 'elevation')
        return [
            { key: 'middle', at: [left + width / 2, sill + height / 2], label: 'place', axes: 'xy',
              drag: ([u, v]) => place(element, ['left', 'sill'], [toPlace(u), Math.max(0, Math.min(v - height / 2, top - height))]) },
            { key: 'left', at: [left, sill + height / 2], label: 'left edge', axes: 'x', drag: ([u]) => toLeft(u) },
            { key: 'right', at: [left + width, sill + height / 2], label: 'right edge', axes: 'x', drag: ([u]) => toRight(u) },
            { key: 'sill', at: [left + width / 2, sill], label: 'sill', axes: 'y', drag: ([, v]) => toSill(v) },
            { key: 'head', at: [left + width / 2, sill + height], label: 'head', axes: 'y', drag: ([, v]) => toHead(v) },
        ];
    if (view === 'plan') {
        const on = (u) => axes.from([u, sill]).slice(0, 2);
        const along = (p) => axes.to([p[0], p[1], 0])[0];
        const direction = Math.abs(axes.along[0]) > 0.7 ? 'x' : Math.abs(axes.along[1]) > 0.7 ? 'y' : 'xy';
        return [
            { key: 'middle', at: on(left + width / 2), label: 'place', axes: direction, drag: (p) => place(element, ['left'], [toPlace(along(p))]) },
            { key: 'left', at: on(left), label: 'left edge', axes: direction, drag: (p) => toLeft(along(p)) },
            { key: 'right', at: on(left + width), label: 'right edge', axes: direction, drag: (p) => toRight(along(p)) },
        ];
    }
    return [];
}

// Handles for heights in the section: of sill and head if the section cuts the wall, of the room,
// of the working plane and of blocks. cut: the view of the section, which converts positions to s.
function sectionHandles(scene, element, cut) {
    if (element.name === 'window') {
        const s = cut.placeOfWall(valueOf(element, 'wall'));
        if (s === null) return [];
        const sill = lengthOf(element, 'sill'), height = lengthOf(element, 'height');
        return [
            { key: 'sill', at: [s, sill], label: 'sill', axes: 'y', drag: ([, z]) => { const v = Math.min(Math.max(0, z), sill + height - SMALLEST); return place(element, ['sill', 'height'], [v, sill + height - v]); } },
            { key: 'head', at: [s, sill + height], label: 'head', axes: 'y', drag: ([, z]) => place(element, ['height'], [Math.max(SMALLEST, z - sill)]) },
        ];
    }
    if (element.name === 'plan') {
        const eaves = lengthOf(element, 'height'), pitch = numberOf(element, 'pitch') * Math.PI / 180;
        const run = (scene.height - eaves) / Math.tan(pitch); // horizontal length of a slope
        const roof = run > 0 ? [{ key: 'pitch', at: [cut.middle, scene.height], label: 'pitch of the roof', axes: 'y', isFree: true,
            drag: ([, z]) => [[element, { pitch: written(Math.min(85, Math.max(1, Math.round(Math.atan2(z - eaves, run) * 180 / Math.PI))), 0) }]] }] : [];
        return [{ key: 'height', at: [cut.middle, eaves], label: 'height', axes: 'y', drag: ([, z]) => place(element, ['height'], [Math.max(1, z)]) }, ...roof];
    }
    if (element.name === 'working-plane')
        return [{ key: 'plane', at: [cut.middle, lengthOf(element, 'height', scene['working-plane'])], label: 'height', axes: 'y', drag: ([, z]) => place(element, ['height'], [Math.max(0, z)]) }];
    if (element.name === 'block') {
        const s = cut.placeOfBlock(element.line);
        const top = lengthOf(element, 'base', 0) + lengthOf(element, 'height');
        return s === null ? [] : [{ key: 'top', at: [s, top], label: 'height', axes: 'y', drag: ([, z]) => place(element, ['height'], [Math.max(SMALLEST, z - lengthOf(element, 'base', 0))]) }];
    }
    if (element.name === 'skyline') {
        const eye = cut.eyeOfWall(valueOf(element, 'wall'));
        if (!eye) return [];
        const reach = 2.5, angle = numberOf(element, 'angle', 0) * Math.PI / 180;
        return [{ key: 'angle', at: [eye.s + eye.side * reach * Math.cos(angle), eye.z + reach * Math.sin(angle)], label: 'angle', axes: 'y', isFree: true,
            drag: ([s, z]) => [[element, { angle: written(Math.min(89, Math.max(0, Math.round(Math.atan2(z - eye.z, Math.max(0.01, (s - eye.s) * eye.side)) * 180 / Math.PI))), 0) }]] }];
    }
    return [];
}

// Handles whose position is known: a value may be missing, or not a number, while it is being
// typed.
export function handlesOf(...view) {
    return placedHandles(...view).filter((handle) => handle.at.every(Number.isFinite));
}

// Handles of an element in a view; `wall` is the index of the surface that an elevation shows.
function placedHandles(view, element, scene, { wall = -1, cut = null } = {}) {
    if (!element || !scene) return [];
    if (view === 'section') return cut ? sectionHandles(scene, element, cut) : [];
    if (element.name === 'window') {
        if (view === 'elevation' && surfaceOfWall(scene, valueOf(element, 'wall')) !== wall) return [];
        return windowHandles(scene, element, view);
    }
    if (view !== 'plan') return [];
    switch (element.name) {
    case 'plan': {
        if (element.children.length) return vertexHandles(element);
        const width = lengthOf(element, 'width'), depth = lengthOf(element, 'depth');
        return [
            { key: 'width', at: [width, depth / 2], label: 'width', axes: 'x', drag: ([x]) => place(element, ['width'], [Math.max(0.5, x)]) },
            { key: 'depth', at: [width / 2, depth], label: 'depth', axes: 'y', drag: ([, y]) => place(element, ['depth'], [Math.max(0.5, y)]) },
        ];
    }
    case 'vertex':
        return [{ key: 'vertex', at: [lengthOf(element, 'x'), lengthOf(element, 'y')], label: 'corner', axes: 'xy', drag: (p) => place(element, ['x', 'y'], p) }];
    case 'point':
        return [{ key: 'point', at: [lengthOf(element, 'x'), lengthOf(element, 'y')], label: 'place', axes: 'xy', drag: (p) => place(element, ['x', 'y'], p) }];
    case 'line': case 'partition':
        return ['from', 'to'].map((name) => ({ key: name, at: lengthsOf(element, name).slice(0, 2), label: name === 'from' ? 'beginning' : 'end', axes: 'xy',
            drag: (p) => [[element, { [name]: [...p, ...lengthsOf(element, name).slice(2)].map((c) => writtenLength(element, c)).join(' ') }]] }));
    case 'rooflight': case 'block': case 'furniture': case 'column':
        return boxHandles(element);
    case 'opening': case 'surface': case 'face': case 'garden':
        return vertexHandles(element);
    case 'skyline': {
        const face = surfaceOfWall(scene, valueOf(element, 'wall')), distance = lengthOf(element, 'distance');
        if (face < 0 || !Number.isFinite(distance)) return [];
        const axes = wallAxes(scene.surfaces[face]);
        const [low, high] = rangeOf(pointsOf(scene.surfaces[face].xyz).map((p) => [axes.to(p)[0]]), 0);
        const foot = axes.from([(low + high) / 2, 0]);
        return [{ key: 'distance', at: [foot[0] + axes.outwards[0] * distance, foot[1] + axes.outwards[1] * distance], label: 'distance',
            axes: Math.abs(axes.outwards[1]) > 0.7 ? 'y' : 'x',
            drag: (p) => place(element, ['distance'], [Math.max(0.5, (p[0] - foot[0]) * axes.outwards[0] + (p[1] - foot[1]) * axes.outwards[1])]) }];
    }
    default:
        return [];
    }
}
