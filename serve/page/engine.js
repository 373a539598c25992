// engine.js - the only module that calculates: through the JSON interface of the server. A
// WebAssembly build would be another module with the same functions.

export class EngineError extends Error {
    constructor(message, status, mistakes) {
        super(message);
        this.status = status;
        this.mistakes = mistakes ?? [];
    }
}

const page = Array.from(crypto.getRandomValues(new Uint8Array(12)), (b) => b.toString(16).padStart(2, '0')).join('');
const secrets = { token: sessionStorage.getItem('pepperpot-token'), key: null };

export function setToken(token) {
    secrets.token = token;
    sessionStorage.setItem('pepperpot-token', token);
}

export function setKey(key) {
    secrets.key = key;
}

async function request(path, body, { signal, type = 'application/json', secret = secrets.token } = {}) {
    const headers = { 'X-Pepperpot-Page': page };
    if (body !== undefined) headers['Content-Type'] = type;
    if (secret) headers.Authorization = `Bearer ${secret}`;
    let response;
    try {
        response = await fetch(`/api/${path}`, { method: body === undefined ? 'GET' : 'POST', headers, body, signal });
    } catch (error) {
        if (error.name === 'AbortError') throw error;
        throw new EngineError('The server does not answer.', 0);
    }
    if (response.ok) return response;
    let answer = {};
    try {
        answer = await response.json();
    } catch {
        // The status is enough.
    }
    throw new EngineError(answer.error ?? `The server replied with status ${response.status}.`, response.status, answer.mistakes);
}

async function post(command, text, options, signal) {
    return request(command, JSON.stringify({ room: text, options: options ?? {} }), { signal });
}

async function postJson(command, text, options, signal) {
    return (await post(command, text, options, signal)).json();
}

// Events of a stream as they arrive: { event, data }.
async function* events(response) {
    const reader = response.body.pipeThrough(new TextDecoderStream()).getReader();
    let waiting = '';
    for (;;) {
        const { value, done } = await reader.read();
        if (done) return;
        waiting += value;
        for (let end; (end = waiting.indexOf('\n\n')) >= 0; waiting = waiting.slice(end + 2)) {
            const lines = waiting.slice(0, end).split('\n');
            const event = lines.find((l) => l.startsWith('event: '))?.slice(7);
            const data = lines.filter((l) => l.startsWith('data: ')).map((l) => l.slice(6)).join('\n');
            yield { event, data: JSON.parse(data) };
        }
    }
}

async function* stream(command, text, options, signal) {
    for await (const { event, data } of events(await post(command, text, options, signal))) {
        if (event === 'error') throw new EngineError(data.error, 422);
        yield { event, data };
    }
}

export const engine = {
    about: async () => (await request('about')).json(),
    startRoom: async () => (await (await request('room', undefined, { secret: secrets.key ?? secrets.token })).json()).room,
    example: async (name) => (await fetch(`/examples/${name}.xml`)).text(),

    check: async (text, signal) => (await request('check', JSON.stringify({ room: text }), { signal })).json(),
    plan: (text, options, signal) => postJson('plan', text, options, signal),
    df: (text, options, signal) => postJson('df', text, options, signal),
    assess: (text, options, signal) => postJson('assess', text, options, signal),
    size: (text, options, signal) => postJson('size', text, options, signal),
    availability: (text, options, signal) => postJson('availability', text, options, signal),
    // Files, as blobs: df in any format, a chart of a kind, the report.
    file: async (command, text, options, signal) => (await post(command, text, options, signal)).blob(),

    // "estimate" events { progress, error, points: [[value, se], ...], average }, then "result".
    trace: (text, options, signal) => stream('trace', text, options, signal),
    // "estimate" events { progress, error, paths, annual }, then "result"; options: weather, a hash.
    annual: (text, options, signal) => stream('annual', text, options, signal),
    // "picture" events { pass, passes, size, samples, png }.
    render: (text, options, signal) => stream('render', text, options, signal),

    weather: async (bytes) => (await request('weather', bytes, { type: 'application/octet-stream' })).json(),
    importGbxml: async (text) => (await request('import', JSON.stringify({ gbxml: text }))).text(),
};
