/* nested.c - see nested.h. */
#include "model/room/outside/nested.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/base/array.h"
#include "model/base/text.h"
#include "model/geometry/region_pieces.h"
#include "model/geometry/tolerance.h"
#include "model/room/build/free_surfaces.h"
#include "model/room/face_less_openings.h"
#include "model/room/outside/nested_gap.h"

/* Matched windows may differ in size and place by this much (m): drawings of different
 * scales agree to a centimetre. */
static const double same_window_m = 0.01;
/* Greatest angle between the normals of matched windows (rad): bearings are often typed
 * as whole degrees. */
static const double same_bearing_rad = 1.0 * PP_RAD;
/* Smaller pieces of faces are left out. */
static const double piece_least_m2 = 1e-9;

/* A coarse model that is being added to a room. */
struct nesting {
    struct pp_resolver *r;
    const struct pp_within_part *part;
    const struct pp_world *coarse;
    struct pp_placement place; /* converts from the axes of the coarse model */
    bool *matched;             /* by opening of the coarse model */
    int matches;
    bool before; /* the coarse model is the space in front of the windows */
};

static void say_misfit(const struct nesting *n, int line, const char *label,
                       const char *what)
{
    pp_mistakes_add(n->r->mistakes, line, "%s and its counterpart in \"%.200s\" %s",
                    label, n->part->path, what);
}

/* ---- windows ---- */

/* Index of the opening of the coarse model with that name; -1: none, -2: several. */
static int coarse_opening(const struct pp_world *coarse, const char *name)
{
    int found = -1;
    for (int i = 0; name && i < coarse->opening_count; i++)
        if (coarse->openings[i].name && strcmp(coarse->openings[i].name, name) == 0)
            found = found == -1 ? i : -2;
    return found;
}

/* Reports that the coarse model has no window of that name; NULL: none that has the
 * name of a window of the room. */
static void say_no_window(const struct nesting *n, const char *name)
{
    const struct pp_world *coarse = n->coarse;
    const char **names = calloc((size_t)coarse->opening_count + 1, sizeof *names);
    char known[512], typed[64], subject[128];
    int count = 0;
    for (int i = 0; names && i < coarse->opening_count; i++)
        if (coarse->openings[i].name)
            names[count++] = coarse->openings[i].name;
    if (name)
        snprintf(subject, sizeof subject, "there is no window \"%s\"",
                 pp_text_excerpt(typed, sizeof typed, name));
    else
        snprintf(subject, sizeof subject, "no window has the name of one of the room");
    pp_mistakes_add(n->r->mistakes, n->part->line,
                    "room: within \"%.200s\": %s; expected %s", n->part->path, subject,
                    count > 0 ? pp_text_list_names(known, sizeof known, names, count)
                              : "a window with a name");
    free(names);
}

/* Bearing (rad) of the outward normal of an opening, from true north. */
static double bearing_of(const struct pp_world *world, const struct pp_opening *opening)
{
    struct pp_vec3 n = opening->inner.normal;
    return world->north_rad + atan2(-n.x, -n.y);
}

/* False, with a report, if sizes or bearings do not agree. *before: the windows face
 * opposite directions. */
static bool windows_fit(const struct nesting *n, const struct pp_opening *own,
                        const struct pp_opening *other, bool *before)
{
    char what[256];
    double along = pp_vec_dot(
        own->inner.normal, pp_placement_turn(other->inner.normal, n->place.rotate_rad));
    *before = along < 0.0;
    if (fabs(own->width_m - other->width_m) > same_window_m
        || fabs(own->height_m - other->height_m) > same_window_m) {
        snprintf(what, sizeof what,
                 "are %.6g m x %.6g m and %.6g m x %.6g m; expected the same size",
                 own->width_m, own->height_m, other->width_m, other->height_m);
        say_misfit(n, own->line, own->label, what);
        return false;
    }
    if (fabs(along) >= cos(same_bearing_rad))
        return true;
    double own_deg = bearing_of(n->r->world, own) / PP_RAD,
           other_deg = bearing_of(n->coarse, other) / PP_RAD;
    snprintf(what, sizeof what,
             "face bearings of %.4g and %.4g degrees from north; expected the same or "
             "opposite bearings",
             own_deg - 360.0 * floor(own_deg / 360.0),
             other_deg - 360.0 * floor(other_deg / 360.0));
    say_misfit(n, own->line, own->label, what);
    return false;
}

