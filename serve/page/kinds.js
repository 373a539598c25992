// kinds.js - the elements of a room file that the board knows: their attributes with units, the
// parts that can be added, and whether they have a place that a drag can move.

const glazings = ['clear-single', 'clear-double', 'clear-triple', 'low-e-double', 'low-e-triple',
    'solar-control-light', 'solar-control-medium', 'solar-control-dark', 'none'];
const glass = [['glazing', '', glazings], ['transmittance', ''], ['frame-factor', ''], ['maintenance', ''], ['reveal', 'm'], ['name', '']];
const roofs = ['flat', 'mono', 'gable', 'hip'], ridges = ['longer', 'width', 'depth'];
const skies = ['overcast', 'uniform', ...Array.from({ length: 15 }, (_, i) => `iso-${i + 1}`)];

// name: [attribute, unit, values to choose from]; the first ones are always shown.
export const KINDS = {
    room: { label: 'Room', attributes: [['name', ''], ['north', '\u00b0'], ['use', '']] },
    plan: { label: 'Plan', attributes: [['width', 'm'], ['depth', 'm'], ['height', 'm'], ['roof', '', [...roofs, 'saw-tooth']], ['pitch', '\u00b0'], ['ridge', '', ridges], ['teeth', '']] },
    envelope: { label: 'Envelope', attributes: [] },
    face: { label: 'Face', attributes: [['name', ''], ['role', '', ['floor', 'wall', 'ceiling']], ['reflectance', '']] },
    vertex: { label: 'Corner', attributes: [['x', 'm'], ['y', 'm'], ['z', 'm']] },
    site: { label: 'Site', attributes: [['latitude', '\u00b0'], ['longitude', '\u00b0'], ['surroundings', '', ['rural', 'urban', 'industrial']], ['ground-reflectance', ''], ['country', '']] },
    tree: { label: 'Tree', attributes: [['x', 'm'], ['y', 'm'], ['height', 'm'], ['crown-base', 'm'], ['crown-width', 'm'], ['transmittance', ''], ['winter-transmittance', '']] },
    sky: { label: 'Sky', attributes: [['type', '', skies], ['sun-altitude', '\u00b0'], ['sun-bearing', '\u00b0']] },
    finishes: { label: 'Finishes', attributes: [['floor', ''], ['walls', ''], ['ceiling', '']] },
    finish: { label: 'Finish of a wall', attributes: [['wall', ''], ['reflectance', '']] },
    window: { label: 'Window', attributes: [['wall', ''], ['left', 'm'], ['sill', 'm'], ['width', 'm'], ['height', 'm'], ...glass] },
    rooflight: { label: 'Rooflight', attributes: [['x', 'm'], ['y', 'm'], ['width', 'm'], ['depth', 'm'], ...glass] },
    opening: { label: 'Opening', attributes: glass },
    blind: { label: 'Blind', attributes: [['slat-width', 'm'], ['spacing', 'm'], ['angle', '\u00b0'], ['cut-off', '', ['yes', 'no']], ['reflectance', '']] },
    shelf: { label: 'Light shelf', attributes: [['height', 'm'], ['depth', 'm'], ['inside', 'm'], ['reflectance', '']] },
    skyline: { label: 'Skyline', attributes: [['wall', ''], ['angle', '\u00b0'], ['distance', 'm'], ['reflectance', '']] },
    facade: { label: 'Fa\u00e7ade', attributes: [['wall', ''], ['left', 'm'], ['right', 'm'], ['up', 'm'], ['down', 'm'], ['reflectance', '']] },
    block: { label: 'Block', attributes: [['x', 'm'], ['y', 'm'], ['base', 'm'], ['width', 'm'], ['depth', 'm'], ['height', 'm'], ['rotate', '\u00b0'], ['roof', '', roofs], ['pitch', '\u00b0'], ['ridge', '', ridges], ['reflectance', ''], ['name', '']] },
    surface: { label: 'Surface', attributes: [['reflectance', '']] },
    furniture: { label: 'Furniture', attributes: [['x', 'm'], ['y', 'm'], ['width', 'm'], ['depth', 'm'], ['height', 'm'], ['reflectance', '']] },
    column: { label: 'Column', attributes: [['x', 'm'], ['y', 'm'], ['width', 'm'], ['depth', 'm'], ['reflectance', '']] },
    partition: { label: 'Partition', attributes: [['from', 'm'], ['to', 'm'], ['height', 'm'], ['reflectance', '']] },
    garden: { label: 'Garden', attributes: [['name', '']] },
    'working-plane': { label: 'Working plane', attributes: [['height', 'm']] },
    point: { label: 'Point', attributes: [['x', 'm'], ['y', 'm'], ['z', 'm']] },
    line: { label: 'Line of points', attributes: [['from', 'm'], ['to', 'm'], ['points', '']] },
    grid: { label: 'Grid of points', attributes: [['spacing', 'm'], ['margin', 'm']] },
};

export function labelOf(element) {
    const kind = KINDS[element.name]?.label ?? element.name;
    const a = element.attributes;
    const about = a.name?.value ?? a.wall?.value ?? '';
    return about ? `${kind}, ${about}` : kind;
}

// Attributes to show for an element: those of its kind, and others that it has.
export function attributesOf(element) {
    const known = KINDS[element.name]?.attributes ?? [];
    const others = Object.keys(element.attributes).filter((name) => name !== 'version' && !known.some(([k]) => k === name));
    const isPolygon = element.name === 'plan' && element.children.length > 0;
    return [...known.filter(([name]) => !isPolygon || name === 'height'), ...others.map((name) => [name, ''])];
}

// What can be added to a room; bounds: [xMin, xMax, yMin, yMax] of the room, wall: a name.
export const NEW_PARTS = {
    window: (b, wall) => `<window wall="${wall}" left="0.5" sill="0.9" width="1.2" height="1.2" glazing="clear-double"/>`,
    rooflight: (b) => `<rooflight x="${mid(b[0], b[1], -0.5)}" y="${mid(b[2], b[3], -0.5)}" width="1" depth="1" glazing="clear-double"/>`,
    skyline: (b, wall) => `<skyline wall="${wall}" angle="20" reflectance="0.2"/>`,
    block: (b) => `<block x="${mid(b[0], b[1], -5)}" y="${(b[2] - 15).toFixed(2)}" width="10" depth="5" base="0" height="6" reflectance="0.2"/>`,
    point: (b) => `<point x="${mid(b[0], b[1])}" y="${mid(b[2], b[3])}"/>`,
    line: (b) => `<line from="${mid(b[0], b[1])} ${(b[2] + 0.5).toFixed(2)}" to="${mid(b[0], b[1])} ${(b[3] - 0.5).toFixed(2)}" points="9"/>`,
    grid: () => '<grid spacing="0.5" margin="0.5"/>',
    'working-plane': () => '<working-plane height="0.85"/>',
    sky: () => '<sky type="uniform"/>',
    blind: () => '<blind slat-width="0.08" spacing="0.07" angle="0" reflectance="0.6"/>',
};

function mid(least, most, by = 0) {
    return String(Number(((least + most) / 2 + by).toFixed(2)));
}
