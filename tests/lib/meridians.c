/* meridians.c - integrates the direct component along meridians (meridians.h). */
#include "tests/lib/meridians.h"

#include <cubature.h>
#include <float.h>
#include <stdlib.h>

enum { CORNERS = 16, SHAPES = 40, CUTS = 1000, STOPS = 40000, WEB = 400 };

/* A polygon seen from the eye. */
struct shape {
    int count;
    struct pp_vec3 corners[CORNERS]; /* relative to the eye */
    struct pp_vec3 nearness;         /* nearness . u is the inverse of the distance
                                      * along u */
    double reflectance, exitance;
};

struct sight {
    const struct pp_world *world;
    const struct pp_outside_light *light;
    const struct pp_opening *opening;
    struct pp_vec3 normal; /* the receiver's */
    struct shape inner, outer;
    struct shape shapes[SHAPES];
    int shape_count;
    bool colours; /* true if the shapes have different luminances */
    double relative_error;
};

/* ---- one meridian ---- */

/* Interval of a shape on the meridian; `starts`: the nadir is inside. */
struct track {
    double cuts[CORNERS];
    int count;
    bool starts;
};

static struct track track_of(const struct shape *shape, struct pp_vec3 level)
{
    struct pp_vec3 side = {-level.y, level.x, 0.0};
    struct track track = {.count = 0};
    for (int i = 0, k = shape->count - 1; i < shape->count; k = i++) {
        double a = pp_vec_dot(side, shape->corners[k]),
               b = pp_vec_dot(side, shape->corners[i]);
        if ((a > 0.0) == (b > 0.0))
            continue;
        double t = a / (a - b);
        struct pp_vec3 at = pp_vec_along(
            shape->corners[k], t, pp_vec_sub(shape->corners[i], shape->corners[k]));
        double out = pp_vec_dot(level, at);
        if (out > 0.0)
            track.cuts[track.count++] = atan2(at.z, out);
    }
    /* For an odd number of crossings the shape contains the zenith or the nadir,
     * whichever its plane meets. */
    track.starts = track.count % 2 == 1 && shape->nearness.z < 0.0;
    return track;
}

static bool is_on(const struct track *track, double altitude)
{
    bool on = track->starts;
    for (int i = 0; i < track->count; i++)
        if (track->cuts[i] < altitude)
            on = !on;
    return on;
}

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* First object on a ray behind the opening. */
enum meets { NOTHING, OPEN, HIDDEN };

struct hit {
    enum meets meets;
    double reflectance, exitance;
};

/* True if the skyline hides u. Skylines with a distance are among the shapes
 * instead. */
static bool meets_skyline(const struct sight *sight, const struct pp_skyline *skyline,
                          struct pp_vec3 u)
{
    struct pp_vec3 in = sight->world->surfaces[skyline->face].outline.normal;
    double out = -(u.x * in.x + u.y * in.y) / hypot(in.x, in.y);
    return isinf(skyline->distance_m) && out > 0.0 && u.z > 0.0
           && u.z / out < tan(skyline->angle_rad);
}

static struct hit cast(const struct sight *sight, const struct track *tracks,
                       const struct track *inner, const struct track *outer,
                       struct pp_vec3 u, double altitude)
{
    struct hit hit = {NOTHING, 0.0, 0.0};
    double opening = pp_vec_dot(sight->inner.nearness, u), nearest = -1.0;
    if (!(opening > 0.0) || !is_on(inner, altitude) || !is_on(outer, altitude))
        return hit;
    for (int i = 0; i < sight->shape_count; i++) {
        if (!is_on(&tracks[i], altitude))
            continue;
        double nearness = pp_vec_dot(sight->shapes[i].nearness, u);
        if (nearness > opening * (1.0 + 1e-12))
            return hit;
        if (nearness > nearest) {
            nearest = nearness;
            hit.reflectance = sight->shapes[i].reflectance;
            hit.exitance = sight->shapes[i].exitance;
        }
    }
    for (int i = 0; i < sight->world->skyline_count; i++) {
        const struct pp_skyline *skyline = &sight->world->skylines[i];
        if (skyline->face != sight->opening->face || !meets_skyline(sight, skyline, u)
            || nearest >= 0.0)
            continue;
        nearest = 0.0;
        hit.reflectance = skyline->reflectance;
        hit.exitance = 0.0;
    }
    hit.meets = nearest >= 0.0 ? HIDDEN : OPEN;
    return hit;
}

