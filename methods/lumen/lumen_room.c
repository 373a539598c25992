/* lumen_room.c - patches of half the room, their form factors, the direct light, and
 * Gauss-Seidel iteration for the interreflections.
 *
 * The window lies in the plane y = 0, with x from -width/2 to width/2 and z from 0
 * (working plane) to 1 (head). The room is symmetric about x = 0, so that only patches
 * with x > 0 are unknown; each exchanges light with the mirror images as well.
 */
#include "methods/lumen/lumen_room.h"

#include <math.h>
#include <stdlib.h>

#include "model/geometry/gauss.h"
#include "methods/lumen/rectangle_factor.h"
#include "methods/exact/solid_angle.h"

const double pp_lumen_places[PP_LUMEN_POINTS] = {0.1, 0.3, 0.5, 0.7, 0.9};

static const double endless_width = 1e4; /* in window heights */

enum part { PLANE, CEILING, BACK, SIDE, PARTS };

struct patch {
    struct pp_aligned_rectangle outline;
    enum part part;
    double area;
    double direct; /* mean direct illuminance, divided by the illuminance of the
                    * window */
    double exitance, illuminance;
};

struct pp_lumen_room {
    double width, depth;
    int count;
    struct patch *patches;
    double *factors; /* [i * count + j]: from i to j and j's mirror image */
    double direct_at[PP_LUMEN_POINTS];
};

/* The part's normal, into the room. SIDE is the wall at x = width/2. */
static struct pp_vec3 normal_of(enum part part)
{
    static const struct pp_vec3 normals[PARTS] = {[PLANE] = {0, 0, 1},
                                                  [CEILING] = {0, 0, -1},
                                                  [BACK] = {0, -1, 0},
                                                  [SIDE] = {-1, 0, 0}};
    return normals[part];
}

/* Cut positions that divide the extent from 0 to `high` into `count` pieces: finer
 * towards 0 if power > 1, finer towards `high` if power < -1. */
struct cuts {
    double high, power;
    int count;
};

static double cut_at(const struct cuts *cuts, int i)
{
    double share = (double)i / cuts->count;
    return cuts->high
           * (cuts->power > 0.0 ? pow(share, cuts->power)
                                : 1.0 - pow(1.0 - share, -cuts->power));
}

/* Appends the patches of one part, a grid along its two axes, to room->patches. */
static void add_grid(struct pp_lumen_room *room, enum part part, int axis, double place,
                     int first_axis, const struct cuts *first, int second_axis,
                     const struct cuts *second)
{
    for (int i = 0; i < first->count; i++)
        for (int j = 0; j < second->count; j++) {
            struct patch *patch = &room->patches[room->count++];
            patch->part = part;
            patch->outline.axis = axis;
            patch->outline.low[axis] = patch->outline.high[axis] = place;
            patch->outline.low[first_axis] = cut_at(first, i);
            patch->outline.high[first_axis] = cut_at(first, i + 1);
            patch->outline.low[second_axis] = cut_at(second, j);
            patch->outline.high[second_axis] = cut_at(second, j + 1);
            patch->area = pp_rectangle_factor_area(&patch->outline);
        }
}

static struct pp_aligned_rectangle mirrored(struct pp_aligned_rectangle outline)
{
    double low = outline.low[0];
    outline.low[0] = -outline.high[0];
    outline.high[0] = -low;
    return outline;
}

static void fill_factors(struct pp_lumen_room *room)
{
    int n = room->count;
    for (int i = 0; i < n; i++)
        for (int j = i; j < n; j++) {
            const struct patch *a = &room->patches[i], *b = &room->patches[j];
            struct pp_aligned_rectangle image = mirrored(b->outline);
            double exchange =
                pp_rectangle_factor_exchange_area(&a->outline, &b->outline)
                + pp_rectangle_factor_exchange_area(&a->outline, &image);
            room->factors[i * n + j] = exchange / a->area;
            room->factors[j * n + i] = exchange / b->area;
        }
}

