// geometry.js - geometry of the engine's scene for the views: points, the axes of walls, sections
// by a vertical plane, and the patches of sun on surfaces. Metres; +x right, +y up the plan, +z up.

export const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => {
    const length = Math.hypot(...a) || 1;
    return a.map((c) => c / length);
};

export function pointsOf(xyz) {
    const points = [];
    for (let i = 0; i + 2 < xyz.length; i += 3) points.push([xyz[i], xyz[i + 1], xyz[i + 2]]);
    return points;
}

export function pairsOf(xy) {
    const points = [];
    for (let i = 0; i + 1 < xy.length; i += 2) points.push([xy[i], xy[i + 1]]);
    return points;
}

export function normalOf(points) {
    let sum = [0, 0, 0];
    for (let i = 1; i + 1 < points.length; i++)
        sum = sum.map((c, k) => c + cross(sub(points[i], points[0]), sub(points[i + 1], points[0]))[k]);
    return unit(sum);
}

export function rangeOf(points, axis) {
    return [Math.min(...points.map((p) => p[axis])), Math.max(...points.map((p) => p[axis]))];
}

// Axes of a wall as an elevation from outside shows it: u to the right, v up, from its lower
// left corner. to(point) gives [u, v]; from([u, v]) the point.
export function wallAxes(surface) {
    const points = pointsOf(surface.xyz);
    const outwards = normalOf(points).map((c) => -c);
    let along = cross([0, 0, 1], outwards);
    along = Math.hypot(...along) < 1e-6 ? [1, 0, 0] : unit(along);
    const up = unit(cross(outwards, along));
    const [least] = rangeOf(points.map((p) => [dot(p, along)]), 0);
    const [lowest] = rangeOf(points.map((p) => [dot(p, up)]), 0);
    const depth = dot(points[0], outwards);
    return {
        along, up, outwards,
        outline: points.map((p) => [dot(p, along) - least, dot(p, up) - lowest]),
        to: (p) => [dot(p, along) - least, dot(p, up) - lowest],
        from: ([u, v]) => [0, 1, 2].map((k) => along[k] * (u + least) + up[k] * (v + lowest) + outwards[k] * depth),
    };
}

// Cuts polygons with the vertical plane through `at` along `direction` [dx, dy]: segments
// [[s, z], [s, z]] with s along the direction from `at`.
export function cutBy(points, at, direction) {
    const across = [-direction[1], direction[0]];
    const side = (p) => (p[0] - at[0]) * across[0] + (p[1] - at[1]) * across[1];
    const along = (p) => (p[0] - at[0]) * direction[0] + (p[1] - at[1]) * direction[1];
    const cuts = [];
    for (let i = 0; i < points.length; i++) {
        const a = points[i], b = points[(i + 1) % points.length];
        const da = side(a) + 1e-9, db = side(b) + 1e-9;
        if (da > 0 === db > 0) continue;
        const t = da / (da - db);
        const p = a.map((c, k) => c + t * (b[k] - c));
        cuts.push([along(p), p[2]]);
    }
    cuts.sort((p, q) => p[0] - q[0] || p[1] - q[1]);
    const segments = [];
    for (let i = 0; i + 1 < cuts.length; i += 2) segments.push([cuts[i], cuts[i + 1]]);
    return segments;
}

// Is a position within the rings of the working plane?
export function isInPlane(rings, [x, y]) {
    let inside = false;
    for (const ring of rings)
        for (let i = 0, k = ring.length - 2; i < ring.length; k = i, i += 2) {
            const [ax, ay, bx, by] = [ring[i], ring[i + 1], ring[k], ring[k + 1]];
            if (ay > y !== by > y && x < (bx - ax) * (y - ay) / (by - ay) + ax) inside = !inside;
        }
    return inside;
}

export function scenePlanBounds(scene, withOutside) {
    const points = [];
    for (const surface of scene.surfaces)
        if (surface.inside ? surface.role !== 'surface' : withOutside && surface.role === 'block') points.push(...pointsOf(surface.xyz));
    return [...rangeOf(points, 0), ...rangeOf(points, 1)];
}

// ---- the sun ----

// Altitude and bearing (degrees, clockwise from north) of the sun: declination and equation of time
// by the series of Spencer (1971), to about 0.1 degrees and half a minute. time: standard time of
// the nearest whole-hour zone, in hours.
export function sunPlace(latitude, longitude, month, day, time) {
    const rad = Math.PI / 180;
    const starts = [0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334];
    const g = 2 * Math.PI / 365 * (starts[month - 1] + day - 1 + (time - 12) / 24);
    const declination = 0.006918 - 0.399912 * Math.cos(g) + 0.070257 * Math.sin(g) - 0.006758 * Math.cos(2 * g)
        + 0.000907 * Math.sin(2 * g) - 0.002697 * Math.cos(3 * g) + 0.00148 * Math.sin(3 * g);
    const equation = 229.18 * (0.000075 + 0.001868 * Math.cos(g) - 0.032077 * Math.sin(g) - 0.014615 * Math.cos(2 * g) - 0.040849 * Math.sin(2 * g));
    const zone = Math.round(longitude / 15);
    const hour = (15 * (time - 12) + (longitude - 15 * zone) + equation / 4) * rad;
    const phi = latitude * rad;
    const sine = Math.sin(phi) * Math.sin(declination) + Math.cos(phi) * Math.cos(declination) * Math.cos(hour);
    const bearing = Math.atan2(-Math.cos(declination) * Math.sin(hour), Math.sin(declination) * Math.cos(phi) - Math.cos(declination) * Math.sin(phi) * Math.cos(hour));
    return { altitude: Math.asin(sine) / rad, bearing: (bearing / rad + 360) % 360 };
}

// Direction to the sun in the room's axes.
export function sunDirection(place, north) {
    const rad = Math.PI / 180, turn = (place.bearing - north) * rad, altitude = place.altitude * rad;
    return [Math.sin(turn) * Math.cos(altitude), Math.cos(turn) * Math.cos(altitude), Math.sin(altitude)];
}

// Shadow of a polygon on a plane (a point of it and its normal) along the sun's direction, as
// points of the plane; null if there is none. Only the part of the polygon on the sun's side of the
// plane casts a shadow.
export function shadowOn(points, planePoint, normal, sun) {
    const slope = dot(sun, normal);
    if (Math.abs(slope) < 1e-6) return null;
    const heights = points.map((p) => dot(sub(p, planePoint), normal) / slope);
    const kept = [];
    for (let i = 0; i < points.length; i++) {
        const k = (i + 1) % points.length, a = heights[i], b = heights[k];
        if (a > 1e-6) kept.push(points[i].map((c, j) => c - a * sun[j]));
        if (a > 1e-6 !== b > 1e-6) {
            const t = a / (a - b);
            kept.push(points[i].map((c, j) => c + t * (points[k][j] - c)));
        }
    }
    return kept.length > 2 ? kept : null;
}