/* Integrand along one piece of a meridian. */
struct beam {
    const struct sight *sight;
    struct pp_vec3 level;
    enum { SKY, HORIZON, UNITY } what;
};

static int at_altitude(unsigned dim, const double *altitude, void *data, unsigned fdim,
                       double *value)
{
    (void)dim, (void)fdim;
    const struct beam *beam = data;
    const struct sight *sight = beam->sight;
    double c = cos(*altitude);
    struct pp_vec3 u = pp_vec(beam->level.x * c, beam->level.y * c, sin(*altitude));
    struct pp_vec3 flat = pp_vec(beam->level.x, beam->level.y, DBL_MIN);
    double light = beam->what == UNITY ? 1.0
                   : beam->what == SKY ? pp_sky_luminance(&sight->light->sky, u)
                                       : pp_sky_luminance(&sight->light->sky, flat);
    *value = light * pp_vec_dot(sight->normal, u) * c
             * pp_glass_transmittance(&sight->opening->glass,
                                      -pp_vec_dot(sight->opening->inner.normal, u));
    return 0;
}

static double beam_between(struct beam beam, double from, double to)
{
    const struct sight *sight = beam.sight;
    const struct pp_sky *sky = &sight->light->sky;
    if (sight->opening->glass.panes == 0 && sky->kind != PP_SKY_ISO) {
        double p = pp_vec_dot(sight->normal, beam.level), q = sight->normal.z;
        double s[2] = {sin(from), sin(to)}, c[2] = {cos(from), cos(to)};
        double plain = p * ((to - from) / 2.0 + (s[1] * c[1] - s[0] * c[0]) / 2.0)
                       + q * (s[1] * s[1] - s[0] * s[0]) / 2.0;
        double sine = p * (c[0] * c[0] * c[0] - c[1] * c[1] * c[1]) / 3.0
                      + q * (s[1] * s[1] * s[1] - s[0] * s[0] * s[0]) / 3.0;
        if (beam.what == UNITY)
            return plain;
        if (sky->kind == PP_SKY_UNIFORM)
            return plain / PP_PI;
        if (beam.what == HORIZON)
            return plain * 3.0 / (7.0 * PP_PI);
        return (plain + 2.0 * sine) * 3.0 / (7.0 * PP_PI);
    }
    double value, error;
    hcubature(1, at_altitude, &beam, 1, &from, &to, 20000, 1e-17,
              0.1 * sight->relative_error, ERROR_INDIVIDUAL, &value, &error);
    return value;
}

static void add_cut(double *cuts, int *count, double rise, double run)
{
    /* solves rise sin + run cos = 0 */
    if (*count < CUTS && (rise != 0.0 || run != 0.0))
        cuts[(*count)++] = rise != 0.0 ? atan(-run / rise) : 0.0;
}

/* One meridian, with the intervals of the opening and the shapes on it. */
struct meridian {
    struct pp_vec3 level; /* horizontal unit vector of its azimuth */
    struct track inner, outer, tracks[SHAPES];
    double cuts[CUTS]; /* altitudes between which only one object is visible */
    int cut_count;
};

/* Adds the altitudes at which shapes begin or end, or at which they change order with
 * each other or with the opening. */
static void cut_at_shapes(struct meridian *meridian, const struct sight *sight)
{
    double *cuts = meridian->cuts;
    int count = meridian->cut_count;
    for (int i = 0; i < sight->shape_count; i++) {
        struct track *track = &meridian->tracks[i];
        *track = track_of(&sight->shapes[i], meridian->level);
        for (int k = 0; k < track->count; k++)
            cuts[count++] = track->cuts[k];
        if (track->count == 0)
            continue;
        struct pp_vec3 apart =
            pp_vec_sub(sight->shapes[i].nearness, sight->inner.nearness);
        add_cut(cuts, &count, apart.z, pp_vec_dot(apart, meridian->level));
        for (int k = 0; k < i; k++) {
            apart = pp_vec_sub(sight->shapes[i].nearness, sight->shapes[k].nearness);
            if (meridian->tracks[k].count > 0)
                add_cut(cuts, &count, apart.z, pp_vec_dot(apart, meridian->level));
        }
    }
    meridian->cut_count = count;
}