enum pp_status pp_lumen_room_create(struct pp_lumen_room **result, double width,
                                    double depth, int fineness, struct pp_error *err)
{
    bool endless = isinf(width);
    double w = endless ? endless_width : width;
    int n_x = endless ? 1 : fineness * (int)fmin(fmax(ceil(2.0 * w), 3.0), 6.0);
    int n_y = fineness * (int)(12.0 + ceil(fmin(2.0 * depth, 20.0)));
    int n_z = fineness * 7;
    /* A mesh twice as fine changes the coefficients by at most 0.7 % (sky) and 1.3 %
     * (ground). The powers were chosen by trial. */
    const struct cuts x = {w / 2.0, -1.3, n_x}, y = {depth, 1.4, n_y},
                      z = {1.0, 1.0, n_z};
    int count = 2 * n_x * n_y + n_y * n_z + n_x * n_z;
    struct pp_lumen_room *room = calloc(1, sizeof *room);
    if (!room)
        return pp_fail_memory(err);
    room->width = w;
    room->depth = depth;
    room->patches = calloc((size_t)count, sizeof *room->patches);
    room->factors = malloc((size_t)count * (size_t)count * sizeof *room->factors);
    if (!room->patches || !room->factors) {
        pp_lumen_room_destroy(room);
        return pp_fail_memory(err);
    }
    add_grid(room, PLANE, 2, 0.0, 0, &x, 1, &y);
    add_grid(room, CEILING, 2, 1.0, 0, &x, 1, &y);
    add_grid(room, BACK, 1, depth, 0, &x, 2, &z);
    add_grid(room, SIDE, 0, w / 2.0, 1, &y, 2, &z);
    fill_factors(room);
    *result = room;
    return PP_OK;
}

void pp_lumen_room_destroy(struct pp_lumen_room *room)
{
    if (!room)
        return;
    free(room->patches);
    free(room->factors);
    free(room);
}

/* A light source outside: a sky or, if NULL, an evenly bright ground. Luminances are
 * divided by the window's illuminance. */
struct source {
    const struct pp_sky *sky;
    double per_window;
};

static double luminance(const struct source *source, struct pp_vec3 u)
{
    return source->sky ? pp_sky_luminance(source->sky, u) * source->per_window
                       : 2.0 / PP_PI; /* the ground fills half the hemisphere */
}

/* Direct illuminance at p on a plane with that normal. The window's jambs are lines of
 * constant azimuth, and its part above (below) the horizon extends from altitude 0 to
 * the head (sill). The integral is by a Gauss rule in both angles. */
static double direct_at(const struct pp_lumen_room *room, const struct source *source,
                        struct pp_vec3 p, struct pp_vec3 normal, int order)
{
    double nodes[PP_GAUSS_MOST], weights[PP_GAUSS_MOST];
    pp_gauss_legendre(nodes, weights, order);
    double left = atan2(-room->width / 2.0 - p.x, p.y);
    double right = atan2(room->width / 2.0 - p.x, p.y);
    double edge = source->sky ? 1.0 - p.z : -p.z, sum = 0.0;
    for (int i = 0; i < order; i++) {
        double azimuth = left + (right - left) * (1.0 + nodes[i]) / 2.0;
        double limit = atan2(fabs(edge) * cos(azimuth), p.y), over_altitude = 0.0;
        for (int j = 0; j < order; j++) {
            double altitude = copysign(limit * (1.0 + nodes[j]) / 2.0, edge);
            double c = cos(altitude);
            struct pp_vec3 u =
                pp_vec(c * sin(azimuth), -c * cos(azimuth), sin(altitude));
            over_altitude += weights[j] * luminance(source, u)
                             * fmax(pp_vec_dot(normal, u), 0.0) * c;
        }
        sum += weights[i] * over_altitude * limit / 2.0;
    }
    return sum * (right - left) / 2.0;
}

/* The mean direct illuminance of a patch, by a Gauss rule with two points in each
 * direction. In a room of infinite width, all patches except those of SIDE are
 * evaluated at the middle of the width. */
static double direct_on(const struct pp_lumen_room *room, const struct source *source,
                        const struct patch *patch)
{
    const double g = 0.5 / sqrt(3.0);
    bool endless = room->width == endless_width;
    double sum = 0.0;
    for (int i = 0; i < 4; i++) {
        double along[2] = {i & 1 ? 0.5 + g : 0.5 - g, i & 2 ? 0.5 + g : 0.5 - g};
        double xyz[3];
        for (int axis = 0, k = 0; axis < 3; axis++) {
            double low = patch->outline.low[axis], high = patch->outline.high[axis];
            xyz[axis] =
                axis == patch->outline.axis ? low : low + along[k++] * (high - low);
        }
        if (endless && patch->part != SIDE)
            xyz[0] = 0.0;
        sum += direct_at(room, source, pp_vec(xyz[0], xyz[1], xyz[2]),
                         normal_of(patch->part), 12);
    }
    return sum / 4.0;
}

void pp_lumen_room_light(struct pp_lumen_room *room, const struct pp_sky *sky)
{
    struct source source = {.sky = sky};
    if (sky)
        source.per_window = 1.0 / pp_sky_on_plane(sky, pp_vec(0.0, -1.0, 0.0));
    for (int i = 0; i < room->count; i++)
        room->patches[i].direct = direct_on(room, &source, &room->patches[i]);
    for (int k = 0; k < PP_LUMEN_POINTS; k++) {
        struct pp_vec3 p = {0.0, pp_lumen_places[k] * room->depth, 0.0};
        room->direct_at[k] = direct_at(room, &source, p, pp_vec(0.0, 0.0, 1.0), 48);
    }
}

