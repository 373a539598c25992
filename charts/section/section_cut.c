/* section_cut.c - finds the line of the receivers and cuts the polygons of the world
 * along that line.
 */
#include "charts/section/section_cut.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/array.h"

/* Greatest permitted distance of receivers from their line (m), for coordinates that
 * were rounded. */
#define OFF_LINE_M 1e-3

void pp_section_cut_clear(struct pp_section_cut *cut)
{
    free(cut->list);
    *cut = (struct pp_section_cut){0};
}

double pp_section_cut_s(const struct pp_section_cut *cut, struct pp_vec3 point)
{
    return (point.x - cut->origin[0]) * cut->along[0]
           + (point.y - cut->origin[1]) * cut->along[1];
}

/* Signed distance (m) of a point from the plane of the section. */
static double off_plane(const struct pp_section_cut *cut, struct pp_vec3 point)
{
    return (point.y - cut->origin[1]) * cut->along[0]
           - (point.x - cut->origin[0]) * cut->along[1];
}

/* ---- the line ---- */

/* Sets the direction of the section: the horizontal direction of the inner normal of
 * the opening with the nearest centre, or y if there is no opening. Horizontal openings
 * are ignored. */
static void aim_at_opening(struct pp_section_cut *cut, const struct pp_world *world,
                           struct pp_vec3 point)
{
    double nearest = INFINITY;
    cut->along[0] = 0.0;
    cut->along[1] = 1.0;
    for (int i = 0; i < world->opening_count; i++) {
        const struct pp_polygon *outline = &world->openings[i].inner;
        struct pp_vec3 middle = pp_vec(0, 0, 0);
        for (int k = 0; k < outline->count; k++)
            middle = pp_vec_along(middle, 1.0 / outline->count, outline->vertices[k]);
        double level = hypot(outline->normal.x, outline->normal.y);
        double away = pp_vec_length(pp_vec_sub(middle, point));
        if (level < 1e-6 || away >= nearest)
            continue;
        nearest = away;
        cut->along[0] = outline->normal.x / level;
        cut->along[1] = outline->normal.y / level;
    }
}

static enum pp_status find_line(struct pp_section_cut *cut,
                                const struct pp_world *world,
                                const struct pp_receiver *receivers, int count,
                                struct pp_error *err)
{
    if (count == 0)
        return pp_fail(
            err, PP_BAD_INPUT,
            "a section passes through the calculation points, but there are none");
    struct pp_vec3 first = receivers[0].position;
    int far = 0;
    double reach = 0.0;
    for (int i = 1; i < count; i++) {
        struct pp_vec3 p = receivers[i].position;
        double away = hypot(p.x - first.x, p.y - first.y);
        if (away > reach) {
            reach = away;
            far = i;
        }
    }
    cut->origin[0] = first.x;
    cut->origin[1] = first.y;
    cut->height_m = first.z;
    if (reach > OFF_LINE_M) {
        cut->along[0] = (receivers[far].position.x - first.x) / reach;
        cut->along[1] = (receivers[far].position.y - first.y) / reach;
    } else {
        aim_at_opening(cut, world, first);
    }
    for (int i = 0; i < count; i++) {
        struct pp_vec3 p = receivers[i].position;
        double off = hypot(off_plane(cut, p), p.z - first.z);
        if (off > OFF_LINE_M)
            return pp_fail(err, PP_BAD_INPUT,
                           "a section needs its calculation points on one horizontal "
                           "straight line, but (%g, %g, %g) is %.3g m off the line "
                           "through (%g, %g, %g) and (%g, %g, %g)",
                           p.x, p.y, p.z, off, first.x, first.y, first.z,
                           receivers[far].position.x, receivers[far].position.y,
                           receivers[far].position.z);
    }
    return PP_OK;
}

/* ---- the cut ---- */

static bool add_cut(struct pp_section_cut *cut, struct pp_cut one)
{
    if (pp_array_append(&cut->list, cut->count, sizeof *cut->list, NULL) != PP_OK)
        return false;
    cut->list[cut->count++] = one;
    return true;
}

