// section_view.js - below the plan: the section, at the plan's scale, with the curves of the
// daylight factor over it; or the elevation of a wall from outside.

import { board } from './board.js';
import { s, pathOf, replaceChildren } from './dom.js';
import { cutBy, isInPlane, pointsOf, rangeOf, wallAxes } from './geometry.js';
import { handlesOf, openingOf, surfaceOfWall } from './handles.js';
import { drawHandles, listenToDrags } from './drag.js';
import { lengthOf, lengthsOf, valueOf } from './room_text.js';
import { drawScale, mappingOf } from './plan_view.js';
import { labelOf } from './kinds.js';

// Where the section is taken: { at, direction, range }: through the first line of points, or
// perpendicular to the wall of the selected window or skyline, or of the first window.
export function chooseCut(scene) {
    const line = board.parts.find((e) => e.name === 'line');
    const chosen = ['window', 'skyline'].includes(board.element?.name) ? board.element : null;
    const element = chosen ?? (line ? null : board.parts.find((e) => e.name === 'window'));
    const floor = scene.surfaces.slice(0, scene.faces).filter((f) => f.role !== 'ceiling').flatMap((f) => pointsOf(f.xyz));
    let at, direction;
    if (element && surfaceOfWall(scene, valueOf(element, 'wall')) >= 0) {
        const axes = wallAxes(scene.surfaces[surfaceOfWall(scene, valueOf(element, 'wall'))]);
        const [low, high] = rangeOf(axes.outline, 0);
        const u = element.name === 'window' ? lengthOf(element, 'left', 0) + lengthOf(element, 'width', 0) / 2 : (low + high) / 2;
        at = axes.from([u, 0]).slice(0, 2);
        direction = [-axes.outwards[0], -axes.outwards[1]];
        const length = Math.hypot(...direction);
        if (length < 0.1) return null;
        direction = direction.map((c) => c / length);
    } else if (line) {
        const ends = ['from', 'to'].map((name) => lengthsOf(line, name));
        const by = [ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]], length = Math.hypot(...by);
        if (!(length > 0)) return null;
        at = ends[0].slice(0, 2);
        direction = by.map((c) => c / length);
    } else {
        const x = rangeOf(floor, 0), y = rangeOf(floor, 1);
        at = [(x[0] + x[1]) / 2, y[0]];
        direction = [0, 1];
    }
    const along = floor.map((p) => [(p[0] - at[0]) * direction[0] + (p[1] - at[1]) * direction[1]]);
    const ends = scene.surfaces.slice(0, scene.faces).filter((f) => f.role === 'floor').flatMap((f) => cutBy(pointsOf(f.xyz), at, direction).flat());
    return { at, direction, range: rangeOf(ends.length ? ends : along, 0) };
}

// Points for the curve: along the cut, from 0.25 m inside its ends, or a tenth of its length if
// that is less.
export function pointsOfCut(scene, cut, count = 33) {
    const inset = Math.min(0.25, (cut.range[1] - cut.range[0]) / 10);
    const points = [];
    for (let i = 0; i < count; i++) {
        const l = cut.range[0] + inset + (cut.range[1] - cut.range[0] - 2 * inset) * i / (count - 1);
        points.push([cut.at[0] + l * cut.direction[0], cut.at[1] + l * cut.direction[1]]);
    }
    return points.filter((p) => isInPlane(scene.plane, p));
}

function cutOfScene(scene, cut) {
    const section = (points) => cutBy(points, cut.at, cut.direction);
    const along = (p) => (p[0] - cut.at[0]) * cut.direction[0] + (p[1] - cut.at[1]) * cut.direction[1];
    const wall = (name) => scene.surfaces[surfaceOfWall(scene, name)];
    const placeOfWall = (name) => {
        const found = wall(name) && section(pointsOf(wall(name).xyz))[0];
        return found ? found[0][0] : null;
    };
    return {
        section, along, placeOfWall,
        middle: (cut.range[0] + cut.range[1]) / 2,
        placeOfBlock: (line) => {
            const block = scene.blocks.findIndex((b) => b.line === line);
            const points = scene.surfaces.filter((f) => f.role === 'block' && f.owner === block).flatMap((f) => pointsOf(f.xyz));
            return points.length ? (Math.min(...points.map(along)) + Math.max(...points.map(along))) / 2 : null;
        },
        eyeOfWall: (name) => {
            const at = placeOfWall(name), skyline = scene.skylines.find((k) => scene.surfaces[k.face]?.name === name);
            return at === null || !skyline ? null : { s: at, z: skyline.from, side: at < (cut.range[0] + cut.range[1]) / 2 ? -1 : 1 };
        },
    };
}

