// files.js - examples, and files that are dropped or chosen: room files are opened, gbXML is
// imported by the engine, OBJ files become surfaces, EPW files are weather.

import { board } from './board.js';
import { engine } from './engine.js';
import { $, h, say } from './dom.js';
import { insertInto, metresPer } from './room_text.js';
import { useWeather } from './sheets_panel.js';
import { useYearWeather } from './year_panel.js';

export const EXAMPLES = [
    ['deep-office', 'Deep office'], ['deep-office-obstructed', 'Deep office, obstructed'], ['office', 'Office for two'],
    ['classroom', 'Classroom'], ['l-shaped', 'L-shaped room'], ['studio', 'Studio'], ['workshop', 'Workshop'],
];

const SURFACES_MOST = 300;

// Surfaces of an OBJ file, in metres with z up, as elements of the room.
export function surfacesOfObj(text) {
    const vertices = [], surfaces = [];
    for (const line of text.split('\n')) {
        const words = line.trim().split(/\s+/);
        if (words[0] === 'v') vertices.push(words.slice(1, 4).map(Number));
        if (words[0] !== 'f') continue;
        const corners = words.slice(1).map((word) => {
            const index = parseInt(word, 10);
            return vertices[index > 0 ? index - 1 : vertices.length + index];
        });
        if (corners.length >= 3 && corners.every((c) => c && c.every(Number.isFinite))) surfaces.push(corners);
    }
    return surfaces;
}

function addObj(text) {
    const surfaces = surfacesOfObj(text);
    if (!surfaces.length) throw new Error('The OBJ file has no faces.');
    if (surfaces.length > SURFACES_MOST) throw new Error(`The OBJ file has ${surfaces.length} faces; the drawing board accepts at most ${SURFACES_MOST}. Use <mesh> in a room file and the pepperpot command instead.`);
    const xml = surfaces.map((corners) => `<surface reflectance="0.3">${corners.map((c) => c.map((v) => Number((v / metresPer(board.room)).toPrecision(9)))).map(([x, y, z]) => `<vertex x="${x}" y="${y}" z="${z}"/>`).join('')}</surface>`).join('\n');
    board.change(insertInto(board.text, board.room, xml));
}

export async function openFile(file) {
    const extension = file.name.toLowerCase().split('.').pop();
    if (extension === 'epw') {
        const found = await engine.weather(await file.arrayBuffer());
        useWeather(found);
        useYearWeather(found);
        return `The weather file ${file.name} is now used.`;
    }
    const text = await file.text();
    if (extension === 'obj') {
        addObj(text);
        return `The faces of ${file.name} were added as surfaces.`;
    }
    if (/<gbXML[\s>]/.test(text.slice(0, 4000))) {
        board.open(await engine.importGbxml(text));
        return `${file.name} is imported.`;
    }
    if (!/<(room|building)[\s>]/.test(text)) throw new Error(`${file.name} is not a room file, gbXML file, OBJ file or EPW file.`);
    board.open(text);
    return `${file.name} is open.`;
}

async function openAndTell(file) {
    try {
        say(await openFile(file));
    } catch (error) {
        say(error.message, true);
    }
}

export function setUpFiles() {
    $('example').append(...EXAMPLES.map(([name, label]) => h('option', { value: name }, label)));
    $('example').addEventListener('change', async (event) => {
        const name = event.target.value;
        event.target.value = '';
        board.open(await engine.example(name));
        say('');
    });
    $('file').addEventListener('change', (event) => {
        const [file] = event.target.files;
        if (file) openAndTell(file);
        event.target.value = '';
    });
    $('open').addEventListener('click', () => $('file').click());
    document.addEventListener('dragover', (event) => {
        event.preventDefault();
        document.body.classList.add('dropping');
    });
    document.addEventListener('dragleave', (event) => {
        if (!event.relatedTarget) document.body.classList.remove('dropping');
    });
    document.addEventListener('drop', (event) => {
        event.preventDefault();
        document.body.classList.remove('dropping');
        const [file] = event.dataTransfer?.files ?? [];
        if (file) openAndTell(file);
    });
}
