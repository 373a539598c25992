// board.js - the state of the page: one or two variants of a room file, each with its changes that
// can be undone; the selection; and the results of the engine. Parts of the page listen to its
// events.

import { readElements, roomsOf, isWithin, valueOf } from './room_text.js';

const UNDO_MOST = 200;

class Board extends EventTarget {
    // Each { text, undo, redo }, and results of its text: simulated { text, room, average }, drawn
    // { text, room, scene, plan }.
    variants = [];
    active = 0;
    selected = -1; // index of an element
    roomIndex = 0;
    method = ''; // of the contours; empty: the default pair
    pointer = null; // [x, y] on the plan: the position whose figures are shown
    isPointerKept = false; // the position stays when the pointer moves
    isHeld = false; // a handle is being dragged
    results = { scene: null, plan: null, why: '', df: null, section: null, mistakes: [], trace: null };
    elements = [];

    get variant() {
        return this.variants[this.active];
    }

    get text() {
        return this.variant?.text ?? '';
    }

    get rooms() {
        return roomsOf(this.elements);
    }

    get room() {
        return this.rooms[this.roomIndex] ?? this.rooms[0] ?? null;
    }

    // The option of a request that names the room of a building.
    get roomOption() {
        return this.rooms.length > 1 && this.roomName ? { room: this.roomName } : {};
    }

    get roomName() {
        return valueOf(this.room, 'name', '');
    }

    get element() {
        return this.elements[this.selected] ?? null;
    }

    // Elements of the current room, and of its site.
    get parts() {
        const room = this.room;
        return this.elements.filter((e) => e !== room && e.name !== 'building' && (isWithin(e, room) || !this.rooms.some((r) => isWithin(e, r))));
    }

    tell(what, detail) {
        this.dispatchEvent(new CustomEvent(what, { detail }));
    }

    on(whats, listener) {
        for (const what of whats.split(' ')) this.addEventListener(what, listener);
    }

    read() {
        this.elements = readElements(this.text);
        if (this.selected >= this.elements.length) this.selected = -1;
        if (this.roomIndex >= this.rooms.length) this.roomIndex = 0;
    }

    // Starts with a new room file.
    open(text, { keep = false } = {}) {
        if (keep && this.variant) {
            this.change(text);
            this.select(-1);
            return;
        }
        this.variants = [{ text, undo: [], redo: [] }];
        this.active = 0;
        this.selected = -1;
        this.roomIndex = 0;
        this.read();
        this.tell('text', { from: 'open' });
        this.tell('selection');
    }

    // Changes the text of the current variant. Changes with the same `series` are undone together.
    change(text, { series = null, from = 'drawing', select } = {}) {
        const variant = this.variant;
        if (text === variant.text) return;
        if (!series || variant.series !== series) {
            variant.undo.push({ text: variant.text, selected: this.selected });
            if (variant.undo.length > UNDO_MOST) variant.undo.shift();
        }
        variant.series = series;
        variant.redo = [];
        variant.text = text;
        this.read();
        if (select !== undefined) this.selected = select;
        this.tell('text', { from });
        if (select !== undefined) this.tell('selection');
    }

    // Ends a series, so that the next change is undone separately.
    endSeries() {
        if (this.variant) this.variant.series = null;
    }

    step(from, to) {
        const variant = this.variant;
        const state = variant[from].pop();
        if (!state) return;
        variant[to].push({ text: variant.text, selected: this.selected });
        variant.series = null;
        variant.text = state.text;
        this.selected = state.selected;
        this.read();
        this.tell('text', { from: 'undo' });
        this.tell('selection');
    }

    undo() {
        this.step('undo', 'redo');
    }

    redo() {
        this.step('redo', 'undo');
    }

    select(index) {
        if (index === this.selected) return;
        this.selected = index;
        this.endSeries();
        this.tell('selection');
    }

    chooseRoom(index) {
        this.roomIndex = index;
        this.selected = -1;
        this.tell('text', { from: 'room' });
        this.tell('selection');
    }

    // on: adds a second variant, a copy of the current one; otherwise removes the variant that is
    // not current.
    compare(on) {
        if (on && this.variants.length === 1) {
            this.variants.push({ ...this.variant, undo: [], redo: [] });
            this.active = 1;
        } else if (!on && this.variants.length === 2) {
            this.variants = [this.variant];
            this.active = 0;
        }
        this.read();
        this.tell('text', { from: 'variant' });
    }

    use(index) {
        if (!this.variants[index] || index === this.active) return;
        this.active = index;
        this.read();
        this.tell('text', { from: 'variant' });
        this.tell('selection');
    }

    settle(results) {
        Object.assign(this.results, results);
        this.tell('results', results);
    }
}

export const board = new Board();