function drawSkylines(scene, cut, to, width) {
    return scene.skylines.map((skyline) => {
        const eye = cut.eyeOfWall(scene.surfaces[skyline.face]?.name);
        if (!eye) return null;
        const reach = 60, angle = skyline.angle * Math.PI / 180;
        const end = [eye.s + eye.side * reach * Math.cos(angle), eye.z + reach * Math.sin(angle)];
        const places = [2, 1.5, 1, 0.5].map((l) => to([eye.s + eye.side * l * Math.cos(angle), eye.z + l * Math.sin(angle)]));
        const at = places.find(([x]) => x > 4 && x < width - 30) ?? places[3];
        return s('g', { class: 'skyline' }, s('path', { d: pathOf([to([eye.s, eye.z]), to(end)]) }),
            s('text', { x: at[0], y: at[1] - 8 }, `${Number(skyline.angle.toFixed(1))}\u00b0`));
    });
}

function drawSection(scene, cut, to) {
    const nodes = [];
    for (const surface of scene.surfaces) {
        const kind = surface.role === 'block' ? 'block' : surface.role === 'skyline' ? 'skyline' : surface.inside ? 'walls' : 'facade';
        for (const segment of cut.section(pointsOf(surface.xyz)))
            nodes.push(s('path', { class: `${kind} line`, d: pathOf(segment.map(to)) }));
    }
    const glass = board.parts.filter((e) => ['window', 'rooflight', 'opening'].includes(e.name)).flatMap((element) => {
        const opening = openingOf(scene, board.elements, element);
        if (!opening) return [];
        return cut.section(pointsOf(opening.inner)).map((segment) => s('path', {
            class: `glass${element.index === board.selected ? ' selected' : ''}`, d: pathOf(segment.map(to)),
            'data-element': element.index }, s('title', {}, labelOf(element))));
    });
    const z = scene['working-plane'], ends = [to([cut.range[0], z]), to([cut.range[1], z])];
    const plane = s('path', { class: 'plane', d: pathOf(ends) });
    const element = board.parts.find((e) => e.name === 'working-plane');
    if (element) plane.setAttribute('data-element', element.index);
    return [...nodes, ...glass, plane];
}

// The curve of the contours' method, drawn from the working plane upwards, with its scale to the
// right of the room. 1 m of height is a round number of per cent.
function drawCurve(scene, cut, to) {
    const section = board.results.section;
    if (!section?.points.length) return null;
    const first = (p, part) => Object.values(p[part] ?? {})[0]?.value;
    const values = section.points.map((p) => first(p, 'df') ?? first(p, 'sc')).map((v, i) => [cut.along([section.points[i].x, section.points[i].y]), v]);
    const shown = values.filter(([, v]) => v !== null && v !== undefined);
    const most = Math.max(...shown.map(([, v]) => v));
    const room = scene.height - scene['working-plane'];
    const step = [0.5, 1, 2, 5, 10, 20, 50].find((k) => most / k <= room) ?? 50;
    const at = ([l, v]) => to([l, scene['working-plane'] + v / step]);
    if (!shown.length) return null;
    const pixels = (v) => Math.abs(at([0, v])[1] - at([0, 0])[1]);
    const tick = [0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50].find((v) => pixels(v) >= 22) ?? 100;
    const x = to([cut.range[1], 0])[0] + 9, y = (v) => at([0, v])[1];
    const ticks = Array.from({ length: Math.floor(room * step / tick) + 1 }, (_, i) => Number((i * tick).toPrecision(3)));
    return s('g', { class: 'curve' }, s('path', { d: pathOf(shown.map(at)) }),
        s('path', { class: 'axis', d: `M${x} ${y(0)}V${y(ticks[ticks.length - 1])}${ticks.map((v) => `M${x} ${y(v)}h5`).join('')}` }),
        ticks.map((v) => s('text', { x: x + 8, y: y(v) + 4 }, `${v} %`)));
}

export function createSectionView(svg, scaleOf) {
    let drawn = null, fit = null;
    listenToDrags(svg, () => drawn);
    return function draw(mode) {
        const { scene } = board.results;
        if (!scene) return;
        const { width, height } = svg.getBoundingClientRect();
        svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
        if (!board.isHeld || !fit) fit = { ...scaleOf(), mapping: null }; // as in the plan
        if (mode === 'elevation') drawn = drawElevation(svg, scene, width, height, fit);
        else drawn = drawCutView(svg, scene, width, height, fit);
    };
}

