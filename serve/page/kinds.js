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

// The kind of an element, with a number if there are several of it, and its name or wall.
export function labelOf(element) {
    const kind = KINDS[element.name]?.label ?? element.name;
    const same = element.parent?.children.filter((e) => e.name === element.name) ?? [];
    const number = same.length > 1 ? ` ${same.indexOf(element) + 1}` : '';
    const about = element.attributes.name?.value ?? element.attributes.wall?.value ?? '';
    return `${kind}${number}${about && `, ${about}`}`;
}

// Attributes to show for an element: those of its kind, and others that it has.
export function attributesOf(element) {
    const known = KINDS[element.name]?.attributes ?? [];
    const others = Object.keys(element.attributes).filter((name) => name !== 'version' && !known.some(([k]) => k === name));
    const isPolygon = element.name === 'plan' && element.children.length > 0;
    const roof = element.attributes.roof?.value ?? 'flat', ofRoof = { pitch: roof !== 'flat', ridge: roof !== 'flat', teeth: roof === 'saw-tooth' };
    return [...known.filter(([name]) => (!isPolygon || name === 'height') && (ofRoof[name] ?? true)), ...others.map((name) => [name, ''])];
}

// Explanations of attributes, shown while one is being changed.
export const HINTS = {
    wall: 'Walls of a rectangular plan are north, east, south and west; those of another plan are numbered from its first corner.',
    left: 'From the left end of the wall, seen from outside.',
    sill: 'Height of the lower edge of the opening above the floor.',
    transmittance: 'Instead of glazing: transmittance of one pane at normal incidence, from 0 to 1.',
    'frame-factor': 'Area of glass divided by the area of the opening, from 0 to 1. Empty: 1.',
    maintenance: 'Light that dirty glass transmits, relative to clean glass, from 0 to 1; or auto. Empty: 1.',
    reveal: 'Distance from the inner face of the wall to the glass. Empty: 0.',
    north: 'Bearing of the upward direction of the plan, clockwise from true north. 0: the south wall faces south.',
    use: 'For example bedroom, living-room, kitchen, office or classroom: only criteria for this use are assessed.',
    'ground-reflectance': 'From 0 to 1. Empty: 0.2.',
    surroundings: 'Determines the dirt on glass with the maintenance auto.',
    country: 'Two capital letters, such as GB: determines the criteria.',
    floor: 'Reflectance from 0 to 1, or the name of a finish, such as oak-floor.',
    walls: 'Reflectance from 0 to 1, or the name of a finish, such as light.',
    ceiling: 'Reflectance from 0 to 1, or the name of a finish, such as white-paint.',
    reflectance: 'From 0 to 1, or the name of a finish, such as brick.',
    angle: 'Of a skyline: above the horizontal, from the middle of the windows. Of slats: 0 is normal to the glass.',
    distance: 'From the wall. Empty: the angle is the same from every point of the room.',
    base: 'Height of the underside. Empty: the ground.',
    rotate: 'Counter-clockwise, about the corner at x, y.',
    from: 'x and y in metres, separated by a blank.', to: 'x and y in metres, separated by a blank.',
    margin: 'Distance of the grid from the walls.', spacing: 'Greatest distance between neighbours.',
    'cut-off': 'yes: the slats follow the sun; then clear the angle.',
};

// Values that hold while an attribute is empty, as grey text in its field.
export const USUAL = {
    glazing: 'clear-single', 'frame-factor': '1', maintenance: '1', reveal: '0', roof: 'flat', ridge: 'longer', rotate: '0', north: '0',
    'ground-reflectance': '0.2', surroundings: 'rural', transmittance: 'by glazing', distance: 'infinite', type: 'overcast', 'cut-off': 'no',
};

// Explanations in the list of parts that can be added.
export const ABOUT_NEW = {
    block: ' (building outside)', skyline: ' (obstruction outside, by its angle)', point: ' for figures', sky: ' (instead of overcast)', blind: ' (of the selected window)',
};

// What can be added to a room; bounds: [xMin, xMax, yMin, yMax] of the room; place: of a window
// { wall, left, width }, of a rooflight { x, y }.
export const NEW_PARTS = {
    window: (b, { wall, left, width }) => `<window wall="${wall}" left="${left}" sill="0.9" width="${width}" height="1.2" glazing="clear-double"/>`,
    rooflight: (b, { x, y }) => `<rooflight x="${x}" y="${y}" width="1" depth="1" glazing="clear-double"/>`,
    skyline: (b, { wall }) => `<skyline wall="${wall}" angle="20" reflectance="0.2"/>`,
    block: (b) => `<block x="${mid(b[0], b[1], -5)}" y="${mid(b[2], b[2], -15)}" width="10" depth="5" base="0" height="6" reflectance="0.2"/>`,
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
