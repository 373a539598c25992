/* opening_outline.c - see opening_outline.h. */
#include "model/room/build/opening_outline.h"

#include <stdio.h>
#include <string.h>

#include "model/base/text.h"
#include "model/geometry/tolerance.h"

const char *pp_opening_outline_word(const struct pp_opening_part *part)
{
    return part->kind == PP_WINDOW      ? "window"
           : part->kind == PP_ROOFLIGHT ? "rooflight"
                                        : "opening";
}

const char *pp_opening_outline_face_words(char *text, size_t size,
                                          const struct pp_surface *face)
{
    static const char *const roles[] = {"floor", "wall", "ceiling"};
    char name[64];
    if (face->name)
        snprintf(text, size, "%s \"%s\"", roles[face->role],
                 pp_text_excerpt(name, sizeof name, face->name));
    else
        snprintf(text, size, "the %s", roles[face->role]);
    return text;
}

/* Outline of the window in its wall. Reports a window that extends beyond the bounding
 * rectangle of its wall, and returns false. */
static bool window_outline(struct pp_resolver *r, const struct pp_opening_part *part,
                           const struct pp_face_frame *frame, double xy[4][2])
{
    char words[96];
    double wide = frame->bounds.high[0] - frame->bounds.low[0],
           tall = frame->bounds.high[1] - frame->bounds.low[1];
    pp_opening_outline_face_words(words, sizeof words, frame->face);
    double right = part->left_m + part->width_m - wide;
    double top = part->sill_m + part->height_m - tall;
    bool fits = true;
    if (part->left_m < -PP_ROUNDING_M) {
        pp_mistakes_add(r->mistakes, part->line,
                        "window: begins %.4g m to the left of %s, seen from outside; "
                        "expected left to be 0 or more",
                        -part->left_m, words);
        fits = false;
    }
    if (right > PP_ROUNDING_M) {
        pp_mistakes_add(r->mistakes, part->line,
                        "window: ends %.4g m to the right of %s, seen from outside; "
                        "expected left + width to be %g m at most",
                        right, words, wide);
        fits = false;
    }
    if (part->sill_m < -PP_ROUNDING_M) {
        pp_mistakes_add(
            r->mistakes, part->line,
            "window: begins %.4g m below the foot of %s; expected sill to be 0 or more",
            -part->sill_m, words);
        fits = false;
    }
    if (top > PP_ROUNDING_M) {
        pp_mistakes_add(
            r->mistakes, part->line,
            "window: ends %.4g m above the top of %s; expected sill + height to "
            "be %g m at most",
            top, words, tall);
        fits = false;
    }
    /* `left` is measured as seen from outside, from the high end of `along`. */
    double x_high = fmin(frame->bounds.high[0], frame->bounds.high[0] - part->left_m);
    double x_low = fmax(frame->bounds.low[0],
                        frame->bounds.high[0] - part->left_m - part->width_m);
    double y_low = fmax(frame->bounds.low[1], frame->bounds.low[1] + part->sill_m);
    double y_high = fmin(frame->bounds.high[1],
                         frame->bounds.low[1] + (part->sill_m + part->height_m));
    if (fabs(right) <= PP_ROUNDING_M)
        x_low = frame->bounds.low[0];
    if (fabs(part->left_m) <= PP_ROUNDING_M)
        x_high = frame->bounds.high[0];
    if (fabs(part->sill_m) <= PP_ROUNDING_M)
        y_low = frame->bounds.low[1];
    if (fabs(top) <= PP_ROUNDING_M)
        y_high = frame->bounds.high[1];
    double ring[4][2] = {
        {x_low, y_low}, {x_high, y_low}, {x_high, y_high}, {x_low, y_high}};
    memcpy(xy, ring, sizeof ring);
    return fits;
}

/* Outline of the rooflight, counter-clockwise seen from below. The room's x is the
 * frame's `along`; its y is opposite to `up`. */
static void rooflight_outline(const struct pp_opening_part *part,
                              const struct pp_face_frame *frame, double xy[4][2])
{
    double z = frame->origin.z;
    struct pp_vec3 corners[4] = {{part->x, part->y + part->depth_m, z},
                                 {part->x + part->width_m, part->y + part->depth_m, z},
                                 {part->x + part->width_m, part->y, z},
                                 {part->x, part->y, z}};
    pp_polygon_flatten(corners, 4, frame->origin, frame->along, frame->up, xy);
}

