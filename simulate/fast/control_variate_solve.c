/* control_variate_solve.c - lays out patches, samples their light from the openings,
 * and iterates the exchange of light between them. */
#include "simulate/fast/control_variate_solve.h"

#include <math.h>
#include <stdlib.h>

#include "model/base/thread_pool.h"
#include "model/geometry/bounds.h"
#include "simulate/sampling/hash.h"
#include "simulate/sampling/lobe.h"
#include "simulate/scene/light_scene_parts.h"
#include "simulate/fast/path.h"

enum {
    /* Chosen by trial: */
    PATCHES = 1200,       /* about this many in a room */
    MOST_SURFACES = 2000, /* a room with more gets no solution */
    OPENING_SAMPLES = 8,  /* for each patch */
    LOBE_SAMPLES = 16,    /* for each patch */
    MOST_SWEEPS = 40,     /* Gauss-Seidel iterations */
    MOST_ALONG = 64,      /* patches along one edge */
};

/* A patch during the solution. */
struct variate_patch {
    struct pp_vec3 point;
    int part;
    bool back;
    bool in_figure;                /* the centre is in the surface's outline */
    double own;                    /* exitance by emission and direct light: M + rho
                                    * E */
    double exchanged;              /* interreflected part of the exitance, before
                                    * smoothing */
    int seen[LOBE_SAMPLES];        /* patches that its rays meet (indices); -1: none */
    int sides[OPENING_SAMPLES];    /* patches of niche sides that directions to openings
                                    * meet, */
    double worth[OPENING_SAMPLES]; /* and the fraction of their exitance that reaches
                                    * the patch */
    int side_count;
};

static bool in_polygon(const struct pp_polygon *polygon,
                       const struct pp_light_part *part, struct pp_vec3 centre,
                       double a, double b)
{
    bool odd = false;
    for (int i = 0; i < polygon->count; i++) {
        struct pp_vec3 p = pp_vec_sub(polygon->vertices[i], centre);
        struct pp_vec3 q =
            pp_vec_sub(polygon->vertices[(i + 1) % polygon->count], centre);
        double pa = pp_vec_dot(p, part->a), pb = pp_vec_dot(p, part->b);
        double qa = pp_vec_dot(q, part->a), qb = pp_vec_dot(q, part->b);
        if ((pb > b) != (qb > b) && a < pa + (b - pb) / (qb - pb) * (qa - pa))
            odd = !odd;
    }
    return odd;
}

/* Bounding rectangle of the outline along the part's axes a and b. */
static struct pp_bounds2 part_bounds(const struct pp_polygon *polygon,
                                     const struct pp_light_part *part,
                                     struct pp_vec3 centre)
{
    struct pp_bounds2 bounds = pp_bounds2_empty();
    for (int i = 0; i < polygon->count; i++) {
        struct pp_vec3 v = pp_vec_sub(polygon->vertices[i], centre);
        pp_bounds2_add(&bounds, pp_vec_dot(v, part->a), pp_vec_dot(v, part->b));
    }
    return bounds;
}

static int patches_along(double length, double patch)
{
    double count = ceil(length / patch);
    return count < 1.0 ? 1 : count > MOST_ALONG ? MOST_ALONG : (int)count;
}

static bool has_side(const struct pp_light_part *part, const struct pp_surface *surface,
                     int side)
{
    return surface->inside && (side == 0 || !part->envelope);
}