/* Displacement (m) that makes the planes of glass of a matched pair coincide. In front
 * of a window the face of the coarse model is that plane. */
static struct pp_vec3 shift_of(const struct nesting *n, const struct pp_opening *own,
                               const struct pp_opening *other, bool before)
{
    struct pp_vec3 to = pp_polygon_middle(&own->outer),
                   from = pp_polygon_middle(before ? &other->inner : &other->outer);
    return pp_vec_sub(to, pp_placement_turn(from, n->place.rotate_rad));
}

/* Matches an opening of the room with one of the coarse model. */
static void match_opening(struct nesting *n, struct pp_opening *own, int other)
{
    const struct pp_opening *counterpart = &n->coarse->openings[other];
    bool before;
    if (!windows_fit(n, own, counterpart, &before))
        return;
    struct pp_vec3 shift = shift_of(n, own, counterpart, before),
                   place = pp_vec(n->place.x, n->place.y, n->place.z);
    double apart_m = pp_vec_length(pp_vec_sub(shift, place));
    if (n->matches == 0) {
        n->before = before;
        n->place.x = shift.x;
        n->place.y = shift.y;
        n->place.z = shift.z;
    } else if (before != n->before) {
        say_misfit(n, own->line, own->label,
                   "face each other, unlike an earlier pair, or the reverse; expected "
                   "all windows on the same side of the coarse model");
    } else if (apart_m > same_window_m) {
        char what[160];
        snprintf(what, sizeof what,
                 "are %.3g m apart when an earlier pair coincides; expected the same "
                 "distances between windows",
                 apart_m);
        say_misfit(n, own->line, own->label, what);
    }
    own->is_nested = true;
    own->counterpart = other;
    n->matched[other] = true;
    n->matches++;
}

/* Matches the windows; false, with a report, after a mistake. */
static bool match_openings(struct nesting *n)
{
    struct pp_world *world = n->r->world;
    const char *given = n->part->window;
    int mistakes = n->r->mistakes->count;
    if (given && world->opening_count != 1) {
        pp_mistakes_add(n->r->mistakes, n->part->line,
                        "room: window is given, but the room has %d windows; expected "
                        "one window, or windows with the names of their counterparts",
                        world->opening_count);
        return false;
    }
    for (int i = 0; i < world->opening_count; i++) {
        const char *name = given ? given : world->openings[i].name;
        int other = coarse_opening(n->coarse, name);
        if (other >= 0)
            match_opening(n, &world->openings[i], other);
        else if (other == -2)
            pp_mistakes_add(n->r->mistakes, n->part->line,
                            "room: within \"%.200s\": several windows are named "
                            "\"%.60s\"; expected one",
                            n->part->path, name);
    }
    if (n->r->mistakes->count == mistakes && n->matches == 0)
        say_no_window(n, given);
    return n->r->mistakes->count == mistakes;
}

/* ---- surfaces ---- */

/* Adds a polygon of a surface of the coarse model, given in the axes of that model. */
static enum pp_status add_coarse(const struct nesting *n,
                                 const struct pp_surface *surface,
                                 const struct pp_vec3 *corners, int count,
                                 struct pp_error *err)
{
    struct pp_world *world = n->r->world;
    struct pp_polygon placed;
    int before = world->surface_count;
    if (pp_polygon_of(&placed, corners, count, err) != PP_OK)
        return PP_SYSTEM;
    for (int i = 0; i < count; i++)
        placed.vertices[i] = pp_placement_to_building(&n->place, placed.vertices[i]);
    const struct pp_surface_part part = {
        .vertices = {.list = placed.vertices, .count = count},
        .reflectance = surface->front,
        .exitance = surface->exitance,
        .finish = surface->finish,
        .is_of_site = true,
        .line = n->part->line};
    enum pp_status status =
        pp_build_free_surfaces_add(n->r, &part, "surface of the coarse model", err);
    for (int i = before; i < world->surface_count; i++)
        world->surfaces[i].back = surface->back;
    pp_polygon_clear(&placed);
    return status;
}

/* Adds a region of a face of the coarse model, with the optical properties of
 * `surface`. */
