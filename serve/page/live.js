// live.js - sends requests to the engine while the drawing changes. Only one request for the
// drawing is pending at a time; the next one has the newest text. The slower requests follow after
// a pause in the input.

import { board } from './board.js';
import { engine } from './engine.js';
import { chooseCut, pointsOfCut } from './section_view.js';

const REST_MS = 60;
// Accuracy of contours (m) while a handle is held, and after it is released.
const COARSE = 0.1, FINE = 0.01;

let running = false, wanted = false, restTimer = 0, isDue = false;
let trace = null; // an AbortController
let pointing = false, pointed = null; // the position whose components are shown
let asked = 0;

// Times of the last contours, for the benchmark: server and transfer, drawing.
export const timings = [];

export const switches = { trace: true, error: 1 };

// The curve and the components use the method of the contours.
const methodOf = (plan) => plan?.method ?? 'exact+bre';

// Options of a plan; an empty method is the default.
const planOptions = (tolerance, method) => ({ tolerance, average: false, ...(method ? { methods: method } : {}), ...board.roomOption });

// The curve follows the contours: on two cores, both at once would only delay the contours.
async function updateOnce() {
    const { variant, text, roomName, method } = board, from = performance.now();
    const tolerance = board.isHeld ? COARSE : FINE;
    const answer = await engine.plan(text, planOptions(tolerance, method));
    const got = performance.now();
    board.cut = chooseCut(answer.scene);
    variant.drawn = { text, room: roomName, method, scene: answer.scene, plan: answer.plan };
    board.settle({ scene: answer.scene, plan: answer.plan, why: answer.why ?? '', mistakes: [], error: null });
    timings.push({ answered: got - from, drawn: performance.now() - got });
    if (timings.length > 500) timings.shift();
    const points = board.cut ? pointsOfCut(answer.scene, board.cut) : [];
    board.settle({ section: points.length ? await engine.df(text, { methods: methodOf(answer.plan), points, ...board.roomOption }).catch(() => null) : null });
}

async function update() {
    wanted = true;
    if (running) return;
    running = true;
    while (wanted) {
        wanted = false;
        try {
            await updateOnce();
        } catch (error) {
            if (error.name === 'AbortError') continue;
            board.settle({ mistakes: error.mistakes ?? [], error: error.message });
        }
    }
    running = false;
    board.tell('updated');
    if (isDue) begin();
}

export const isBusy = () => running;

// ---- after a pause in the input ----

async function askFigures() {
    const turn = ++asked, text = board.text;
    const values = await Promise.all(board.variants.map((v) => engine.df(v.text, board.roomOption).catch((error) => ({ error: error.message }))));
    if (turn !== asked || text !== board.text) return;
    board.settle({ df: values[board.active], all: values });
}

// The plan of the variant that is not being changed.
async function askOther() {
    const other = board.variants[1 - board.active], { text } = other ?? {}, room = board.roomName;
    const { method } = board, drawn = other?.drawn;
    if (!other || (drawn?.text === text && drawn.room === room && drawn.method === method)) return;
    const answer = await engine.plan(text, planOptions(FINE, method)).catch(() => null);
    other.drawn = { text, room, method, scene: answer?.scene, plan: answer?.plan };
    board.tell('other');
}

export function stopTrace() {
    trace?.abort();
    trace = null;
    board.tell('trace');
}

export const isTracing = () => trace !== null;

export async function startTrace() {
    stopTrace();
    const own = trace = new AbortController();
    const { variant, text, roomName } = board;
    board.tell('trace');
    try {
        for await (const { event, data } of engine.trace(text, { error: switches.error, ...board.roomOption }, own.signal)) {
            if (own !== trace) return;
            if (event === 'estimate') variant.simulated = { text, room: roomName, average: data.average };
            if (event === 'estimate') board.settle({ trace: data });
            else board.settle({ traced: data, trace: { ...board.results.trace, isDone: true } });
        }
    } catch (error) {
        if (error.name !== 'AbortError' && own === trace) board.settle({ traceError: error.message });
    }
    if (own === trace) trace = null;
    board.tell('trace');
}

function begin() {
    isDue = false;
    if (board.results.error) return;
    if (switches.trace) startTrace();
    askFigures();
    askOther();
    pointed = null;
    askPoint();
    board.tell('rested');
}

// While contours are calculated the hand has not rested, however slow they are.
function rest() {
    clearTimeout(restTimer);
    isDue = false;
    restTimer = setTimeout(() => {
        isDue = true;
        if (!running) begin();
    }, REST_MS);
}

// ---- at the pointer ----



async function askPoint() {
    if (pointing || !board.pointer) return;
    pointing = true;
    while (board.pointer && board.pointer !== pointed) {
        pointed = board.pointer;
        const [x, y] = pointed;
        try {
            const answer = await engine.df(board.text, { methods: methodOf(board.results.plan), points: [[Number(x.toFixed(3)), Number(y.toFixed(3))]], explain: true, ...board.roomOption });
            board.settle({ point: answer, pointError: '' });
        } catch (error) {
            board.settle({ point: null, pointError: error.message });
        }
    }
    pointing = false;
}

export function setUpLive() {
    board.on('text', (event) => {
        if (trace) stopTrace();
        const { trace: shown, traced, traceError } = board.results;
        if (shown || traced || traceError) board.settle({ trace: null, traced: null, traceError: '' });
        if (['open', 'room', 'variant'].includes(event.detail.from)) {
            board.cut = null;
            Object.assign(board.results, { scene: null, df: null, all: null, point: null, section: null });
        }
        update();
        rest();
    });
    board.on('selection', () => {
        if (!board.results.scene) return;
        board.cut = chooseCut(board.results.scene);
        update();
    });
    board.on('pointer', askPoint);
    board.on('rest', update);
}
