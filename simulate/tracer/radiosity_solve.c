/* radiosity_solve.c - patches laid out, lit by the openings along sampled directions,
 * and the exchange between them iterated. */
#include "simulate/tracer/radiosity_solve.h"

#include <math.h>
#include <stdlib.h>

#include "model/geometry/bounds.h"
#include "model/results/reading.h"
#include "simulate/sampling/hash.h"
#include "simulate/sampling/lobe.h"
#include "simulate/tracer/path_openings.h"

enum {
    /* Chosen by trial: */
    PATCHES = 1200,       /* about this many in a room */
    MOST_SURFACES = 2000, /* of a room that gets a solution */
    OPENING_SAMPLES = 16, /* of each patch */
    LOBE_SAMPLES = 32,    /* of each patch */
    MOST_SWEEPS = 40,     /* Gauss-Seidel iterations */
    MOST_ALONG = 64,      /* patches along one edge */
};

/* A patch while the exchange is worked out. */
struct radiosity_patch {
    struct pp_vec3 point;
    int facet;
    enum pp_facet_side side;
    bool in_figure;         /* is the centre in the facet's outline? */
    double own;             /* exitance without exchange: M + rho E */
    int seen[LOBE_SAMPLES]; /* patches that its rays meet; -1: none */
};

static bool in_polygon(const struct pp_polygon *polygon, const struct pp_facet *facet,
                       struct pp_vec3 centre, double a, double b)
{
    bool odd = false;
    for (int i = 0; i < polygon->count; i++) {
        struct pp_vec3 p = pp_vec_sub(polygon->vertices[i], centre);
        struct pp_vec3 q =
            pp_vec_sub(polygon->vertices[(i + 1) % polygon->count], centre);
        double pa = pp_vec_dot(p, facet->a), pb = pp_vec_dot(p, facet->b);
        double qa = pp_vec_dot(q, facet->a), qb = pp_vec_dot(q, facet->b);
        if ((pb > b) != (qb > b) && a < pa + (b - pb) / (qb - pb) * (qa - pa))
            odd = !odd;
    }
    return odd;
}

/* The rectangle round the outline along the facet's a and b. */
static struct pp_bounds2 bounds_of(const struct pp_polygon *polygon,
                                   const struct pp_facet *facet, struct pp_vec3 centre)
{
    struct pp_bounds2 bounds = pp_bounds2_empty();
    for (int i = 0; i < polygon->count; i++) {
        struct pp_vec3 v = pp_vec_sub(polygon->vertices[i], centre);
        pp_bounds2_add(&bounds, pp_vec_dot(v, facet->a), pp_vec_dot(v, facet->b));
    }
    return bounds;
}

static int patches_along(double length, double patch)
{
    double count = ceil(length / patch);
    return count < 1.0 ? 1 : count > MOST_ALONG ? MOST_ALONG : (int)count;
}

static bool has_side(const struct pp_facet *facet, const struct pp_surface *surface,
                     enum pp_facet_side side)
{
    return surface->inside && (side == PP_FRONT || !facet->envelope);
}

/* Grids for all sides that the room sees; returns how many patches they have. */
static int lay_out(struct pp_radiosity *radiosity, const struct pp_ray_scene *scene,
                   const struct pp_world *world)
{
    double area = 0.0;
    for (int i = 0; i < world->surface_count; i++)
        if (world->surfaces[i].inside)
            area += world->surfaces[i].outline.area_m2;
    double size = sqrt(area / PATCHES);
    int count = 0;
    for (int i = 0; i < scene->facet_count; i++)
        for (int side = 0; side < 2; side++) {
            struct pp_radiosity_grid *grid = &radiosity->grids[i][side];
            const struct pp_facet *facet = &scene->facets[i];
            grid->first = -1;
            if (facet->opening >= 0 || !has_side(facet, &world->surfaces[i], side))
                continue;
            struct pp_bounds2 box =
                bounds_of(&world->surfaces[i].outline, facet, scene->centre);
            double width = box.high[0] - box.low[0], height = box.high[1] - box.low[1];
            grid->columns = patches_along(width, size);
            grid->rows = patches_along(height, size);
            grid->per_a = grid->columns / width;
            grid->per_b = grid->rows / height;
            grid->a0 = box.low[0] + 0.5 / grid->per_a;
            grid->b0 = box.low[1] + 0.5 / grid->per_b;
            grid->first = count;
            count += grid->columns * grid->rows;
        }
    return count;
}

static void place_patches(struct radiosity_patch *patches,
                          const struct pp_radiosity *radiosity,
                          const struct pp_ray_scene *scene,
                          const struct pp_world *world)
{
    for (int i = 0; i < world->surface_count; i++)
        for (int side = 0; side < 2; side++) {
            const struct pp_radiosity_grid *grid = &radiosity->grids[i][side];
            const struct pp_facet *facet = &scene->facets[i];
            for (int k = 0; grid->first >= 0 && k < grid->columns * grid->rows; k++) {
                double a = grid->a0 + k % grid->columns / grid->per_a;
                double b = grid->b0 + k / grid->columns / grid->per_b;
                struct radiosity_patch *patch = &patches[grid->first + k];
                patch->facet = i;
                patch->side = side;
                patch->in_figure =
                    in_polygon(&world->surfaces[i].outline, facet, scene->centre, a, b);
                patch->point = pp_vec_along(
                    pp_vec_along(pp_vec_scale(facet->normal, facet->offset_m), a,
                                 facet->a),
                    b, facet->b);
            }
        }
}