static enum pp_status add_coarse_region(const struct nesting *n,
                                        const struct pp_surface *surface,
                                        const struct pp_region *region,
                                        const struct pp_face_axes *axes,
                                        struct pp_error *err)
{
    struct pp_region_pieces pieces = {0};
    enum pp_status status =
        pp_region_pieces_cut(&pieces, region, axes->origin, axes->a, axes->b,
                             piece_least_m2, n->r->clipper, err);
    for (int i = 0; i < pieces.count && status == PP_OK; i++)
        status =
            add_coarse(n, surface, pieces.list[i].corners, pieces.list[i].count, err);
    pp_region_pieces_clear(&pieces);
    return status;
}

/* Adds a face of the coarse model, less its openings. */
static enum pp_status add_coarse_face(const struct nesting *n, int face,
                                      struct pp_error *err)
{
    const struct pp_surface *surface = &n->coarse->surfaces[face];
    const struct pp_face_axes axes = pp_face_less_openings_axes(&surface->outline);
    struct pp_region rest;
    enum pp_status status = pp_face_less_openings(
        &rest, n->r->clipper, &axes, &surface->outline, n->coarse, face, err);
    if (status == PP_OK)
        status = add_coarse_region(n, surface, &rest, &axes, err);
    pp_region_clear(&rest);
    return status;
}

/* Adds the part of the gap of a facade that is beside the room. */
static enum pp_status close_gap(const struct nesting *n, const struct pp_facade *facade,
                                struct pp_error *err)
{
    const struct pp_face_axes axes =
        pp_face_less_openings_axes(&n->coarse->surfaces[facade->face].outline);
    const struct pp_surface look = {.front = facade->reflectance,
                                    .back = facade->reflectance};
    struct pp_region gap;
    enum pp_status status =
        pp_nested_gap_find(&gap, n->r, n->coarse, &n->place, facade, &axes, err);
    if (status == PP_OK)
        status = add_coarse_region(n, &look, &gap, &axes, err);
    pp_region_clear(&gap);
    return status;
}

static enum pp_status add_coarse_surfaces(const struct nesting *n, struct pp_error *err)
{
    const struct pp_world *coarse = n->coarse;
    enum pp_status status = PP_OK;
    for (int i = 0; i < coarse->surface_count && status == PP_OK; i++) {
        const struct pp_surface *surface = &coarse->surfaces[i];
        bool of_match = surface->role == PP_REVEAL && n->matched[surface->owner];
        if ((surface->inside && !n->before) || of_match)
            continue;
        status = i < coarse->face_count
                     ? add_coarse_face(n, i, err)
                     : add_coarse(n, surface, surface->outline.vertices,
                                  surface->outline.count, err);
    }
    for (int i = 0; i < coarse->facade_count && !n->before && status == PP_OK; i++)
        if (coarse->facades[i].depth_m < PP_SET_OFF_M)
            status = close_gap(n, &coarse->facades[i], err);
    return status;
}

/* True if the opening takes away no light. */
static bool is_bare(const struct pp_opening *opening)
{
    return opening->glass.panes == 0 && !opening->scatter
           && opening->device.kind == PP_DEVICE_NONE && opening->frame_factor == 1.0
           && opening->maintenance * opening->curtains == 1.0;
}

/* Adds the panes of the coarse model's other windows. */
static enum pp_status add_outer_panes(const struct nesting *n, struct pp_error *err)
{
    struct pp_world *world = n->r->world;
    world->outer_panes =
        calloc((size_t)n->coarse->opening_count + 1, sizeof *world->outer_panes);
    if (!world->outer_panes)
        return pp_fail_memory(err);
    for (int i = 0; i < n->coarse->opening_count && n->before; i++) {
        const struct pp_opening *opening = &n->coarse->openings[i];
        struct pp_outer_pane *pane = &world->outer_panes[world->outer_pane_count];
        if (n->matched[i] || is_bare(opening))
            continue;
        enum pp_status status = pp_polygon_of(&pane->outline, opening->outer.vertices,
                                              opening->outer.count, err);
        if (status != PP_OK)
            return status;
        world->outer_pane_count++;
        pane->tree = -1;
        for (int k = 0; k < pane->outline.count; k++)
            pane->outline.vertices[k] =
                pp_placement_to_building(&n->place, pane->outline.vertices[k]);
        pp_polygon_measure(&pane->outline);
        pane->up = pp_placement_turn(opening->up, n->place.rotate_rad);
        pane->opening = i;
    }
    return PP_OK;
}

