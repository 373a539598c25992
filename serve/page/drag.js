// drag.js - moves handles by pointer and keys, the same in every view.
//
// A drawn view is { name, handles, toScreen([a, b]), toPlace([x, y]) }, in pixels of its svg.

import { board } from './board.js';
import { setMany } from './room_text.js';
import { s } from './dom.js';
import { labelOf } from './kinds.js';

const SNAP = 0.05; // m

export function snapped(place, { free }) {
    return free ? place : place.map((c) => Math.round(c / SNAP) * SNAP);
}

function keep(handle, place) {
    if (handle.axes === 'x') return [place[0], handle.at[1]];
    if (handle.axes === 'y') return [handle.at[0], place[1]];
    return place;
}

function move(handle, place, event) {
    const kept = keep(handle, handle.isFree ? place : snapped(place, { free: event.altKey }));
    const series = `${board.selected} ${handle.key}`;
    board.change(setMany(board.text, handle.drag(kept)), { series });
}

// The handles as parts of a drawing. Their names for screen readers state what they set.
export function drawHandles(view) {
    return view.handles.map((handle) => {
        const [x, y] = view.toScreen(handle.at);
        const name = `${labelOf(board.element)}: ${handle.label}, ${handle.at.map((c) => c.toFixed(2)).join(', ')} m; arrow keys move it`;
        return s('g', { class: `handle ${handle.axes}`, 'data-handle': `${view.name} ${handle.key}`, tabindex: 0, role: 'button', 'aria-label': name },
            s('circle', { class: 'reach', cx: x, cy: y, r: 12 }),
            handle.axes === 'xy' ? s('circle', { cx: x, cy: y, r: 6 }) : s('rect', { x: x - 5.5, y: y - 5.5, width: 11, height: 11, rx: 2 }));
    });
}

// Listens to the events of an svg; viewOf() returns the view that is drawn in it now.
export function listenToDrags(svg, viewOf) {
    let held = null;
    const placeOf = (event) => {
        const box = svg.getBoundingClientRect();
        return viewOf().toPlace([event.clientX - box.left, event.clientY - box.top]);
    };
    const handleOf = (event) => {
        const key = event.target.closest?.('[data-handle]')?.dataset.handle;
        const view = viewOf();
        return key && view?.handles.find((h) => `${view.name} ${h.key}` === key);
    };
    svg.addEventListener('pointerdown', (event) => {
        const handle = handleOf(event);
        if (handle && event.button === 0) {
            const place = placeOf(event);
            board.isHeld = true;
            held = { key: handle.key, offset: [handle.at[0] - place[0], handle.at[1] - place[1]] };
            svg.setPointerCapture(event.pointerId);
            event.target.closest('[data-handle]').focus({ preventScroll: true });
            svg.classList.add('dragging');
            event.preventDefault();
            return;
        }
        const picked = event.target.closest?.('[data-element]');
        if (picked) board.select(Number(picked.dataset.element));
    });
    svg.addEventListener('pointermove', (event) => {
        if (!held) return;
        const handle = viewOf().handles.find((h) => h.key === held.key);
        if (!handle) return;
        const place = placeOf(event);
        move(handle, [place[0] + held.offset[0], place[1] + held.offset[1]], event);
    });
    const release = () => {
        if (!held) return;
        held = null;
        board.isHeld = false;
        svg.classList.remove('dragging');
        board.endSeries();
        board.tell('rest');
    };
    svg.addEventListener('pointerup', release);
    svg.addEventListener('pointercancel', release);
    svg.addEventListener('keydown', (event) => {
        const steps = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
        const step = steps[event.key], handle = step && handleOf(event);
        if (!handle) {
            const picked = event.target.closest?.('[data-element]');
            if (picked && (event.key === 'Enter' || event.key === ' ')) {
                board.select(Number(picked.dataset.element));
                event.preventDefault();
            }
            return;
        }
        event.preventDefault();
        const by = event.altKey ? 0.01 : event.shiftKey ? 0.5 : SNAP;
        const place = handle.at.map((c, i) => c + step[i] * by);
        move(handle, place, { altKey: event.altKey });
    });
    svg.addEventListener('keyup', (event) => {
        if (event.key.startsWith('Arrow')) board.endSeries();
    });
}