// Ranges of the section: of the room, with the ground if it is near; or of everything outside that
// the section meets.
function boundsOfCut(scene, cut, withOutside) {
    const room = [cut.range[0], cut.range[1], bottomOf(scene), scene.height];
    if (!withOutside) return room;
    const ends = scene.surfaces.filter((f) => f.role === 'block').flatMap((f) => cut.section(pointsOf(f.xyz)).flat());
    const all = [...ends, [room[0], Math.min(0, scene.ground)], [room[1], room[3]]];
    return [...rangeOf(all, 0), ...rangeOf(all, 1)];
}

const DEEPEST = 1; // m below the floor: ground further down is not shown
export function bottomOf(scene) {
    return Math.max(-DEEPEST, Math.min(0, scene.ground));
}

function drawCutView(svg, scene, width, height, fit) {
    const { scale: planScale, withOutside } = fit;
    if (!board.cut) {
        replaceChildren(svg, s('text', { class: 'empty', x: 16, y: 28 }, 'There is no section of this room.'));
        return null;
    }
    const cut = { ...board.cut, ...cutOfScene(scene, board.cut) };
    const bounds = boundsOfCut(scene, cut, withOutside);
    const scale = withOutside ? Math.min(planScale, (width - 100) / (bounds[1] - bounds[0]), (height - 50) / (bounds[3] - bounds[2])) : planScale;
    const mapping = fit.mapping ??= mappingOf(bounds, width, height, scale);
    const view = { name: 'section', ...mapping, handles: handlesOf('section', board.element, scene, { cut }) };
    const ground = mapping.toScreen([0, scene.ground])[1];
    replaceChildren(svg, s('title', {}, 'Section'), s('path', { class: 'ground', d: `M0 ${ground}H${width}` }),
        drawSkylines(scene, cut, mapping.toScreen, width), drawSection(scene, cut, mapping.toScreen), drawCurve(scene, cut, mapping.toScreen),
        scale !== planScale && drawScale(scale, width, height), drawHandles(view));
    return view;
}

// The wall that an elevation shows: of what is selected, or of the first window.
function wallOfElevation(scene) {
    const hasWall = (e) => e && valueOf(e, 'wall') !== undefined && surfaceOfWall(scene, valueOf(e, 'wall')) >= 0;
    const element = [board.element, board.element?.parent, ...board.parts.filter((e) => e.name === 'window')].find(hasWall);
    const face = element ? surfaceOfWall(scene, valueOf(element, 'wall')) : scene.openings[0]?.face ?? -1;
    return face >= 0 ? face : scene.surfaces.findIndex((f) => f.role === 'wall');
}

function drawElevation(svg, scene, width, height, fit) {
    const wall = wallOfElevation(scene);
    if (wall < 0) return null;
    const surface = scene.surfaces[wall], axes = wallAxes(surface);
    const bounds = [...rangeOf(axes.outline, 0), ...rangeOf(axes.outline, 1)];
    const mapping = fit.mapping ??= mappingOf(bounds, width, height, Math.min(fit.scale, (width - 24) / (bounds[1] - bounds[0]), (height - 40) / (bounds[3] - bounds[2])));
    const to = mapping.toScreen;
    const view = { name: 'elevation', ...mapping, handles: handlesOf('elevation', board.element, scene, { wall }) };
    const openings = board.parts.filter((e) => ['window', 'rooflight', 'opening'].includes(e.name)).map((element) => {
        const opening = openingOf(scene, board.elements, element);
        if (opening?.face !== wall) return null;
        return s('path', { class: `glass${element.index === board.selected ? ' selected' : ''}`, 'data-element': element.index,
            d: pathOf(pointsOf(opening.inner).map((p) => to(axes.to(p))), true) }, s('title', {}, labelOf(element)));
    });
    const names = scene.openings.filter((o) => o.face === wall && scene.openings.length > 1).map((o) => {
        const corners = pointsOf(o.inner).map((p) => to(axes.to(p)));
        return s('text', { x: rangeOf(corners, 0)[0] + 6, y: rangeOf(corners, 1)[0] + 16 }, o.label);
    });
    replaceChildren(svg, s('title', {}, `Elevation of wall ${surface.name ?? ''} from outside`),
        s('path', { class: 'walls', d: pathOf(axes.outline.map(to), true) }), openings, names,
        s('text', { class: 'caption', x: 12, y: 20 }, `Wall ${surface.name ?? ''} from outside`), drawHandles(view));
    return view;
}
