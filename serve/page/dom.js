// dom.js - makes elements of the page without HTML text, so that no text of a room file can become
// an element.

function fill(element, attributes, children) {
    for (const [name, value] of Object.entries(attributes ?? {})) {
        if (value === null || value === undefined || value === false) continue;
        if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
        else if (name === 'value' && 'value' in element) element.value = value;
        else element.setAttribute(name, value === true ? '' : value);
    }
    for (const child of children.flat(Infinity))
        if (child !== null && child !== undefined && child !== false) element.append(child);
    return element;
}

export function h(tag, attributes, ...children) {
    return fill(document.createElement(tag), attributes, children);
}

export function s(tag, attributes, ...children) {
    return fill(document.createElementNS('http://www.w3.org/2000/svg', tag), attributes, children);
}

export const $ = (id) => document.getElementById(id);

// Shows a sentence above the drawing; an empty one removes it.
export function say(sentence, isBad = false) {
    $('message').textContent = sentence;
    $('message').classList.toggle('bad', isBad);
}

// A path through points of the screen.
export function pathOf(points, closed = false) {
    return points.map(([x, y], i) => `${i ? 'L' : 'M'}${x.toFixed(1)} ${y.toFixed(1)}`).join('') + (closed ? 'Z' : '');
}

// Replaces the children of an element, and returns the focus to the part with the same data-handle
// or id.
export function replaceChildren(element, ...children) {
    const focused = element.contains(document.activeElement) ? document.activeElement : null;
    const key = focused?.dataset?.handle, id = focused?.id;
    element.replaceChildren(...children.flat(Infinity).filter((c) => c !== null && c !== undefined && c !== false));
    const again = key ? element.querySelector(`[data-handle="${CSS.escape(key)}"]`)
        : id ? element.querySelector(`#${CSS.escape(id)}`) : null;
    again?.focus({ preventScroll: true });
}

// A value as text: with a standard error as many digits as the error justifies, otherwise three.
export function figure(value, error = null) {
    if (value === null || value === undefined || !Number.isFinite(value)) return '\u2013';
    if (error !== null && Number.isFinite(error) && error > 0) {
        const decimals = Math.min(4, Math.max(0, 1 - Math.floor(Math.log10(error))));
        return `${value.toFixed(decimals)} \u00b1 ${error.toFixed(decimals)}`;
    }
    const size = Math.abs(value);
    return value.toFixed(size >= 100 ? 0 : size >= 10 ? 1 : 2);
}

export function download(name, type, content) {
    const url = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
    const link = h('a', { href: url, download: name });
    document.body.append(link);
    link.click();
    link.remove();
    setTimeout(() => URL.revokeObjectURL(url), 60000);
}

// A valid file name made from a name.
export function fileName(name, extension) {
    return `${(name || 'room').replace(/[^\p{L}\p{N}_-]+/gu, '-').replace(/^-+|-+$/g, '') || 'room'}.${extension}`;
}
