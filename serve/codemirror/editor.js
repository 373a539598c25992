// editor.js - the editor of the text tab, which build.sh bundles into serve/page/codemirror.js.
// It stands in a shadow root, where its styles are style sheets of their own: the page's content
// security policy takes no inline ones.

import { EditorView, basicSetup } from 'codemirror';
import { xml } from '@codemirror/lang-xml';
import { setDiagnostics, lintGutter } from '@codemirror/lint';

const theme = EditorView.theme({
    '&': { height: '100%', fontSize: '13px', backgroundColor: 'var(--panel)', color: 'var(--ink)' },
    '.cm-scroller': { fontFamily: 'ui-monospace, monospace' },
    '.cm-gutters': { backgroundColor: 'var(--panel)', color: 'var(--soft)', borderRight: '1px solid var(--line)' },
    '.cm-activeLine, .cm-activeLineGutter': { backgroundColor: 'color-mix(in srgb, var(--accent) 9%, transparent)' },
    '.cm-cursor': { borderLeftColor: 'var(--ink)' },
    '&.cm-focused .cm-selectionBackground, .cm-selectionBackground': { backgroundColor: 'color-mix(in srgb, var(--accent) 30%, transparent) !important' },
    '.cm-content span': { color: 'inherit' },
    '.cm-tooltip': { backgroundColor: 'var(--panel)', color: 'var(--ink)' },
});

export function createEditor(parent, changed) {
    const host = document.createElement('div');
    const root = host.attachShadow({ mode: 'open' });
    parent.append(host);
    let isSetting = false;
    const view = new EditorView({
        parent: root,
        root,
        extensions: [basicSetup, xml(), lintGutter(), theme, EditorView.contentAttributes.of({ 'aria-label': 'Room file' }),
            EditorView.updateListener.of((update) => {
                if (update.docChanged && !isSetting) changed(view.state.doc.toString());
            })],
    });
    const placeOf = (line, column) => {
        const found = view.state.doc.line(Math.min(Math.max(1, line), view.state.doc.lines));
        return Math.min(found.to, found.from + column - 1);
    };
    const rangeOf = (mistake) => {
        const from = placeOf(mistake.line, mistake.column);
        return { from, to: Math.max(from, placeOf(mistake['end-line'], mistake['end-column'])) };
    };
    return {
        // Only what differs is replaced, so that the cursor stays where it is.
        setText: (text) => {
            const old = view.state.doc.toString();
            if (text === old) return;
            let from = 0, end = 0;
            while (from < text.length && from < old.length && text[from] === old[from]) from++;
            while (end < text.length - from && end < old.length - from && text[text.length - 1 - end] === old[old.length - 1 - end]) end++;
            isSetting = true;
            view.dispatch({ changes: { from, to: old.length - end, insert: text.slice(from, text.length - end) } });
            isSetting = false;
        },
        mark: (mistakes) => view.dispatch(setDiagnostics(view.state, mistakes.map((m) => ({ ...rangeOf(m), severity: 'error', message: m.text })))),
        goTo: (mistake) => {
            const { from, to } = rangeOf(mistake);
            view.dispatch({ selection: { anchor: from, head: to }, scrollIntoView: true });
            view.focus();
        },
        view,
    };
}
