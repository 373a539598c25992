// address.js - keeps the room in the part of the address after "#", which browsers never send. The
// text is deflated and encoded as base64url.

async function through(bytes, stream) {
    return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
}

export async function packText(text) {
    const bytes = await through(new TextEncoder().encode(text), new CompressionStream('deflate-raw'));
    let letters = '';
    for (const byte of bytes) letters += String.fromCharCode(byte);
    return btoa(letters).replace(/\+/g, '-').replace(/\//g, '_').replace(/=+$/, '');
}

export async function unpackText(packed) {
    const letters = atob(packed.replace(/-/g, '+').replace(/_/g, '/'));
    const bytes = Uint8Array.from(letters, (c) => c.charCodeAt(0));
    return new TextDecoder().decode(await through(bytes, new DecompressionStream('deflate-raw')));
}

// { room, other, key, token } of the address; room and other are texts or undefined.
export async function readAddress() {
    const parts = new URLSearchParams(location.hash.slice(1));
    const found = { key: parts.get('key'), token: parts.get('token') };
    try {
        if (parts.get('room')) found.room = await unpackText(parts.get('room'));
        if (parts.get('other')) found.other = await unpackText(parts.get('other'));
    } catch {
        found.isBroken = true;
    }
    return found;
}

let turn = 0;
export async function writeAddress(room, other) {
    const mine = ++turn;
    const hash = `#room=${await packText(room)}${other ? `&other=${await packText(other)}` : ''}`;
    if (mine === turn) history.replaceState(null, '', hash);
}