bool pp_opening_outline(struct pp_resolver *r, const struct pp_opening_part *part,
                        const struct pp_face_frame *frame, double (*xy)[2])
{
    if (part->kind == PP_WINDOW)
        return window_outline(r, part, frame, xy);
    if (part->kind == PP_ROOFLIGHT)
        rooflight_outline(part, frame, xy);
    else
        pp_polygon_flatten(part->vertices.list, part->vertices.count, frame->origin,
                           frame->along, frame->up, xy);
    return true;
}

static bool is_level_ceiling(const struct pp_surface *face)
{
    return face->role == PP_CEILING && face->outline.normal.z < 0.0
           && hypot(face->outline.normal.x, face->outline.normal.y) < PP_LEVEL_RAD;
}

/* Horizontal ceiling over the rooflight's centre, or the nearest one; -1 if the room
 * has none. */
static int ceiling_of(const struct pp_world *world, const struct pp_opening_part *part)
{
    int nearest = -1;
    double least = INFINITY;
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_surface *face = &world->surfaces[i];
        if (!is_level_ceiling(face))
            continue;
        double distance =
            pp_polygon_distance(&face->outline, pp_vec(part->x + 0.5 * part->width_m,
                                                       part->y + 0.5 * part->depth_m,
                                                       face->outline.vertices[0].z));
        /* If one ceiling is above the other, the upper one is used. */
        bool above = nearest >= 0
                     && face->outline.vertices[0].z
                            > world->surfaces[nearest].outline.vertices[0].z;
        if (distance < least || (distance == least && above)) {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

/* Face in whose plane all vertices lie; -1 if there is none. If there are several, the
 * face nearest to the centre of the vertices. *nearest: face from which the farthest
 * vertex has the smallest distance; *off_m: that distance. */
static int face_of_outline(const struct pp_world *world,
                           const struct pp_vertices *vertices, int *nearest,
                           double *off_m)
{
    int found = -1;
    double least_to_middle = INFINITY;
    struct pp_vec3 middle = {0.0, 0.0, 0.0};
    for (int k = 0; k < vertices->count; k++)
        middle = pp_vec_along(middle, 1.0 / vertices->count, vertices->list[k]);
    *nearest = -1;
    *off_m = INFINITY;
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_polygon *outline = &world->surfaces[i].outline;
        double off_plane = 0.0, off_face = 0.0;
        for (int k = 0; k < vertices->count; k++) {
            struct pp_vec3 v = vertices->list[k];
            off_plane = fmax(off_plane, fabs(pp_polygon_height(outline, v)));
            off_face = fmax(off_face, pp_polygon_distance(outline, v));
        }
        double to_middle = pp_polygon_distance(outline, middle);
        if (off_plane <= PP_SAME_M && to_middle < least_to_middle) {
            least_to_middle = to_middle;
            found = i;
        }
        if (off_face < *off_m) {
            *off_m = off_face;
            *nearest = i;
        }
    }
    return found;
}

int pp_opening_outline_face(struct pp_resolver *r, const struct pp_opening_part *part)
{
    const struct pp_world *world = r->world;
    if (part->kind == PP_WINDOW)
        return pp_resolve_window_face(r, part->wall, part->line);
    if (world->face_count == 0 || r->faces_missing)
        return -1;
    if (part->kind == PP_ROOFLIGHT) {
        int ceiling = ceiling_of(world, part);
        if (ceiling < 0)
            pp_mistakes_add(
                r->mistakes, part->line,
                "rooflight: the room has no flat ceiling; expected an <opening> "
                "in one of its faces");
        return ceiling;
    }
    int nearest;
    double off_m;
    int face = face_of_outline(world, &part->vertices, &nearest, &off_m);
    if (face < 0) {
        char words[96];
        pp_opening_outline_face_words(words, sizeof words, &world->surfaces[nearest]);
        pp_mistakes_add(
            r->mistakes, part->line,
            "opening: is not in a face of the room; the nearest face, %s, is %.4g m "
            "from a vertex; expected all vertices within 1 mm of its plane",
            words, off_m);
    } else if (pp_vec_dot(
                   pp_polygon_area_vector(part->vertices.list, part->vertices.count),
                   world->surfaces[face].outline.normal)
               < 0.0) {
        pp_mistakes_add(
            r->mistakes, part->line,
            "opening: its vertices are clockwise seen from inside; expected "
            "counter-clockwise");
        face = -1;
    }
    return face;
}