static int compare_places(const void *a, const void *b)
{
    const double *p = a, *q = b;
    if (fabs(p[0] - q[0]) > 1e-9)
        return p[0] < q[0] ? -1 : 1;
    return (p[1] > q[1]) - (p[1] < q[1]);
}

/* Points where the outline crosses the plane of the section, sorted along the section.
 * Consecutive pairs are the ends of the cuts. The caller frees *places. Returns the
 * number of points; -1: out of memory. */
static int places_of(const struct pp_section_cut *cut, const struct pp_polygon *outline,
                     double (**places)[2])
{
    int count = 0;
    *places = malloc((size_t)outline->count * sizeof **places);
    if (!*places)
        return -1;
    for (int i = 0; i < outline->count; i++) {
        struct pp_vec3 a = outline->vertices[i];
        struct pp_vec3 b = outline->vertices[(i + 1) % outline->count];
        double off_a = off_plane(cut, a), off_b = off_plane(cut, b);
        if ((off_a > 0.0) == (off_b > 0.0))
            continue;
        struct pp_vec3 p = pp_vec_along(a, off_a / (off_a - off_b), pp_vec_sub(b, a));
        (*places)[count][0] = pp_section_cut_s(cut, p);
        (*places)[count++][1] = p.z;
    }
    qsort(*places, (size_t)count, sizeof **places, compare_places);
    return count;
}

static bool cut_polygon(struct pp_section_cut *cut, const struct pp_polygon *outline,
                        enum pp_cut_kind kind, int of)
{
    double(*places)[2];
    int count = places_of(cut, outline, &places);
    bool good = count >= 0;
    for (int i = 0; i + 1 < count && good; i += 2)
        good = add_cut(cut, (struct pp_cut){kind,
                                            of,
                                            {places[i][0], places[i + 1][0]},
                                            {places[i][1], places[i + 1][1]}});
    free(places);
    return good;
}

/* Subtracts the cut openings from the cuts of their faces. Returns false if memory is
 * exhausted. */
static bool open_faces(struct pp_section_cut *cut, const struct pp_world *world)
{
    for (int o = 0; o < cut->count; o++) {
        if (cut->list[o].kind != PP_CUT_OPENING)
            continue;
        struct pp_cut hole = cut->list[o];
        for (int f = 0; f < cut->count; f++) {
            struct pp_cut face = cut->list[f];
            if (face.kind != PP_CUT_FACE || face.of != world->openings[hole.of].face)
                continue;
            /* Positions of both ends of the opening as fractions of the face's cut,
             * which has the same direction. */
            double ds = face.s[1] - face.s[0], dz = face.z[1] - face.z[0];
            double square = ds * ds + dz * dz, share[2];
            for (int k = 0; k < 2 && square > 0.0; k++)
                share[k] = ((hole.s[k] - face.s[0]) * ds + (hole.z[k] - face.z[0]) * dz)
                           / square;
            if (!(square > 0.0) || share[1] < 1e-9 || share[0] > 1.0 - 1e-9)
                continue;
            struct pp_cut rest = face;
            cut->list[f].s[1] = hole.s[0];
            cut->list[f].z[1] = hole.z[0];
            rest.s[0] = hole.s[1];
            rest.z[0] = hole.z[1];
            if (!add_cut(cut, rest))
                return false;
            break;
        }
    }
    return true;
}

static bool cut_world(struct pp_section_cut *cut, const struct pp_world *world)
{
    bool good = true;
    for (int i = 0; i < world->surface_count && good; i++) {
        const struct pp_surface *surface = &world->surfaces[i];
        if (surface->role == PP_REVEAL || surface->role == PP_SKYLINE)
            continue;
        enum pp_cut_kind kind = i < world->face_count       ? PP_CUT_FACE
                                : surface->role == PP_COVER ? PP_CUT_COVER
                                : surface->inside           ? PP_CUT_INSIDE
                                                            : PP_CUT_OUTSIDE;
        good = cut_polygon(cut, &surface->outline, kind, i);
    }
    for (int i = 0; i < world->opening_count && good; i++) {
        good = cut_polygon(cut, &world->openings[i].inner, PP_CUT_OPENING, i);
        if (good && world->openings[i].reveal_m > 0.0)
            good = cut_polygon(cut, &world->openings[i].outer, PP_CUT_GLASS, i);
    }
    return good;
}

