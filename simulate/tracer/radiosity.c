/* radiosity.c - see radiosity.h. */
#include "simulate/tracer/radiosity.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "model/results/reading.h"
#include "simulate/sampling/hash.h"
#include "simulate/sampling/lobe.h"
#include "simulate/tracer/path.h"

enum {
    CELLS = 1200,         /* about so many in a room */
    MOST_SURFACES = 2000, /* in a room that gets a guess */
    OPENING_SAMPLES = 16, /* of each cell */
    LOBE_SAMPLES = 32,    /* of each cell */
    MOST_SWEEPS = 40,     /* of the cells' exchange */
    MOST_ALONG = 64,      /* cells along one edge */
};

/* What a cell is made of while the guess is worked out. */
struct radiosity_cell {
    struct pp_vec3 point;
    int facet;
    enum pp_facet_side side;
    bool in_figure;         /* else only its neighbours' stand-in */
    double own;             /* exitance without exchange: M + rho E */
    int seen[LOBE_SAMPLES]; /* cells that its rays meet; -1: none */
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

struct facet_box {
    double low_a, high_a, low_b, high_b;
};

static struct facet_box box_of(const struct pp_polygon *polygon,
                               const struct pp_facet *facet, struct pp_vec3 centre)
{
    struct facet_box box = {DBL_MAX, -DBL_MAX, DBL_MAX, -DBL_MAX};
    for (int i = 0; i < polygon->count; i++) {
        struct pp_vec3 v = pp_vec_sub(polygon->vertices[i], centre);
        double a = pp_vec_dot(v, facet->a), b = pp_vec_dot(v, facet->b);
        box.low_a = fmin(box.low_a, a);
        box.high_a = fmax(box.high_a, a);
        box.low_b = fmin(box.low_b, b);
        box.high_b = fmax(box.high_b, b);
    }
    return box;
}

static int cells_along(double length, double cell)
{
    double count = ceil(length / cell);
    return count < 1.0 ? 1 : count > MOST_ALONG ? MOST_ALONG : (int)count;
}

static bool has_side(const struct pp_facet *facet, const struct pp_surface *surface,
                     enum pp_facet_side side)
{
    return surface->inside && (side == PP_FRONT || !facet->envelope);
}

/* Grids for all sides that the room sees; returns how many cells they have. */
static int lay_out(struct pp_radiosity *guess, const struct pp_ray_scene *scene,
                   const struct pp_world *world)
{
    double area = 0.0;
    for (int i = 0; i < world->surface_count; i++)
        if (world->surfaces[i].inside)
            area += world->surfaces[i].outline.area_m2;
    double size = sqrt(area / CELLS);
    int count = 0;
    for (int i = 0; i < scene->facet_count; i++)
        for (int side = 0; side < 2; side++) {
            struct pp_radiosity_grid *patch = &guess->patches[i][side];
            const struct pp_facet *facet = &scene->facets[i];
            patch->first = -1;
            if (facet->opening >= 0 || !has_side(facet, &world->surfaces[i], side))
                continue;
            struct facet_box box =
                box_of(&world->surfaces[i].outline, facet, scene->centre);
            double width = box.high_a - box.low_a, height = box.high_b - box.low_b;
            patch->columns = cells_along(width, size);
            patch->rows = cells_along(height, size);
            patch->per_a = patch->columns / width;
            patch->per_b = patch->rows / height;
            patch->a0 = box.low_a + 0.5 / patch->per_a;
            patch->b0 = box.low_b + 0.5 / patch->per_b;
            patch->first = count;
            count += patch->columns * patch->rows;
        }
    return count;
}

static void place_cells(struct radiosity_cell *cells, const struct pp_radiosity *guess,
                        const struct pp_ray_scene *scene, const struct pp_world *world)
{
    for (int i = 0; i < world->surface_count; i++)
        for (int side = 0; side < 2; side++) {
            const struct pp_radiosity_grid *patch = &guess->patches[i][side];
            const struct pp_facet *facet = &scene->facets[i];
            for (int k = 0; patch->first >= 0 && k < patch->columns * patch->rows;
                 k++) {
                double a = patch->a0 + k % patch->columns / patch->per_a;
                double b = patch->b0 + k / patch->columns / patch->per_b;
                struct radiosity_cell *cell = &cells[patch->first + k];
                cell->facet = i;
                cell->side = side;
                cell->in_figure =
                    in_polygon(&world->surfaces[i].outline, facet, scene->centre, a, b);
                cell->point = pp_vec_along(
                    pp_vec_along(pp_vec_scale(facet->normal, facet->offset_m), a,
                                 facet->a),
                    b, facet->b);
            }
        }
}

static int nearest_cell(const struct pp_radiosity *guess,
                        const struct pp_ray_scene *scene,
                        const struct pp_contact *contact)
{
    if (contact->facet < 0)
        return -1;
    const struct pp_radiosity_grid *patch =
        &guess->patches[contact->facet][contact->side];
    if (patch->first < 0)
        return -1;
    const struct pp_facet *facet = &scene->facets[contact->facet];
    double a = (pp_vec_dot(contact->point, facet->a) - patch->a0) * patch->per_a + 0.5;
    double b = (pp_vec_dot(contact->point, facet->b) - patch->b0) * patch->per_b + 0.5;
    int column = a < 0.0 ? 0 : a < patch->columns ? (int)a : patch->columns - 1;
    int row = b < 0.0 ? 0 : b < patch->rows ? (int)b : patch->rows - 1;
    return patch->first + row * patch->columns + column;
}

/* Light through the openings to the cell, and the cells that its lobe sees. */
static void light_cell(struct radiosity_cell *cell, const struct pp_radiosity *guess,
                       const struct pp_ray_scene *scene, const struct pp_sobol *sobol,
                       uint64_t seed)
{
    struct pp_path_state state = {.scene = scene};
    pp_sobol_sequence_init(&state.sequence, sobol, seed);
    const struct pp_facet *facet = &scene->facets[cell->facet];
    struct pp_vec3 n =
        cell->side == PP_FRONT ? facet->normal : pp_vec_scale(facet->normal, -1.0);
    struct pp_light light = {{0.0, 0.0, 0.0}};
    for (uint32_t i = 0; i < OPENING_SAMPLES; i++) {
        double u[3];
        state.index = i;
        pp_sobol_sequence_draw(&state.sequence, i, 0, 3, u);
        pp_path_openings(&state, cell->point, n, u, 0, 1.0 / OPENING_SAMPLES, PP_IRC,
                         &light);
    }
    cell->own = facet->exitance + facet->reflectance[cell->side] * light.part[PP_IRC];
    for (uint32_t i = 0; i < LOBE_SAMPLES; i++) {
        double u[2];
        pp_sobol_sequence_draw(&state.sequence, i, 1, 2, u);
        struct pp_vec3 to = pp_lobe_sample_in_frame(facet->a, facet->b, n, u[0], u[1]);
        struct pp_contact met = pp_path_first(&state, cell->point, n, to);
        cell->seen[i] = nearest_cell(guess, scene, &met);
    }
}

/* Each cell takes its light from those it sees, in turn, until little changes. */
static void exchange(double *values, const struct radiosity_cell *cells, int count,
                     const struct pp_ray_scene *scene)
{
    for (int i = 0; i < count; i++)
        values[i] = cells[i].own;
    double change = 1.0, total = 0.0;
    for (int sweep = 0; sweep < MOST_SWEEPS && change > 1e-4 * total; sweep++) {
        change = total = 0.0;
        for (int i = 0; i < count; i++) {
            double sum = 0.0;
            for (int k = 0; k < LOBE_SAMPLES; k++)
                if (cells[i].seen[k] >= 0)
                    sum += values[cells[i].seen[k]];
            double reflectance =
                scene->facets[cells[i].facet].reflectance[cells[i].side];
            double value = cells[i].own + reflectance * sum / LOBE_SAMPLES;
            change += fabs(value - values[i]);
            total += value;
            values[i] = value;
        }
    }
}

/* Cells beside the figure (beyond the corner of an L) get the mean of those in it. */
static void fill_beside(struct pp_radiosity *guess, const struct radiosity_cell *cells,
                        const struct pp_radiosity_grid *patch)
{
    int count = patch->columns * patch->rows, in_figure = 0;
    double sum = 0.0;
    for (int i = patch->first; i < patch->first + count; i++)
        if (cells[i].in_figure) {
            sum += guess->values[i];
            in_figure++;
        }
    for (int i = patch->first; i < patch->first + count; i++)
        if (!cells[i].in_figure)
            guess->values[i] = in_figure > 0 ? sum / in_figure : 0.0;
}

static void work_out(struct pp_radiosity *guess, struct radiosity_cell *cells,
                     const struct pp_ray_scene *scene, const struct pp_world *world,
                     const struct pp_sobol *sobol, uint64_t seed, int threads)
{
    int count = guess->count;
    (void)threads;
    place_cells(cells, guess, scene, world);
#pragma omp parallel for num_threads(threads) schedule(dynamic, 16)
    for (int i = 0; i < count; i++)
        if (cells[i].in_figure)
            light_cell(&cells[i], guess, scene, sobol, pp_hash(seed, (uint64_t)i));
        else
            for (int k = 0; k < LOBE_SAMPLES; k++)
                cells[i].seen[k] = -1;
    exchange(guess->values, cells, count, scene);
    for (int i = 0; i < world->surface_count; i++)
        for (int side = 0; side < 2; side++)
            if (guess->patches[i][side].first >= 0)
                fill_beside(guess, cells, &guess->patches[i][side]);
}

enum pp_status pp_radiosity_create(struct pp_radiosity **result,
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

    struct pp_radiosity *guess = calloc(1, sizeof *guess);
    if (!guess)
        return pp_fail_memory(err);
    guess->patches = calloc((size_t)scene->facet_count, sizeof *guess->patches);
    struct radiosity_cell *cells = NULL;
    if (guess->patches) {
        guess->count = lay_out(guess, scene, world);
        guess->values = calloc((size_t)guess->count, sizeof *guess->values);
        cells = calloc((size_t)guess->count, sizeof *cells);
    }
    if (!guess->patches || !guess->values || !cells) {
        free(cells);
        pp_radiosity_destroy(guess);
        return pp_fail_memory(err);
    }
    work_out(guess, cells, scene, world, sobol, seed, threads);
    free(cells);
    *result = guess;
    return PP_OK;
}

void pp_radiosity_destroy(struct pp_radiosity *guess)
{
    if (!guess)
        return;
    free(guess->patches);
    free(guess->values);
    free(guess);
}

/* A coordinate in cells, kept between the first and the last centre; its whole part
 * goes to *cell. No floor(): that would be a call. */
static double within(double x, int count, int *cell)
{
    double last = count - 1;
    x = x > 0.0 ? x < last ? x : last : 0.0;
    *cell = (int)x;
    return x - *cell;
}

double pp_radiosity_at(const struct pp_radiosity *guess,
                       const struct pp_ray_scene *scene,
                       const struct pp_contact *contact)
{
    if (contact->facet < 0)
        return 0.0;
    const struct pp_radiosity_grid *patch =
        &guess->patches[contact->facet][contact->side];
    if (patch->first < 0)
        return 0.0;
    const struct pp_facet *facet = &scene->facets[contact->facet];
    int column, row;
    double s = within((pp_vec_dot(contact->point, facet->a) - patch->a0) * patch->per_a,
                      patch->columns, &column);
    double t = within((pp_vec_dot(contact->point, facet->b) - patch->b0) * patch->per_b,
                      patch->rows, &row);
    int right = column + 1 < patch->columns, above = row + 1 < patch->rows;
    const double *low = &guess->values[patch->first + row * patch->columns + column];
    const double *high = low + above * patch->columns;
    double below = low[0] + s * (low[right] - low[0]);
    double over = high[0] + s * (high[right] - high[0]);
    return below + t * (over - below);
}