static void iterate(struct pp_lumen_room *room, const double *reflectances)
{
    int n = room->count;
    for (int i = 0; i < n; i++)
        room->patches[i].exitance = 0.0;
    double change = 1.0;
    for (int sweep = 0; sweep < 1000 && change > 1e-10; sweep++) {
        change = 0.0;
        for (int i = 0; i < n; i++) {
            struct patch *patch = &room->patches[i];
            const double *row = room->factors + (size_t)i * (size_t)n;
            double received = patch->direct;
            for (int j = 0; j < n; j++)
                received += row[j] * room->patches[j].exitance;
            double exitance = reflectances[patch->part] * received;
            change = fmax(change, fabs(exitance - patch->exitance));
            patch->exitance = exitance;
            patch->illuminance = received;
        }
    }
}

/* Illuminance at point k from the patches of ceiling and walls. */
static double reflected_at(const struct pp_lumen_room *room, int k)
{
    double y = pp_lumen_places[k] * room->depth, sum = 0.0;
    const struct pp_vec3 up = {0.0, 0.0, 1.0};
    for (int i = 0; i < room->count; i++) {
        const struct patch *patch = &room->patches[i];
        if (patch->part == PLANE)
            continue;
        const double *low = patch->outline.low, *high = patch->outline.high;
        int a = (patch->outline.axis + 1) % 3, b = (patch->outline.axis + 2) % 3;
        struct pp_vec3 ring[4];
        for (int v = 0; v < 4; v++) {
            double xyz[3] = {low[0], low[1], low[2]};
            xyz[a] = v == 1 || v == 2 ? high[a] : low[a];
            xyz[b] = v >= 2 ? high[b] : low[b];
            ring[v] = pp_vec(xyz[0], xyz[1] - y, xyz[2]);
        }
        struct pp_moments moments = {0};
        pp_solid_angle_add_moments(&moments, ring, 4, up, NULL, 0);
        /* The mirror image contributes the same. */
        sum += 2.0 * fabs(moments.cosine) / PP_PI * patch->exitance;
    }
    return sum;
}

struct pp_lumen_coefficients pp_lumen_room_solve(
    struct pp_lumen_room *room, const struct pp_lumen_finishes *finishes)
{
    const double reflectances[PARTS] = {
        [PLANE] = PP_LUMEN_PLANE,
        [CEILING] = finishes->ceiling,
        [BACK] = finishes->walls,
        [SIDE] = finishes->walls,
    };
    iterate(room, reflectances);

    struct pp_lumen_coefficients cu = {.average = 0.0};
    for (int k = 0; k < PP_LUMEN_POINTS; k++)
        cu.at[k] = room->direct_at[k] + reflected_at(room, k);
    double flux = 0.0, area = 0.0;
    for (int i = 0; i < room->count; i++)
        if (room->patches[i].part == PLANE) {
            flux += room->patches[i].illuminance * room->patches[i].area;
            area += room->patches[i].area;
        }
    cu.average = flux / area;
    return cu;
}

double pp_lumen_room_imbalance(const struct pp_lumen_room *room)
{
    double half = room->width / 2.0, entered = half, kept = 0.0;
    const struct pp_aligned_rectangle window = {1, {0, 0, 0}, {half, 0, 1}};
    for (int i = 0; i < room->count; i++) {
        const struct patch *patch = &room->patches[i];
        struct pp_aligned_rectangle image = mirrored(patch->outline);
        double back = pp_rectangle_factor_exchange_area(&patch->outline, &window)
                      + pp_rectangle_factor_exchange_area(&image, &window);
        kept += (patch->illuminance - patch->exitance) * patch->area
                + patch->exitance * back;
    }
    return kept / entered - 1.0;
}

enum pp_status pp_lumen_room_sky(struct pp_sky *sky, double ev_over_eh,
                                 struct pp_error *err)
{
    *sky = pp_sky_overcast();
    if (ev_over_eh < 0.5)
        return PP_OK;
    const struct pp_vec3 out = {0.0, -1.0, 0.0};
    /* The ratio decreases as the sun's altitude increases. */
    double low = 1.0 * PP_RAD, high = 89.0 * PP_RAD;
    for (int i = 0; i < 40; i++) {
        double altitude = (low + high) / 2.0;
        enum pp_status status =
            pp_sky_iso(sky, 13, pp_vec(0.0, -cos(altitude), sin(altitude)), err);
        if (status != PP_OK)
            return status;
        if (pp_sky_on_plane(sky, out) > ev_over_eh)
            low = altitude;
        else
            high = altitude;
    }
    if (!(fabs(pp_sky_on_plane(sky, out) - ev_over_eh) < 1e-6))
        return pp_fail(err, PP_BAD_INPUT, "no clear sky has the ratio Ev/Eh of %g",
                       ev_over_eh);
    return PP_OK;
}