/* Lays out grids on all sides that face the room; returns the number of patches. */
static int lay_out_patches(struct pp_control_variate *variate,
                           const struct pp_light_scene *scene,
                           const struct pp_world *world)
{
    double area = 0.0;
    for (int i = 0; i < world->surface_count; i++)
        if (world->surfaces[i].inside)
            area += world->surfaces[i].outline.area_m2;
    double size = sqrt(area / PATCHES);
    int count = 0;
    for (int i = 0; i < scene->part_count; i++)
        for (int side = 0; side < 2; side++) {
            struct pp_control_variate_grid *grid = &variate->grids[i][side];
            const struct pp_light_part *part = &scene->parts[i];
            grid->first = -1;
            if (i >= world->surface_count
                || !has_side(part, &world->surfaces[i], side)) /* panes come last */
                continue;
            struct pp_bounds2 box =
                part_bounds(&world->surfaces[i].outline, part, scene->centre);
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

static void place_patches(struct variate_patch *patches,
                          const struct pp_control_variate *variate,
                          const struct pp_light_scene *scene,
                          const struct pp_world *world)
{
    for (int i = 0; i < world->surface_count; i++)
        for (int side = 0; side < 2; side++) {
            const struct pp_control_variate_grid *grid = &variate->grids[i][side];
            const struct pp_light_part *part = &scene->parts[i];
            for (int k = 0; grid->first >= 0 && k < grid->columns * grid->rows; k++) {
                double a = grid->a0 + k % grid->columns / grid->per_a;
                double b = grid->b0 + k / grid->columns / grid->per_b;
                struct variate_patch *patch = &patches[grid->first + k];
                patch->part = i;
                patch->back = side == 1;
                patch->in_figure =
                    in_polygon(&world->surfaces[i].outline, part, scene->centre, a, b);
                patch->point = pp_light_scene_parts_point(part, a, b);
            }
        }
}

static const struct pp_material *patch_material(const struct pp_light_scene *scene,
                                                const struct variate_patch *patch)
{
    return &scene->materials[scene->parts[patch->part].material[patch->back]];
}

/* Context of the callback below: the patch that receives light, and the control variate,
 * which finds the patch nearest to a point on a niche side. */
struct noting {
    struct variate_patch *patch;
    const struct pp_control_variate *variate;
};

/* Callback: records a niche side that the patch sees. Returns 0, since the light of
 * sides is added later, by the exchange. */
static double note_side(void *of, const struct pp_light_hit *side, double worth)
{
    const struct noting *noting = of;
    struct variate_patch *patch = noting->patch;
    patch->sides[patch->side_count] =
        pp_control_variate_nearest(noting->variate, noting->variate->scene, side);
    patch->worth[patch->side_count++] = worth;
    return 0.0;
}

/* Computes the patch's own exitance, by emission and by light from the openings, and
 * finds the patches that its rays meet. */
static void light_patch(struct variate_patch *patch,
                        const struct pp_control_variate *variate,
                        const struct pp_light_scene *scene,
                        const struct pp_environment *environment,
                        const struct pp_sobol *sobol, uint64_t seed)
{
    struct pp_path_state state = pp_path_state(scene, environment, NULL);
    struct noting noting = {patch, variate};
    const struct pp_niche_light niches = {note_side, &noting};
    if (scene->convex && scene->has_niches)
        state.niches = &niches;
    pp_sobol_sequence_init(&state.light.sequence, sobol, seed);
    const struct pp_light_part *part = &scene->parts[patch->part];
    const struct pp_material *material = patch_material(scene, patch);
    struct pp_vec3 n = patch->back ? pp_vec_scale(part->normal, -1.0) : part->normal;
    struct pp_irradiance e =
        pp_path_by_openings(&state, patch->point, n, 0, OPENING_SAMPLES);
    patch->own =
        PP_PI * material->radiance.g + material->diffuse.g * pp_irradiance_sum(&e).g;
    for (uint32_t i = 0; i < LOBE_SAMPLES; i++) {
        double u[2];
        struct pp_light_hit met;
        pp_sobol_sequence_draw(&state.light.sequence, i, 1, 2, u);
        const struct pp_light_ray ray = {
            patch->point, n, pp_lobe_sample_in_frame(part->a, part->b, n, u[0], u[1]),
            PP_INDOORS};
        enum pp_meeting meeting = pp_radiance_state_meet(&state.light, &ray, &met);
        patch->seen[i] = meeting == PP_MEETS_PART
                                 && !pp_path_counted_by_nee(&state, patch->point, &met)
                             ? pp_control_variate_nearest(variate, scene, &met)
                             : -1;
    }
}

/* The irradiance of the patch from other patches, for the exitances `values`. */
static double exchanged(const struct variate_patch *patch, const double *values)
{
    double sum = 0.0, sides = 0.0;
    for (int k = 0; k < LOBE_SAMPLES; k++)
        if (patch->seen[k] >= 0)
            sum += values[patch->seen[k]];
    for (int k = 0; k < patch->side_count; k++)
        sides += patch->worth[k] * values[patch->sides[k]];
    return sum / LOBE_SAMPLES + sides;
}

/* Gauss-Seidel iteration: each patch in order gathers light from the patches that its
 * rays meet. Ends when an iteration changes the solution by less than 1e-4 of its
 * total, or after MOST_SWEEPS iterations. */
static void exchange(double *values, const struct variate_patch *patches, int count,
                     const struct pp_light_scene *scene)
{
    for (int i = 0; i < count; i++)
        values[i] = patches[i].own;
    double change = 1.0, total = 0.0;
    for (int sweep = 0; sweep < MOST_SWEEPS && change > 1e-4 * total; sweep++) {
        change = total = 0.0;
        for (int i = 0; i < count; i++) {
            double reflectance = patch_material(scene, &patches[i])->diffuse.g;
            double value =
                patches[i].own + reflectance * exchanged(&patches[i], values);
            change += fabs(value - values[i]);
            total += value;
            values[i] = value;
        }
    }
}

/* Patch at this offset in columns and rows from patch i of the grid. NULL: there is
 * none, or its centre is outside the surface's outline. */
static const struct variate_patch *neighbour(const struct variate_patch *patches,
                                             const struct pp_control_variate_grid *grid,
                                             int i, int columns, int rows)
{
    int column = i % grid->columns + columns, row = i / grid->columns + rows;
    if (column < 0 || column >= grid->columns || row < 0 || row >= grid->rows)
        return NULL;
    const struct variate_patch *patch =
        &patches[grid->first + row * grid->columns + column];
    return patch->in_figure ? patch : NULL;
}

/* Smooths the exchanged light: the true light varies little from patch to patch, but
 * the noise of each patch is independent. Each value becomes the mean over a patch and
 * its neighbours with weights 1, 2, 1 along each axis. Neighbours count in opposite
 * pairs only, so that a linear variation is kept. */
static void smooth(struct pp_control_variate *variate, struct variate_patch *patches,
                   const struct pp_control_variate_grid *grid)
{
    static const struct {
        int columns, rows;
        double weight;
    } pairs[] = {{1, 0, 2.0}, {0, 1, 2.0}, {1, 1, 1.0}, {1, -1, 1.0}};
    int end = grid->first + grid->columns * grid->rows;
    for (int i = grid->first; i < end; i++)
        patches[i].exchanged = variate->values[i] - patches[i].own;
    for (int i = grid->first; i < end; i++) {
        double sum = 4.0 * patches[i].exchanged, weights = 4.0;
        for (int k = 0; k < 4; k++) {
            int columns = pairs[k].columns, rows = pairs[k].rows;
            const struct variate_patch *one =
                neighbour(patches, grid, i - grid->first, columns, rows);
            const struct variate_patch *other =
                neighbour(patches, grid, i - grid->first, -columns, -rows);
            if (!one || !other)
                continue;
            sum += pairs[k].weight * (one->exchanged + other->exchanged);
            weights += 2.0 * pairs[k].weight;
        }
        variate->values[i] = patches[i].own + sum / weights;
    }
}

/* Gives patches outside the outline (for example, in the notch of an L-shaped face) the
 * mean value of the patches inside, for interpolation. */
static void fill_beside(struct pp_control_variate *variate,
                        const struct variate_patch *patches,
                        const struct pp_control_variate_grid *grid)
{
    int count = grid->columns * grid->rows, in_figure = 0;
    double sum = 0.0;
    for (int i = grid->first; i < grid->first + count; i++)
        if (patches[i].in_figure) {
            sum += variate->values[i];
            in_figure++;
        }
    for (int i = grid->first; i < grid->first + count; i++)
        if (!patches[i].in_figure)
            variate->values[i] = in_figure > 0 ? sum / in_figure : 0.0;
}

/* Task of a pool's workers: lighting patches. */
struct lighting {
    const struct pp_control_variate *variate;
    struct variate_patch *patches;
    const struct pp_light_scene *scene;
    const struct pp_environment *environment;
    const struct pp_sobol *sobol;
    uint64_t seed;
};

static bool light_one(void *data, int worker, int i)
{
    (void)worker;
    const struct lighting *lighting = data;
    struct variate_patch *patch = &lighting->patches[i];
    if (patch->in_figure)
        light_patch(patch, lighting->variate, lighting->scene, lighting->environment,
                    lighting->sobol, pp_hash(lighting->seed, (uint64_t)i));
    else
        for (int k = 0; k < LOBE_SAMPLES; k++)
            patch->seen[k] = -1;
    return true;
}

static void work_out(struct pp_control_variate *variate, struct variate_patch *patches,
                     const struct pp_light_scene *scene,
                     const struct pp_environment *environment,
                     const struct pp_sobol *sobol, uint64_t seed,
                     struct pp_thread_pool *pool)
{
    const struct pp_world *world = scene->world;
    int count = variate->count;
    struct lighting lighting = {variate, patches, scene, environment, sobol, seed};
    place_patches(patches, variate, scene, world);
    pp_thread_pool_run(pool, 0, count, light_one, &lighting);
    exchange(variate->values, patches, count, scene);
    for (int i = 0; i < world->surface_count; i++)
        for (int side = 0; side < 2; side++) {
            const struct pp_control_variate_grid *grid = &variate->grids[i][side];
            if (grid->first < 0)
                continue;
            smooth(variate, patches, grid);
            fill_beside(variate, patches, grid);
        }
}

enum pp_status pp_control_variate_solve(struct pp_control_variate **result,
                                        const struct pp_light_scene *scene,
                                        const struct pp_environment *environment,
                                        const struct pp_sobol *sobol, uint64_t seed,
                                        int threads, struct pp_error *err)
{
    const struct pp_world *world = scene->world;
    *result = NULL;
    int surfaces = 0;
    for (int i = 0; i < world->surface_count; i++)
        surfaces += world->surfaces[i].inside;
    if (surfaces == 0 || surfaces > MOST_SURFACES)
        return PP_OK;

    struct pp_control_variate *variate = calloc(1, sizeof *variate);
    if (!variate)
        return pp_fail_memory(err);
    variate->scene = scene;
    variate->niches = (struct pp_niche_light){pp_control_variate_of_side, variate};
    variate->grids = calloc((size_t)scene->part_count, sizeof *variate->grids);
    struct variate_patch *patches = NULL;
    if (variate->grids) {
        variate->count = lay_out_patches(variate, scene, world);
        variate->values = calloc((size_t)variate->count, sizeof *variate->values);
        patches = calloc((size_t)variate->count, sizeof *patches);
    }
    struct pp_thread_pool *pool = NULL;
    enum pp_status status = variate->grids && variate->values && patches
                                ? pp_thread_pool_create(&pool, threads, err)
                                : pp_fail_memory(err);
    if (status == PP_OK)
        work_out(variate, patches, scene, environment, sobol, seed, pool);
    else
        pp_control_variate_destroy(variate);
    pp_thread_pool_destroy(pool);
    free(patches);
    *result = status == PP_OK ? variate : NULL;
    return status;
}