/* Adds the altitudes of skylines without a distance. */
static void cut_at_skylines(struct meridian *meridian, const struct sight *sight)
{
    const struct pp_world *world = sight->world;
    struct pp_vec3 level = meridian->level;
    double *cuts = meridian->cuts;
    int count = meridian->cut_count;
    for (int i = 0; i < world->skyline_count; i++) {
        const struct pp_skyline *skyline = &world->skylines[i];
        const struct pp_polygon *wall = &world->surfaces[skyline->face].outline;
        double along = hypot(wall->normal.x, wall->normal.y);
        double out = -pp_vec_dot(level, wall->normal) / along;
        if (isinf(skyline->distance_m))
            cuts[count++] = atan(tan(skyline->angle_rad) * out);
    }
    meridian->cut_count = count;
}

/* Adds the light between two altitudes with one visible object to value: sky, and
 * external. */
static void add_piece(double value[2], const struct sight *sight,
                      const struct meridian *meridian, double from, double to)
{
    struct pp_vec3 level = meridian->level;
    double middle = (from + to) / 2.0;
    struct pp_vec3 u =
        pp_vec(level.x * cos(middle), level.y * cos(middle), sin(middle));
    if (!(pp_vec_dot(sight->normal, u) > 0.0))
        return;
    struct hit hit =
        cast(sight, meridian->tracks, &meridian->inner, &meridian->outer, u, middle);
    if (hit.meets == NOTHING)
        return;
    struct beam beam = {sight, level, middle > 0.0 ? SKY : HORIZON};
    struct beam plain = {sight, level, UNITY};
    double factor =
        hit.reflectance * (sight->light->sky.kind == PP_SKY_OVERCAST ? 1.0 : 0.5);
    if (hit.meets == HIDDEN) {
        value[1] += factor * beam_between(beam, from, to);
        if (hit.exitance > 0.0)
            value[1] += hit.exitance / PP_PI * beam_between(plain, from, to);
    } else if (middle > 0.0) {
        value[0] += beam_between(beam, from, to);
    } else {
        value[1] +=
            sight->light->ground_reflectance / PP_PI * beam_between(plain, from, to);
    }
}

static int at_azimuth(unsigned dim, const double *azimuth, void *data, unsigned fdim,
                      double *value)
{
    (void)dim, (void)fdim;
    const struct sight *sight = data;
    struct meridian meridian;
    meridian.level = pp_vec(cos(*azimuth), sin(*azimuth), 0.0);
    meridian.inner = track_of(&sight->inner, meridian.level);
    meridian.outer = track_of(&sight->outer, meridian.level);

    value[0] = value[1] = 0.0;
    if (meridian.inner.count == 0)
        return 0;
    double *cuts = meridian.cuts;
    int count = 0;
    cuts[count++] = -PP_PI / 2.0;
    cuts[count++] = PP_PI / 2.0;
    cuts[count++] = 0.0;
    add_cut(cuts, &count, sight->normal.z, pp_vec_dot(sight->normal, meridian.level));
    for (int i = 0; i < meridian.inner.count; i++)
        cuts[count++] = meridian.inner.cuts[i];
    for (int i = 0; i < meridian.outer.count; i++)
        cuts[count++] = meridian.outer.cuts[i];
    meridian.cut_count = count;
    cut_at_shapes(&meridian, sight);
    cut_at_skylines(&meridian, sight);
    qsort(cuts, (size_t)meridian.cut_count, sizeof *cuts, by_size);
    for (int i = 0; i + 1 < meridian.cut_count; i++)
        if (cuts[i + 1] > cuts[i])
            add_piece(value, sight, &meridian, cuts[i], cuts[i + 1]);
    return 0;
}

/* ---- all meridians ---- */

static struct shape shape_of(const struct pp_polygon *outline, struct pp_vec3 eye)
{
    struct shape shape = {.count = outline->count};
    for (int i = 0; i < outline->count && i < CORNERS; i++)
        shape.corners[i] = pp_vec_sub(outline->vertices[i], eye);
    shape.nearness = pp_vec_scale(outline->normal,
                                  1.0 / pp_vec_dot(outline->normal, shape.corners[0]));
    return shape;
}

