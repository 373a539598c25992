/* gather_cells.c - divides the faces of a convex room into cells, and sums over them
 * with vector instructions. */
#include "simulate/fast/gather_cells.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "model/geometry/min_max.h"
#include "simulate/sampling/lanes.h"
#include "simulate/scene/light_scene_parts.h"

/* c in (1) of gather_cells.h, and approximate number of patches of G along each side of
 * a cell. Both chosen by trial. */
static const double RAYS_WEIGHED = 32.0;
enum { PATCHES_ALONG = 2 };

/* Cells fill a face exactly if their area is at most this many times that of the face;
 * allows for rounding. */
static const double FILLED = 1.0 + 1e-9;

/* Arrays of the cell points (a net): coordinates, and G less its lower bound. Each
 * array has one number per lane. */
enum { X, Y, Z, GUESS, ARRAYS };

struct cell_face {
    int first, columns, rows; /* first: index in a net. The last lanes of a face may be
                               * empty */
    double a0, b0; /* the lower corner of the first cell, along the part's a and b */
    double width_m, height_m; /* size of a cell */
    bool plain;               /* true if cells fill the face and it has no opening */
};

struct pp_gather_cells {
    const struct pp_light_scene *scene;       /* not owned */
    const struct pp_control_variate *variate; /* not owned */
    struct cell_face *faces;
    int lanes;    /* lanes of all faces */
    double level; /* lower bound of G */
};

static int cells_along(int patches)
{
    return (patches + PATCHES_ALONG - 1) / PATCHES_ALONG;
}

static bool has_opening(const struct pp_world *world, int face)
{
    for (int i = 0; i < world->opening_count; i++)
        if (world->openings[i].face == face)
            return true;
    return false;
}

static void lay_out_cells(struct pp_gather_cells *cells)
{
    const struct pp_world *world = cells->scene->world;
    for (int i = 0; i < world->face_count; i++) {
        const struct pp_control_variate_grid *grid = &cells->variate->grids[i][0];
        struct cell_face *face = &cells->faces[i];
        double width = grid->columns / grid->per_a, height = grid->rows / grid->per_b;
        *face = (struct cell_face){.first = cells->lanes,
                                   .columns = cells_along(grid->columns),
                                   .rows = cells_along(grid->rows),
                                   .a0 = grid->a0 - 0.5 / grid->per_a,
                                   .b0 = grid->b0 - 0.5 / grid->per_b};
        face->width_m = width / face->columns;
        face->height_m = height / face->rows;
        face->plain = width * height < FILLED * world->surfaces[i].outline.area_m2
                      && !has_opening(world, i);
        int count = face->columns * face->rows;
        cells->lanes += (count + PP_LANES - 1) / PP_LANES * PP_LANES;
    }
}

static double least_guess(const struct pp_gather_cells *cells)
{
    double least = INFINITY;
    for (int i = 0; i < cells->scene->world->face_count; i++) {
        const struct pp_control_variate_grid *grid = &cells->variate->grids[i][0];
        for (int k = 0; k < grid->columns * grid->rows; k++)
            least = pp_min(least, cells->variate->values[grid->first + k]);
    }
    return least;
}

enum pp_status pp_gather_cells_create(struct pp_gather_cells **result,
                                      const struct pp_light_scene *scene,
                                      const struct pp_control_variate *variate,
                                      struct pp_error *err)
{
    *result = NULL;
    struct pp_gather_cells *cells = calloc(1, sizeof *cells);
    if (!cells)
        return pp_fail_memory(err);
    cells->scene = scene;
    cells->variate = variate;
    cells->faces = calloc((size_t)scene->world->face_count, sizeof *cells->faces);
    if (!cells->faces) {
        pp_gather_cells_destroy(cells);
        return pp_fail_memory(err);
    }
    lay_out_cells(cells);
    cells->level = least_guess(cells);
    *result = cells;
    return PP_OK;
}

void pp_gather_cells_destroy(struct pp_gather_cells *cells)
{
    if (!cells)
        return;
    free(cells->faces);
    free(cells);
}

size_t pp_gather_cells_size(const struct pp_gather_cells *cells)
{
    return (size_t)ARRAYS * (size_t)cells->lanes;
}

/* True if this point of the face's plane is on the face and in no opening. */
static bool is_seen(const struct pp_gather_cells *cells,
                    struct pp_radiance_state *light, int face, struct pp_vec3 point)
{
    const struct pp_light_ray sight = pp_convex_room_sight(cells->scene->convex, point);
    struct pp_light_hit met;
    return pp_radiance_state_meet(light, &sight, &met) == PP_MEETS_PART
           && met.part == face;
}

bool pp_gather_cells_are_on(const struct pp_gather_cells *cells, int part)
{
    return part < cells->scene->world->face_count;
}