/* The irradiance of the patch by the openings, and the patches that its rays meet. */
static void light_patch(struct radiosity_patch *patch,
                        const struct pp_radiosity *radiosity,
                        const struct pp_ray_scene *scene, const struct pp_sobol *sobol,
                        uint64_t seed)
{
    struct pp_path_state state = {.scene = scene};
    pp_sobol_sequence_init(&state.sequence, sobol, seed);
    const struct pp_facet *facet = &scene->facets[patch->facet];
    struct pp_vec3 n =
        patch->side == PP_FRONT ? facet->normal : pp_vec_scale(facet->normal, -1.0);
    struct pp_light light = {{0.0, 0.0, 0.0}};
    for (uint32_t i = 0; i < OPENING_SAMPLES; i++) {
        double u[3];
        state.index = i;
        pp_sobol_sequence_draw(&state.sequence, i, 0, 3, u);
        pp_path_openings(&state, patch->point, n, u, 0, 1.0 / OPENING_SAMPLES, PP_IRC,
                         &light);
    }
    patch->own = facet->exitance + facet->reflectance[patch->side] * light.part[PP_IRC];
    for (uint32_t i = 0; i < LOBE_SAMPLES; i++) {
        double u[2];
        pp_sobol_sequence_draw(&state.sequence, i, 1, 2, u);
        struct pp_vec3 to = pp_lobe_sample_in_frame(facet->a, facet->b, n, u[0], u[1]);
        struct pp_contact met = pp_path_ray_first(&state, patch->point, n, to);
        patch->seen[i] = pp_radiosity_nearest(radiosity, scene, &met);
    }
}

/* Gauss-Seidel iteration: each patch gathers from those that its rays meet, in turn,
 * until the solution changes by less than 1e-4. */
static void exchange(double *values, const struct radiosity_patch *patches, int count,
                     const struct pp_ray_scene *scene)
{
    for (int i = 0; i < count; i++)
        values[i] = patches[i].own;
    double change = 1.0, total = 0.0;
    for (int sweep = 0; sweep < MOST_SWEEPS && change > 1e-4 * total; sweep++) {
        change = total = 0.0;
        for (int i = 0; i < count; i++) {
            double sum = 0.0;
            for (int k = 0; k < LOBE_SAMPLES; k++)
                if (patches[i].seen[k] >= 0)
                    sum += values[patches[i].seen[k]];
            double reflectance =
                scene->facets[patches[i].facet].reflectance[patches[i].side];
            double value = patches[i].own + reflectance * sum / LOBE_SAMPLES;
            change += fabs(value - values[i]);
            total += value;
            values[i] = value;
        }
    }
}

/* Patches beside the figure (outside the corner of an L) get the mean of those in it,
 * for the interpolation. */
static void fill_beside(struct pp_radiosity *radiosity,
                        const struct radiosity_patch *patches,
                        const struct pp_radiosity_grid *grid)
{
    int count = grid->columns * grid->rows, in_figure = 0;
    double sum = 0.0;
    for (int i = grid->first; i < grid->first + count; i++)
        if (patches[i].in_figure) {
            sum += radiosity->values[i];
            in_figure++;
        }
    for (int i = grid->first; i < grid->first + count; i++)
        if (!patches[i].in_figure)
            radiosity->values[i] = in_figure > 0 ? sum / in_figure : 0.0;
}

static void work_out(struct pp_radiosity *radiosity, struct radiosity_patch *patches,
                     const struct pp_ray_scene *scene, const struct pp_world *world,
                     const struct pp_sobol *sobol, uint64_t seed, int threads)
{
    int count = radiosity->count;
    (void)threads;
    place_patches(patches, radiosity, scene, world);
#pragma omp parallel for num_threads(threads) schedule(dynamic, 16)
    for (int i = 0; i < count; i++)
        if (patches[i].in_figure)
            light_patch(&patches[i], radiosity, scene, sobol,
                        pp_hash(seed, (uint64_t)i));
        else
            for (int k = 0; k < LOBE_SAMPLES; k++)
                patches[i].seen[k] = -1;
    exchange(radiosity->values, patches, count, scene);
    for (int i = 0; i < world->surface_count; i++)
        for (int side = 0; side < 2; side++)
            if (radiosity->grids[i][side].first >= 0)
                fill_beside(radiosity, patches, &radiosity->grids[i][side]);
}

enum pp_status pp_radiosity_solve(struct pp_radiosity **result,
                                  const struct pp_ray_scene *scene,
                                  const struct pp_world *world,
                                  const struct pp_sobol *sobol, uint64_t seed,
                                  int threads, struct pp_error *err)
{
    *result = NULL;
    int surfaces = 0;
    for (int i = 0; i < world->surface_count; i++)
        surfaces += world->surfaces[i].inside;
    if (surfaces == 0 || surfaces > MOST_SURFACES)
        return PP_OK;

    struct pp_radiosity *radiosity = calloc(1, sizeof *radiosity);
    if (!radiosity)
        return pp_fail_memory(err);
    radiosity->grids = calloc((size_t)scene->facet_count, sizeof *radiosity->grids);
    struct radiosity_patch *patches = NULL;
    if (radiosity->grids) {
        radiosity->count = lay_out(radiosity, scene, world);
        radiosity->values = calloc((size_t)radiosity->count, sizeof *radiosity->values);
        patches = calloc((size_t)radiosity->count, sizeof *patches);
    }
    if (!radiosity->grids || !radiosity->values || !patches) {
        free(patches);
        pp_radiosity_destroy(radiosity);
        return pp_fail_memory(err);
    }
    work_out(radiosity, patches, scene, world, sobol, seed, threads);
    free(patches);
    *result = radiosity;
    return PP_OK;
}