static double azimuth_of(struct pp_vec3 v)
{
    double azimuth = atan2(v.y, v.x);
    return azimuth < 0.0 ? azimuth + 2.0 * PP_PI : azimuth;
}

/* Adds azimuths at which two edges appear to cross. */
static void add_crossings(double *stops, int *count, const struct shape *one,
                          const struct shape *other)
{
    for (int i = 0, k = one->count - 1; i < one->count; k = i++) {
        struct pp_vec3 a = one->corners[k], b = one->corners[i],
                       ab = pp_vec_cross(a, b);
        for (int m = 0, l = other->count - 1; m < other->count; l = m++) {
            struct pp_vec3 c = other->corners[l], d = other->corners[m];
            struct pp_vec3 cd = pp_vec_cross(c, d);
            if (pp_vec_dot(ab, c) * pp_vec_dot(ab, d) > 0.0
                || pp_vec_dot(cd, a) * pp_vec_dot(cd, b) > 0.0 || *count + 2 > STOPS)
                continue;
            struct pp_vec3 w = pp_vec_cross(ab, cd);
            if (w.x == 0.0 && w.y == 0.0)
                continue;
            stops[(*count)++] = azimuth_of(w);
            stops[(*count)++] = azimuth_of(pp_vec_scale(w, -1.0));
        }
    }
}

static void add_corners(double *stops, int *count, const struct shape *shape)
{
    for (int i = 0; i < shape->count && *count < STOPS; i++)
        stops[(*count)++] = azimuth_of(shape->corners[i]);
}

/* Adds azimuths at which edges cross the plane through the eye normal to `square`. */
static void add_circle(double *stops, int *count, const struct shape *shape,
                       struct pp_vec3 square)
{
    for (int i = 0, k = shape->count - 1; i < shape->count; k = i++) {
        struct pp_vec3 a = shape->corners[k], b = shape->corners[i];
        double da = pp_vec_dot(square, a), db = pp_vec_dot(square, b);
        if (da * db < 0.0 && *count < STOPS)
            stops[(*count)++] =
                azimuth_of(pp_vec_along(a, da / (da - db), pp_vec_sub(b, a)));
    }
}

/* Points where a shape's edges cross a plane, as a shape: along this seam the two
 * change order. */
static struct shape seam_of(const struct shape *shape, struct pp_vec3 nearness)
{
    struct shape seam = {.count = 0};
    for (int i = 0, k = shape->count - 1; i < shape->count; k = i++) {
        struct pp_vec3 a = shape->corners[k], b = shape->corners[i];
        double da = pp_vec_dot(nearness, a) - 1.0, db = pp_vec_dot(nearness, b) - 1.0;
        if (da * db < 0.0)
            seam.corners[seam.count++] =
                pp_vec_along(a, da / (da - db), pp_vec_sub(b, a));
    }
    return seam;
}

/* Shapes, all seams, and the relevant great circles. */
struct web {
    struct shape shapes[WEB];
    int shape_count;
    struct pp_vec3 circles[8];
    int circle_count;
};

static void add_to_web(struct web *web, const struct shape *shape)
{
    if (shape->count > 0 && web->shape_count < WEB)
        web->shapes[web->shape_count++] = *shape;
}

static void add_seams(struct web *web, const struct sight *sight, struct pp_vec3 plane)
{
    for (int i = 0; i < sight->shape_count; i++) {
        struct shape seam = seam_of(&sight->shapes[i], plane);
        add_to_web(web, &seam);
    }
}