static void draw_face(const struct pp_gather_cells *cells,
                      struct pp_radiance_state *light, int number, const double u[2],
                      double *net)
{
    const struct cell_face *face = &cells->faces[number];
    const struct pp_light_part *part = &cells->scene->parts[number];
    for (int i = 0; i < face->columns * face->rows; i++) {
        int column = i % face->columns, row = i / face->columns;
        bool mirrored = (column + row) % 2 == 1;
        double s = mirrored ? 1.0 - u[0] : u[0], t = mirrored ? 1.0 - u[1] : u[1];
        double a = face->a0 + (column + s) * face->width_m;
        double b = face->b0 + (row + t) * face->height_m;
        struct pp_light_hit hit = {.point = pp_light_scene_parts_point(part, a, b),
                                   .part = number};
        double *at = &net[face->first + i];
        at[X * cells->lanes] = hit.point.x;
        at[Y * cells->lanes] = hit.point.y;
        at[Z * cells->lanes] = hit.point.z;
        if (face->plain || is_seen(cells, light, number, hit.point))
            at[GUESS * cells->lanes] =
                pp_control_variate_at(cells->variate, cells->scene, &hit)
                - cells->level;
    }
}

void pp_gather_cells_draw(const struct pp_gather_cells *cells,
                          struct pp_radiance_state *light, const double u[2],
                          double *net)
{
    memset(net, 0, pp_gather_cells_size(cells) * sizeof *net);
    for (int i = 0; i < cells->scene->world->face_count; i++)
        draw_face(cells, light, i, u, net);
}

/* k A r^4 / (n . (y - x)) of (1) in gather_cells.h, for a receiver at this distance (m)
 * from the face's plane. */
static double per_cosine(const struct cell_face *face, double before_m)
{
    return face->width_m * face->height_m * before_m / PP_PI;
}

PP_LANES_BODY double taken(const struct pp_gather_cells *cells, const double *net,
                           struct pp_vec3 point, struct pp_vec3 normal)
{
    pp_lanes sum = PP_LANES_ALL(0.0);
    for (int i = 0; i < cells->scene->world->face_count; i++) {
        const struct cell_face *face = &cells->faces[i];
        const struct pp_light_part *part = &cells->scene->parts[i];
        double before_m = pp_vec_dot(part->normal, point) - part->offset_m;
        if (!(before_m > 0.0))
            continue;
        double scale = per_cosine(face, before_m);
        int end = face->first + face->columns * face->rows;
        for (int at = face->first; at < end; at += PP_LANES) {
            pp_lanes x, y, z, guess;
            memcpy(&x, &net[X * cells->lanes + at], sizeof x);
            memcpy(&y, &net[Y * cells->lanes + at], sizeof y);
            memcpy(&z, &net[Z * cells->lanes + at], sizeof z);
            memcpy(&guess, &net[GUESS * cells->lanes + at], sizeof guess);
            x -= point.x;
            y -= point.y;
            z -= point.z;
            pp_lanes square = x * x + y * y + z * z;
            pp_lanes q = scale * (normal.x * x + normal.y * y + normal.z * z);
            pp_lanes term = guess * q / (square * square + RAYS_WEIGHED * q);
            sum += PP_LANES_CHOOSE(q > 0.0, term, PP_LANES_ALL(0.0));
        }
    }
    return sum[0] + sum[1] + (sum[2] + sum[3]);
}

static double taken_plain(const struct pp_gather_cells *cells, const double *net,
                          struct pp_vec3 point, struct pp_vec3 normal)
{
    return taken(cells, net, point, normal);
}

PP_LANES_WIDE static double taken_wide(const struct pp_gather_cells *cells,
                                       const double *net, struct pp_vec3 point,
                                       struct pp_vec3 normal)
{
    return taken(cells, net, point, normal);
}

double pp_gather_cells_taken(const struct pp_gather_cells *cells, const double *net,
                             struct pp_vec3 point, struct pp_vec3 normal)
{
    return (pp_lanes_are_wide() ? taken_wide : taken_plain)(cells, net, point, normal);
}

double pp_gather_cells_left(const struct pp_gather_cells *cells,
                            const struct pp_light_ray *ray,
                            const struct pp_light_hit *met, double guess)
{
    if (!pp_gather_cells_are_on(cells, met->part))
        return guess;
    const struct pp_light_part *part = &cells->scene->parts[met->part];
    struct pp_vec3 to = pp_vec_sub(met->point, ray->from);
    double before_m = pp_vec_dot(part->normal, ray->from) - part->offset_m;
    double q =
        per_cosine(&cells->faces[met->part], before_m) * pp_vec_dot(ray->off, to);
    if (!(q > 0.0))
        return guess;
    double square = pp_vec_dot(to, to), fourth = square * square;
    double by_cells = fourth / (fourth + RAYS_WEIGHED * q);
    return guess - (guess - cells->level) * by_cells;
}