/* Adds the trees of the coarse model; trees.c adds their crowns. */
static enum pp_status add_coarse_trees(const struct nesting *n, struct pp_error *err)
{
    struct pp_world *world = n->r->world;
    enum pp_status status = PP_OK;
    for (int i = 0; i < n->coarse->tree_count && status == PP_OK; i++) {
        struct pp_tree tree = n->coarse->trees[i];
        tree.foot = pp_placement_to_building(&n->place, tree.foot);
        tree.line = n->part->line;
        status = pp_array_append(&world->trees, world->tree_count, sizeof *world->trees,
                                 err);
        if (status == PP_OK)
            world->trees[world->tree_count++] = tree;
    }
    return status;
}

/* ---- outside ---- */

/* Adds skylines without a distance. They are parallel to walls of the coarse model. */
static enum pp_status add_far_skylines(const struct nesting *n, struct pp_error *err)
{
    struct pp_world *world = n->r->world;
    for (int i = 0; i < n->coarse->skyline_count; i++) {
        struct pp_skyline skyline = n->coarse->skylines[i];
        struct pp_vec3 normal = pp_placement_turn(
            n->coarse->surfaces[skyline.face].outline.normal, n->place.rotate_rad);
        if (isfinite(skyline.distance_m))
            continue;
        skyline.face = -1;
        for (int k = 0; k < world->surface_count && skyline.face < 0; k++)
            if (pp_vec_dot(world->surfaces[k].outline.normal, normal) > 1.0 - 1e-9)
                skyline.face = k;
        enum pp_status status =
            skyline.face < 0 ? PP_OK
                             : pp_array_append(&world->skylines, world->skyline_count,
                                               sizeof *world->skylines, err);
        if (status != PP_OK)
            return status;
        if (skyline.face >= 0)
            world->skylines[world->skyline_count++] = skyline;
    }
    return PP_OK;
}

/* Takes over the ground of the coarse model; reports an interior below it, which the
 * ground would fill. */
static void set_ground(const struct nesting *n)
{
    struct pp_world *world = n->r->world;
    double low = INFINITY;
    for (int i = 0; i < n->coarse->face_count; i++)
        for (int k = 0; k < n->coarse->surfaces[i].outline.count; k++)
            low = fmin(low, n->coarse->surfaces[i].outline.vertices[k].z);
    if (n->before && low < n->coarse->ground_level_m - PP_SAME_M)
        pp_mistakes_add(n->r->mistakes, n->part->line,
                        "room: within \"%.200s\": its floor is %.3g m below the ground "
                        "outside; expected a ground-level of at most %.6g",
                        n->part->path, n->coarse->ground_level_m - low, low);
    world->ground_level_m = n->coarse->ground_level_m + n->place.z;
    world->ground_is_open = n->coarse->ground_is_open;
}

/* Reports parts of the room's own outside that the coarse model replaces. */
static bool has_own_outside(struct pp_resolver *r)
{
    const struct pp_room *room = r->room;
    int line = room->skyline_count > 0  ? room->skylines[0].line
               : room->facade_count > 0 ? room->facades[0].line
                                        : 0;
    if (line == 0)
        return false;
    pp_mistakes_add(r->mistakes, line,
                    "%s: the room is nested within another model, which has the "
                    "outside; expected the %s there",
                    room->skyline_count > 0 ? "skyline" : "facade",
                    room->skyline_count > 0 ? "skyline" : "facade");
    return true;
}

enum pp_status pp_build_nested(struct pp_resolver *r, struct pp_error *err)
{
    const struct pp_within_part *part = &r->room->within;
    if (!part->world || !r->watertight || has_own_outside(r))
        return PP_OK;
    struct nesting n = {
        .r = r,
        .part = part,
        .coarse = part->world,
        .place = {.given = true,
                  .rotate_rad = r->world->north_rad - part->world->north_rad},
        .matched = calloc((size_t)part->world->opening_count + 1, sizeof *n.matched)};
    if (!n.matched)
        return pp_fail_memory(err);
    enum pp_status status = PP_OK;
    if (match_openings(&n)) {
        r->world->within_is_before = n.before;
        r->world->within_place = n.place;
        set_ground(&n);
        int own = r->world->surface_count;
        status = add_coarse_surfaces(&n, err);
        r->world->coarse_surface_count = r->world->surface_count - own;
        if (status == PP_OK)
            status = add_outer_panes(&n, err);
        if (status == PP_OK)
            status = add_coarse_trees(&n, err);
        if (status == PP_OK)
            status = add_far_skylines(&n, err);
    }
    free(n.matched);
    return status;
}
