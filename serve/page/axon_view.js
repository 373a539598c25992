// axon_view.js - an axonometric view, rotated with the pointer or the arrow keys. Faces of the room
// whose inside is turned away from the viewer are left out, so that the inside of the room is
// visible. Sunlight through the openings is drawn on each face as the projections of the openings
// along the sun's rays, less the shadows of objects outside.

import { board } from './board.js';
import { s, pathOf, replaceChildren } from './dom.js';
import { dot, normalOf, pointsOf, shadowOn, sunDirection, sunPlace } from './geometry.js';

const CAPTIONS = 40; // height of the two lines below the view, pixels

export function createAxonView(svg, sunOf) {
    let turn = 30, tilt = 35, from = null;
    const redraw = () => draw();
    svg.addEventListener('pointerdown', (event) => {
        if (svg.dataset.mode !== 'axon') return;
        from = [event.clientX, event.clientY, turn, tilt];
        svg.setPointerCapture(event.pointerId);
    });
    svg.addEventListener('pointermove', (event) => {
        if (!from) return;
        turn = from[2] + (event.clientX - from[0]) / 2;
        tilt = Math.min(89, Math.max(5, from[3] + (event.clientY - from[1]) / 3));
        redraw();
    });
    svg.addEventListener('pointerup', () => { from = null; });
    svg.addEventListener('pointercancel', () => { from = null; });
    svg.addEventListener('keydown', (event) => {
        const steps = { ArrowLeft: [-10, 0], ArrowRight: [10, 0], ArrowUp: [0, 5], ArrowDown: [0, -5] };
        if (svg.dataset.mode !== 'axon' || !steps[event.key]) return;
        turn += steps[event.key][0];
        tilt = Math.min(89, Math.max(5, tilt + steps[event.key][1]));
        event.preventDefault();
        redraw();
    });

    function draw() {
        const { scene } = board.results;
        if (!scene) return;
        const { width, height } = svg.getBoundingClientRect();
        svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
        const a = turn * Math.PI / 180, e = tilt * Math.PI / 180;
        const right = [Math.cos(a), Math.sin(a), 0];
        const up = [-Math.sin(a) * Math.sin(e), Math.cos(a) * Math.sin(e), Math.cos(e)];
        const towards = [Math.sin(a) * Math.cos(e), -Math.cos(a) * Math.cos(e), Math.sin(e)]; // to the eye
        const flat = (p) => [dot(p, right), dot(p, up)];
        const shown = scene.surfaces.filter((f, i) => i < scene.faces || (f.role !== 'skyline' && f.role !== 'facade'));
        const near = shown.filter((f) => f.inside).flatMap((f) => pointsOf(f.xyz).map(flat));
        const low = [0, 1].map((k) => Math.min(...near.map((p) => p[k]))), high = [0, 1].map((k) => Math.max(...near.map((p) => p[k])));
        const scale = 0.92 * Math.min(width / (high[0] - low[0]), (height - CAPTIONS) / (high[1] - low[1]));
        const to = (p) => {
            const [x, y] = flat(p);
            return [width / 2 + scale * (x - (low[0] + high[0]) / 2), (height - CAPTIONS) / 2 - scale * (y - (low[1] + high[1]) / 2)];
        };
        const sun = sunOf();
        const place = sunPlace(Number.isFinite(scene.latitude) ? scene.latitude : 51.5, Number.isFinite(scene.longitude) ? scene.longitude : 0, sun.month, sun.day, sun.time);
        const direction = place.altitude > 0 ? sunDirection(place, scene.north) : null;
        const faces = shown.map((surface) => ({ surface, points: pointsOf(surface.xyz) }))
            .map((f) => ({ ...f, normal: normalOf(f.points), far: Math.min(...f.points.map((p) => dot(p, towards))) }))
            .filter((f) => f.surface.role === 'surface' || f.surface.role === 'reveal' || f.surface.role === 'cover' || dot(f.normal, towards) > 1e-6)
            .sort((f, g) => f.far - g.far);
        replaceChildren(svg, s('title', {}, 'Axonometric view; arrow keys turn it'),
            faces.map((f, i) => [
                s('path', { class: `face ${f.surface.role}`, d: pathOf(f.points.map(to), true) }),
                direction && f.surface.inside && dot(f.normal, direction) > 1e-3 && drawSun(scene, f, i, direction, to),
            ]),
            scene.openings.map((o) => s('path', { class: 'glass axon', d: pathOf(pointsOf(o.inner).map(to), true) })),
            s('text', { class: 'caption', x: 12, y: height - 26 }, 'Drag, or use the arrow keys, to turn the room'),
            s('text', { class: 'caption', x: 12, y: height - 10 }, direction
                ? `Sun ${place.altitude.toFixed(0)}\u00b0 high, bearing ${place.bearing.toFixed(0)}\u00b0` : 'The sun is below the horizon.'));
    }
    return draw;
}

// Sunlight on a face: the projections of the openings, clipped to the face, less the shadows of
// objects.
function drawSun(scene, face, index, sun, to) {
    const cast = (xyz) => shadowOn(pointsOf(xyz), face.points[0], face.normal, sun);
    const lit = scene.openings.filter((o) => dot(normalOf(pointsOf(o.inner)), sun) < -1e-6).map((o) => cast(o.outer)).filter(Boolean);
    if (!lit.length) return null;
    const shades = scene.surfaces.filter((f) => f !== face.surface && ['block', 'surface', 'facade', 'skyline'].includes(f.role)).map((f) => cast(f.xyz)).filter(Boolean);
    const clip = `sun-clip-${index}`, mask = `sun-mask-${index}`;
    return [
        s('clipPath', { id: clip }, s('path', { d: pathOf(face.points.map(to), true) })),
        s('mask', { id: mask }, s('rect', { x: -9999, y: -9999, width: 29998, height: 29998, fill: 'white' }),
            shades.map((points) => s('path', { d: pathOf(points.map(to), true), fill: 'black' }))),
        s('g', { 'clip-path': `url(#${clip})` }, s('g', { mask: `url(#${mask})` },
            lit.map((points) => s('path', { class: 'sun', d: pathOf(points.map(to), true) })))),
    ];
}
