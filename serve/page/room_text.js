// room_text.js - a room file as text with positions: elements are read and changed in place, and
// everything else stays as it was written, including comments and blanks.

const TAG = /<!--[\s\S]*?-->|<\?[\s\S]*?\?>|<!\[CDATA\[[\s\S]*?\]\]>|<\/([\w.-]+)\s*>|<([\w.-]+)((?:\s+[\w.:-]+\s*=\s*(?:"[^"]*"|'[^']*'))*)\s*(\/?)>/g;
const ATTRIBUTE = /([\w.:-]+)(\s*=\s*)("[^"]*"|'[^']*')/g;

function unescapeXml(value) {
    return value.replace(/&(#x[0-9a-f]+|#\d+|lt|gt|quot|apos|amp);/gi, (all, name) => {
        const known = { lt: '<', gt: '>', quot: '"', apos: "'", amp: '&' };
        if (name[0] !== '#') return known[name.toLowerCase()];
        const code = name[1] === 'x' ? parseInt(name.slice(2), 16) : parseInt(name.slice(1), 10);
        return code > 0 && code < 0x110000 ? String.fromCodePoint(code) : all;
    });
}

export function escapeXml(value) {
    return String(value).replace(/[&<>"]/g, (c) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[c]);
}

// The elements of a text in order: { name, from, to, end, line, attributes, parent, children }. The
// start tag is the text between from and to; end is after the whole element; line is the line on
// which the start tag ends, as in the messages of the program. attributes: by name { value, from,
// to, nameFrom }, with the position of the value inside its quotes.
export function readElements(text) {
    const elements = [];
    const open = [];
    let line = 1, counted = 0;
    TAG.lastIndex = 0;
    for (let match; (match = TAG.exec(text));) {
        const [all, closing, name, attributes, empty] = match;
        const to = match.index + all.length;
        if (closing) {
            const element = open.pop();
            if (element) element.end = to;
        } else if (name) {
            for (; counted < match.index; counted++) if (text[counted] === '\n') line++;
            const element = { index: elements.length, name, from: match.index, to, end: to, line,
                              isEmpty: empty === '/', attributes: {}, parent: open[open.length - 1] ?? null,
                              children: [] };
            const start = match.index + 1 + name.length;
            for (const found of attributes.matchAll(ATTRIBUTE)) {
                const from = start + found.index + found[1].length + found[2].length + 1;
                element.attributes[found[1]] = { value: unescapeXml(found[3].slice(1, -1)), from,
                                                 to: from + found[3].length - 2, nameFrom: start + found.index };
            }
            element.parent?.children.push(element);
            elements.push(element);
            if (!empty) open.push(element);
        }
    }
    return elements;
}

// The innermost element whose start tag contains a place, and the name of the attribute there:
// { element, name }, or null. line and column count from 1.
export function partAt(text, elements, line, column) {
    let at = 0;
    for (let i = 1; i < line; i++) at = text.indexOf('\n', at) + 1;
    at += column - 1;
    const element = elements.filter((e) => e.from <= at && at < e.to).pop();
    if (!element) return null;
    const found = Object.entries(element.attributes).find(([, a]) => a.nameFrom <= at && at <= a.to);
    return { element, name: found?.[0] };
}

export function valueOf(element, name, usual = undefined) {
    return element?.attributes[name]?.value ?? usual;
}

export function numberOf(element, name, usual = NaN) {
    const value = parseFloat(valueOf(element, name, ''));
    return Number.isFinite(value) ? value : usual;
}

// Metres of one unit of length in the file of an element: lengths are in metres or in millimetres.
export function metresPer(element) {
    let root = element;
    while (root?.parent) root = root.parent;
    return valueOf(root, 'units') === 'mm' ? 0.001 : 1;
}

// A length in metres.
export function lengthOf(element, name, usual = NaN) {
    const value = numberOf(element, name);
    return Number.isFinite(value) ? value * metresPer(element) : usual;
}

// Lengths separated by blanks, in metres.
export function lengthsOf(element, name) {
    return valueOf(element, name, '').trim().split(/[\s,]+/).map((word) => Number(word) * metresPer(element));
}

// A length in metres as the file of an element has it.
export function writtenLength(element, metres) {
    return written(metres / metresPer(element));
}

function splice(text, from, to, by) {
    return text.slice(0, from) + by + text.slice(to);
}

// Sets attributes of one element; null removes an attribute.
export function setAttributes(text, element, changes) {
    const edits = [];
    let added = '';
    for (const [name, value] of Object.entries(changes)) {
        const found = element.attributes[name];
        if (found && value === null) {
            let from = found.nameFrom;
            while (from > element.from && /\s/.test(text[from - 1])) from--;
            edits.push([from, found.to + 1, '']);
        } else if (found) {
            edits.push([found.from, found.to, escapeXml(value)]);
        } else if (value !== null) {
            added += ` ${name}="${escapeXml(value)}"`;
        }
    }
    if (added) {
        let at = element.to - (element.isEmpty ? 2 : 1);
        while (/\s/.test(text[at - 1])) at--;
        edits.push([at, at, added]);
    }
    edits.sort((a, b) => b[0] - a[0]);
    return edits.reduce((changed, edit) => splice(changed, ...edit), text);
}

// Sets attributes of several elements of the same reading: [[element, changes], ...].
export function setMany(text, list) {
    return [...list].sort((a, b) => b[0].from - a[0].from)
        .reduce((changed, [element, changes]) => setAttributes(changed, element, changes), text);
}

function indentOf(text, at) {
    const from = text.lastIndexOf('\n', at - 1) + 1;
    const blanks = /^[ \t]*/.exec(text.slice(from, at))[0];
    return from + blanks.length === at ? blanks : '';
}

// Removes an element, with its line if nothing else is on it.
export function removeElement(text, element) {
    let { from, end } = element;
    const lineFrom = text.lastIndexOf('\n', from - 1) + 1;
    if (/^[ \t]*$/.test(text.slice(lineFrom, from)) && /^[ \t]*(\r?\n|$)/.test(text.slice(end))) {
        from = lineFrom;
        end += /^[ \t]*(\r?\n|$)/.exec(text.slice(end))[0].length;
    }
    return splice(text, from, end, '');
}

// Inserts the text of an element after another one, on a separate line; returns the text.
export function insertBehind(text, element, xml) {
    const indent = indentOf(text, element.from);
    return splice(text, element.end, element.end, `\n${indent}${xml}`);
}

// Inserts it as the last child of its parent.
export function insertInto(text, parent, xml) {
    const last = parent.children[parent.children.length - 1];
    if (last) return insertBehind(text, last, xml);
    const indent = indentOf(text, parent.from);
    if (parent.isEmpty) {
        let at = parent.to - 2;
        while (/\s/.test(text[at - 1])) at--;
        return splice(text, at, parent.to, `>\n${indent}  ${xml}\n${indent}</${parent.name}>`);
    }
    return splice(text, parent.to, parent.to, `\n${indent}  ${xml}\n${indent}`);
}

export function textOf(text, element) {
    return text.slice(element.from, element.end);
}

// Rooms of a file, and the elements that belong to one of them.
export function roomsOf(elements) {
    return elements.filter((e) => e.name === 'room');
}

export function isWithin(element, room) {
    for (let at = element; at; at = at.parent) if (at === room) return true;
    return false;
}

// A number as written in a file: by default metres to a millimetre, without trailing zeros.
export function written(number, decimals = 3) {
    return String(Number(number.toFixed(decimals)));
}