static void weave(struct web *web, const struct sight *sight, struct pp_vec3 eye)
{
    const struct pp_world *world = sight->world;
    web->shape_count = web->circle_count = 0;
    add_to_web(web, &sight->inner);
    add_to_web(web, &sight->outer);
    for (int i = 0; i < sight->shape_count; i++)
        add_to_web(web, &sight->shapes[i]);
    add_seams(web, sight, sight->inner.nearness);
    for (int i = 0; i < sight->shape_count; i++)
        if (sight->colours)
            add_seams(web, sight, sight->shapes[i].nearness);
    web->circles[web->circle_count++] = pp_vec(0.0, 0.0, 1.0);
    web->circles[web->circle_count++] = sight->normal;
    for (int i = 0; i < world->skyline_count && web->circle_count + 2 <= 8; i++) {
        const struct pp_skyline *skyline = &world->skylines[i];
        struct pp_vec3 n = world->surfaces[skyline->face].outline.normal;
        double level = hypot(n.x, n.y);
        struct pp_vec3 out = {-n.x / level, -n.y / level, 0.0};
        struct pp_vec3 v = world->surfaces[skyline->face].outline.vertices[0];
        double away = (n.x * (eye.x - v.x) + n.y * (eye.y - v.y)
                       + n.z * (skyline->middle_z_m - v.z))
                          / level
                      + skyline->distance_m;
        bool far = isinf(skyline->distance_m);
        double rise =
            far ? tan(skyline->angle_rad) : (skyline->head_z_m - eye.z) / away;
        double fall = far ? 0.0 : (world->ground_level_m - eye.z) / away;
        web->circles[web->circle_count++] = pp_vec(-rise * out.x, -rise * out.y, 1.0);
        web->circles[web->circle_count++] = pp_vec(-fall * out.x, -fall * out.y, 1.0);
        if (!far)
            add_seams(web, sight, pp_vec_scale(out, 1.0 / away));
    }
}

struct pp_meridian_sums pp_meridians(const struct pp_world *world,
                                     const struct pp_outside_light *light,
                                     const struct pp_opening *opening,
                                     const struct pp_receiver *receiver,
                                     double relative_error, int parts)
{
    struct sight sight = {.world = world,
                          .light = light,
                          .opening = opening,
                          .normal = receiver->normal,
                          .inner = shape_of(&opening->inner, receiver->position),
                          .outer = shape_of(&opening->outer, receiver->position),
                          .relative_error = relative_error};
    struct pp_meridian_sums sums = {0.0, 0.0};
    if (!(pp_vec_dot(opening->inner.normal, sight.inner.corners[0]) < 0.0))
        return sums;
    for (int i = 0; i < world->surface_count && sight.shape_count < SHAPES; i++) {
        const struct pp_surface *surface = &world->surfaces[i];
        if (i == opening->face || surface->role == PP_REVEAL)
            continue;
        struct shape *shape = &sight.shapes[sight.shape_count++];
        *shape = shape_of(&surface->outline, receiver->position);
        bool front = pp_vec_dot(surface->outline.normal, shape->corners[0]) < 0.0;
        shape->reflectance = front ? surface->front : surface->back;
        shape->exitance = surface->exitance;
        sight.colours = sight.colours
                        || shape->reflectance != sight.shapes[0].reflectance
                        || shape->exitance != sight.shapes[0].exitance;
    }

    double *stops = malloc(STOPS * sizeof *stops);
    struct web *web = malloc(sizeof *web);
    if (!stops || !web)
        abort();
    weave(web, &sight, receiver->position);
    int count = 0;
    stops[count++] = 0.0;
    stops[count++] = 2.0 * PP_PI;
    for (int i = 0; i < web->shape_count; i++) {
        add_corners(stops, &count, &web->shapes[i]);
        for (int k = 0; k < i; k++)
            add_crossings(stops, &count, &web->shapes[k], &web->shapes[i]);
        for (int k = 0; k < web->circle_count; k++)
            add_circle(stops, &count, &web->shapes[i], web->circles[k]);
    }
    free(web);
    qsort(stops, (size_t)count, sizeof *stops, by_size);
    /* Divides each interval, in case it contains a narrow feature, such as an edge
     * close to the zenith. */
    for (int k = 0; k < (count - 1) * parts; k++) {
        int i = k / parts;
        double width = (stops[i + 1] - stops[i]) / parts, value[2], error[2];
        double low = stops[i] + width * (k % parts), high = low + width;
        if (!(width > 1e-15))
            continue;
        hcubature(2, at_azimuth, &sight, 1, &low, &high, 20000, 1e-17, relative_error,
                  ERROR_INDIVIDUAL, value, error);
        sums.sky += value[0];
        sums.external += value[1];
    }
    free(stops);
    return sums;
}
