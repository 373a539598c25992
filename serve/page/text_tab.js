// text_tab.js - the room file as text, with its mistakes marked and listed. The editor is
// CodeMirror if its bundle can be loaded, otherwise a plain text area.

import { board } from './board.js';
import { engine } from './engine.js';
import { $, h, replaceChildren } from './dom.js';

const WAIT_MS = 200;

// Both editors are objects { text, setText, mark, goTo }.
function plainEditor(parent, changed) {
    const area = h('textarea', { id: 'text', spellcheck: 'false', autocapitalize: 'off', 'aria-label': 'Room file', 'aria-describedby': 'mistakes' });
    area.addEventListener('input', () => changed(area.value));
    parent.append(area);
    return {
        setText: (text) => {
            if (area.value !== text) area.value = text;
        },
        mark: (mistakes) => area.setAttribute('aria-invalid', String(mistakes.length > 0)),
        goTo: (place) => {
            const lines = area.value.split('\n');
            const at = (line, column) => lines.slice(0, line - 1).reduce((n, l) => n + l.length + 1, 0) + column - 1;
            area.focus();
            area.setSelectionRange(at(place.line, place.column), at(place['end-line'], place['end-column']));
        },
    };
}

async function loadEditor(parent, changed) {
    try {
        const { createEditor } = await import('./codemirror.js');
        return createEditor(parent, changed);
    } catch {
        return plainEditor(parent, changed);
    }
}

// After a change from elsewhere the selection is a cursor: otherwise text that was replaced would stay
// selected, and the next key would delete it.
function setText() {
    editor.setText(board.text);
    const { view } = editor;
    if (view) view.dispatch({ selection: { anchor: view.state.selection.main.head } });
}

let editor = null, turn = 0, timer = 0;

async function checkText() {
    const own = ++turn, text = board.text;
    let answer;
    try {
        answer = await engine.check(text);
    } catch (error) {
        replaceChildren($('mistakes'), h('li', {}, error.message));
        return;
    }
    if (own !== turn || text !== board.text) return;
    editor?.mark(answer.mistakes);
    replaceChildren($('mistakes'), answer.mistakes.map((m) => h('li', {}, h('button', { type: 'button', onclick: () => editor.goTo(m) }, `Line ${m.line}, column ${m.column}: ${m.text}`))));
    $('mistake-count').textContent = answer.mistakes.length ? `${answer.mistakes.length} mistake${answer.mistakes.length > 1 ? 's' : ''}` : 'No mistakes';
}

export async function setUpText() {
    editor = await loadEditor($('editor'), (text) => {
        board.change(text, { from: 'text', series: 'typing' });
    });
    board.on('text', (event) => {
        if (event.detail.from !== 'text') setText();
        clearTimeout(timer);
        timer = setTimeout(checkText, WAIT_MS);
    });
    if (board.text) {
        editor.setText(board.text);
        checkText();
    }
}
