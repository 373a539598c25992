// load_test.mjs PORT ROOM REQUESTS PROCESS - 64 clients send REQUESTS each; one in ten is invalid and one
// in fifty is aborted. Then 200 connections send one byte a second. Prints TAP.

import { readFileSync } from 'node:fs';
import { connect } from 'node:net';

const [port, file, requests] = [Number(process.argv[2]), process.argv[3], Number(process.argv[4])];
const CLIENTS = 64, SLOW = 200, SECONDS = 22;
const room = readFileSync(file, 'utf8');
const valid = {
    df: JSON.stringify({ room, options: { methods: 'exact+bre' } }),
    plan: JSON.stringify({ room, options: { tolerance: 0.05 } }),
    check: JSON.stringify({ room }),
};
const invalid = [['df', '{', 400], ['df', JSON.stringify({ room: '<room' }), 422], ['plan', JSON.stringify({ room, options: { nonsense: 1 } }), 400]];

let count = 0;
function check(name, holds, about = '') {
    console.log(`${holds ? 'ok' : 'not ok'} ${++count} - ${name}`);
    if (!holds) console.log(`# ${JSON.stringify(about)}`);
}

// Numbers from 0 to 1 that are the same in every run.
function randomOf(seed) {
    let state = seed + 1;
    return () => (state = (state * 48271) % 2147483647) / 2147483647;
}

function head(command, body, client) {
    return `POST /api/${command} HTTP/1.1\r\nHost: 127.0.0.1:${port}\r\nContent-Type: application/json\r\nX-Pepperpot-Page: ${client}\r\nConnection: close\r\nContent-Length: ${Buffer.byteLength(body)}\r\n\r\n`;
}

// The answer { status, body }. abort: the share of the body that is sent before the client goes.
function ask(command, body, client, abort = null) {
    return new Promise((done, fail) => {
        const parts = [], socket = connect(port, '127.0.0.1');
        socket.on('error', (error) => (abort === null ? fail(error) : done(null)));
        socket.on('data', (part) => parts.push(part));
        socket.on('close', () => {
            const text = Buffer.concat(parts).toString(), end = text.indexOf('\r\n\r\n');
            done({ status: Number(text.slice(9, 12)), body: text.slice(end + 4) });
        });
        socket.write(head(command, body, client));
        if (abort === null) socket.write(body);
        else socket.write(body.slice(0, abort * body.length), () => socket.destroy());
    });
}

const wanted = {};
for (const [command, body] of Object.entries(valid)) wanted[command] = (await ask(command, body, 'first')).body;
check('the answers to compare with are there', Object.values(wanted).every((body) => body.length > 2), wanted);
const counts = { valid: 0, invalid: 0, aborted: 0 }, wrong = [];

async function client(number) {
    const random = randomOf(number);
    for (let i = 0; i < requests; i++) {
        const chance = random();
        try {
            if (chance < 0.02) {
                await ask('df', valid.df, number, chance < 0.01 ? 0.5 : 1);
                counts.aborted++;
            } else if (chance < 0.12) {
                const [command, body, status] = invalid[Math.floor(random() * invalid.length)];
                const answer = await ask(command, body, number);
                counts.invalid++;
                if (answer.status !== status) wrong.push([command, answer.status, status]);
            } else {
                const command = ['df', 'check', 'plan'][Math.floor(random() * 3)];
                const answer = await ask(command, valid[command], number);
                counts.valid++;
                if (answer.status !== 200 || answer.body !== wanted[command]) wrong.push([command, answer.status, answer.body.slice(0, 100)]);
            }
        } catch (error) {
            wrong.push(error.message);
        }
    }
}

await Promise.all(Array.from({ length: CLIENTS }, (_, number) => client(number)));
check(`all answers are right: ${JSON.stringify(counts)}`, wrong.length === 0 && counts.valid > 0, wrong.slice(0, 5));

// ---- one byte a second ----

let open = SLOW, longest = 0;
const slow = Array.from({ length: SLOW }, () => {
    const socket = connect(port, '127.0.0.1');
    socket.on('error', () => {});
    socket.on('close', () => open--);
    socket.resume();
    return socket;
});
const bytes = head('df', valid.df, 'slow');
for (let second = 0; second < SECONDS; second++) {
    for (const socket of slow) if (!socket.destroyed) socket.write(bytes[second]);
    const began = performance.now();
    const answer = await ask('df', valid.df, 'quick');
    longest = Math.max(longest, performance.now() - began);
    if (answer.body !== wanted.df) wrong.push('beside slow connections');
    await new Promise((done) => setTimeout(done, 1000));
}
check(`slow connections do not delay others (longest answer ${longest.toFixed(0)} ms)`, longest < 2000 && wrong.length === 0, wrong.slice(0, 5));
check('and are closed', open === 0, open);
const peak = Number(/VmHWM:\s+(\d+)/.exec(readFileSync(`/proc/${process.argv[5]}/status`, 'utf8'))[1]) / 1024;
check(`the server needs less than 512 MiB (${peak.toFixed(0)})`, peak < 512);
console.log(`1..${count}`);
process.exit(0);