/* ---- the end with the window ---- */

static bool has_opening(const struct pp_world *world, int face)
{
    for (int i = 0; i < world->opening_count; i++)
        if (world->openings[i].face == face)
            return true;
    return false;
}

/* Finds the walls that the line meets on either side of the receivers. */
static void find_ends(const struct pp_section_cut *cut, double first, double last,
                      double ends[2], int faces[2])
{
    ends[0] = -INFINITY;
    ends[1] = INFINITY;
    faces[0] = faces[1] = -1;
    for (int i = 0; i < cut->count; i++) {
        const struct pp_cut *face = &cut->list[i];
        double a = face->z[0] - cut->height_m, b = face->z[1] - cut->height_m;
        if (face->kind != PP_CUT_FACE || (a > 0.0) == (b > 0.0))
            continue;
        double s = face->s[0] + a / (a - b) * (face->s[1] - face->s[0]);
        if (s <= first + OFF_LINE_M && s > ends[0]) {
            ends[0] = s;
            faces[0] = face->of;
        }
        if (s >= last - OFF_LINE_M && s < ends[1]) {
            ends[1] = s;
            faces[1] = face->of;
        }
    }
    ends[0] = fmin(isfinite(ends[0]) ? ends[0] : first, first);
    ends[1] = fmax(isfinite(ends[1]) ? ends[1] : last, last);
}

static void turn_round(struct pp_section_cut *cut)
{
    for (int k = 0; k < 2; k++)
        cut->along[k] = -cut->along[k];
    for (int i = 0; i < cut->count; i++)
        for (int k = 0; k < 2; k++)
            cut->list[i].s[k] = -cut->list[i].s[k];
}

enum pp_status pp_section_cut_init(struct pp_section_cut *cut,
                                   const struct pp_world *world,
                                   const struct pp_receiver *receivers, int count,
                                   struct pp_error *err)
{
    *cut = (struct pp_section_cut){0};
    enum pp_status status = find_line(cut, world, receivers, count, err);
    if (status != PP_OK)
        return status;
    if (!cut_world(cut, world)) {
        pp_section_cut_clear(cut);
        return pp_fail_memory(err);
    }

    double first = 0.0, last = 0.0;
    for (int i = 0; i < count; i++) {
        double s = pp_section_cut_s(cut, receivers[i].position);
        first = fmin(first, s);
        last = fmax(last, s);
    }
    double ends[2];
    int faces[2];
    find_ends(cut, first, last, ends, faces);
    bool windows[2] = {has_opening(world, faces[0]), has_opening(world, faces[1])};
    if (windows[1] && !windows[0]) {
        turn_round(cut);
        double end = ends[0];
        ends[0] = -ends[1];
        ends[1] = -end;
        int face = faces[0];
        faces[0] = faces[1];
        faces[1] = face;
        windows[0] = true;
        windows[1] = false;
    }
    for (int i = 0; i < cut->count; i++)
        for (int k = 0; k < 2; k++)
            cut->list[i].s[k] -= ends[0];
    for (int k = 0; k < 2; k++)
        cut->origin[k] += ends[0] * cut->along[k];
    cut->length_m = fmax(ends[1] - ends[0], 1e-3);
    cut->near_face = faces[0];
    cut->far_face = faces[1];
    cut->near_window = windows[0];
    cut->far_window = windows[1];
    if (!open_faces(cut, world)) {
        pp_section_cut_clear(cut);
        return pp_fail_memory(err);
    }
    return PP_OK;
}
