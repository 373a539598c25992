/* radiosity.c - calculates level after level, and estimates the error from the changes
 * between levels. */
#include "simulate/research/radiosity/radiosity.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "simulate/research/radiosity/element_receivers.h"

enum {
    MOST_LEVELS = 5,
    ROUNDS = 4,            /* most rounds of division in a level */
    MOST_ELEMENTS = 20000, /* with more elements there is no further division */
    MOST_TERMS = 4000000,  /* with more terms there is no further level, since it would
                            * have about three times as many */
};

/* Least error of a point, as a fraction of the RMS error over all points, since the
 * value of a single point may change little by chance. */
static const double SHARE_OF_MEAN = 0.7;
/* Least relative errors of reflected and of direct light at the first level with an
 * error estimate, halved at each further level. They are needed because changes may
 * cancel. The stated error holds in 98 of 100 cases (docs/methods/radiosity.md). */
static const double LEAST_REFLECTED = 0.004, LEAST_DIRECT = 0.003;
/* Least relative error of direct light for the average, which is a sum over points. */
static const double LEAST_AVERAGE = 0.005;
static const double LEAST_FACTOR = 0.002; /* least daylight factor to which errors and
                                           * changes are relative */

struct pp_radiosity {
    struct pp_radiosity_options options;
    struct pp_outdoors outdoors;
    struct pp_facets *facets;
    struct pp_element_sight *sight;
    struct pp_element_tree *tree;
    struct pp_outside_cells cells;
    struct pp_light_room room;
    struct pp_radiosity_system system;
    struct pp_thread_pool *pool;
    struct pp_element_receivers receivers;
    int asked;
    int level; /* number of levels done */
    double (*now)[PP_COMPONENT_COUNT],
        (*before)[PP_COMPONENT_COUNT]; /* by requested receiver, then the plane */
    double off[PP_COMPONENT_COUNT]; /* RMS of the last change, relative to the daylight
                                     * factor */
    double decorations;
};

static double size_of(const struct pp_radiosity *radiosity)
{
    const struct pp_bounds3 *box = &radiosity->facets->room;
    return fmax(0.5 * pp_vec_length(pp_vec_sub(box->high, box->low)), 0.1);
}

/* ---- the accuracy of a level ---- */

static void set_accuracy(struct pp_radiosity *radiosity)
{
    double finer = ldexp(1.0, radiosity->level);
    struct pp_radiosity_system_accuracy *accuracy = &radiosity->system.accuracy;
    accuracy->openings = (struct pp_opening_light_accuracy){.error = 0.02 / finer,
                                                            .most_factor = 0.2 / finer,
                                                            .least_depth = 0,
                                                            .stricter = 0.7};
    accuracy->elements = pp_element_receivers_accuracy(radiosity->level);
    accuracy->even = 0.0002 / finer;
    accuracy->directions = 512 << radiosity->level;
    pp_outside_cells_clear(&radiosity->cells);
    radiosity->cells =
        (struct pp_outside_cells){.size_m = size_of(radiosity),
                                  .width = 0.125 * pow(0.7, radiosity->level),
                                  .directions = 128 << radiosity->level};
}

/* ---- a level ---- */

/* Divides the elements over which the light differs by more than a fraction of the
 * room's total. Also divides the elements that receivers have requested. */
static enum pp_status divide_elements(struct pp_radiosity *radiosity, int *divided,
                                      struct pp_error *err)
{
    struct pp_element_tree *tree = radiosity->tree;
    double least = 1e-3 / ldexp(1.0, radiosity->level), all = 0.0;
    enum pp_status status = PP_OK;
    int count = tree->count;
    *divided = 0;
    if (count > MOST_ELEMENTS)
        return PP_OK;
    for (int i = 0; status == PP_OK && i < radiosity->asked; i++)
        status = pp_radiosity_system_divide(
            &radiosity->system, &radiosity->receivers.list[i].wanted, divided, err);
    for (int i = 0; i < count; i++)
        if (tree->list[i].parent < 0)
            all += tree->list[i].area_m2 * tree->list[i].radiosity;
    for (int i = 0; status == PP_OK && i < count; i++) {
        struct pp_element *element = &tree->list[i];
        if (element->part_count > 0
            || element->spread * element->area_m2 <= least * all)
            continue;
        status = pp_element_tree_divide(tree, i, err);
        ++*divided;
    }
    return status;
}

static enum pp_status rounds(struct pp_radiosity *radiosity, struct pp_error *err)
{
    struct pp_element_receivers *receivers = &radiosity->receivers;
    enum pp_status status = PP_OK;
    int divided = 1;
    for (int round = 0; status == PP_OK && round <= ROUNDS && divided > 0; round++) {
        status = pp_radiosity_system_gather(&radiosity->system, err);
        if (status == PP_OK)
            pp_radiosity_system_solve(&radiosity->system);
        /* Gathers a second time at the first level, since the spreads of elements were
         * unknown at first and now follow from the solution. */
        if (status == PP_OK && radiosity->level == 0 && round == 0)
            status = pp_radiosity_system_gather(&radiosity->system, err);
        if (status == PP_OK && round == 0)
            status = pp_element_receivers_by_openings(receivers, err);
        if (status == PP_OK)
            status = pp_element_receivers_by_elements(receivers, err);
        if (status == PP_OK && round < ROUNDS)
            status = divide_elements(radiosity, &divided, err);
    }
    return status == PP_OK ? pp_element_receivers_on_plane(receivers, err) : status;
}

/* Calculates the RMS change at the points, relative to their daylight factors. */
static void compare_levels(struct pp_radiosity *radiosity)
{
    for (int c = 0; c < PP_COMPONENT_COUNT; c++) {
        double sum = 0.0;
        for (int i = 0; i < radiosity->asked; i++) {
            double off = radiosity->now[i][c] - radiosity->before[i][c];
            off /= fmax(radiosity->now[i][PP_DF], LEAST_FACTOR);
            sum += off * off / radiosity->asked;
        }
        radiosity->off[c] = sqrt(sum);
    }
}

enum pp_status pp_radiosity_advance(struct pp_radiosity *radiosity,
                                    struct pp_error *err)
{
    size_t kept = ((size_t)radiosity->asked + 1) * sizeof *radiosity->now;
    enum pp_status status = pp_element_receivers_begin(
        &radiosity->receivers, &radiosity->system, radiosity->level, err);
    if (status != PP_OK)
        return status;
    pp_radiosity_system_clear(&radiosity->system);
    set_accuracy(radiosity);
    status = rounds(radiosity, err);
    if (status != PP_OK)
        return status;
    memcpy(radiosity->before, radiosity->now, kept);
    for (int i = 0; i <= radiosity->asked; i++)
        pp_element_receivers_value(&radiosity->receivers, i < radiosity->asked ? i : -1,
                                   radiosity->decorations, radiosity->now[i]);
    if (radiosity->level > 0)
        compare_levels(radiosity);
    radiosity->level++;
    return PP_OK;
}

/* ---- beginning and end ---- */

static enum pp_status make_radiosity(struct pp_radiosity *radiosity,
                                     const struct pp_world *world,
                                     const struct pp_outside_light *light,
                                     struct pp_error *err)
{
    enum pp_status status = pp_facets_create(&radiosity->facets, world, err);
    if (status == PP_OK)
        status = pp_element_sight_create(&radiosity->sight, radiosity->facets, err);
    if (status == PP_OK)
        status = pp_element_tree_create(&radiosity->tree, radiosity->facets,
                                        pp_facets_element_m(radiosity->facets), err);
    if (status == PP_OK)
        status = pp_outdoors_init(&radiosity->outdoors, world, light,
                                  radiosity->facets->reach_m, err);
    if (status == PP_OK)
        status =
            pp_thread_pool_create(&radiosity->pool, radiosity->options.threads, err);
    if (status != PP_OK)
        return status;
    radiosity->decorations = world->decorations;
    radiosity->room = (struct pp_light_room){radiosity->facets, radiosity->tree,
                                             &radiosity->outdoors, radiosity->sight};
    radiosity->system = (struct pp_radiosity_system){.tree = radiosity->tree,
                                                     .room = &radiosity->room,
                                                     .cells = &radiosity->cells,
                                                     .pool = radiosity->pool};
    return PP_OK;
}

enum pp_status pp_radiosity_create(struct pp_radiosity **result,
                                   const struct pp_world *world,
                                   const struct pp_outside_light *light,
                                   const struct pp_receiver *receivers,
                                   int receiver_count,
                                   const struct pp_radiosity_options *options,
                                   struct pp_error *err)
{
    *result = NULL;
    struct pp_radiosity *radiosity = calloc(1, sizeof *radiosity);
    if (!radiosity)
        return pp_fail_memory(err);
    size_t count = (size_t)receiver_count;
    radiosity->options = *options;
    radiosity->asked = receiver_count;
    radiosity->now = calloc(count + 1, sizeof *radiosity->now);
    radiosity->before = calloc(count + 1, sizeof *radiosity->before);
    enum pp_status status =
        radiosity->now && radiosity->before ? pp_element_receivers_init(
            &radiosity->receivers, receivers, receiver_count, err)
                                            : pp_fail_memory(err);
    if (status == PP_OK)
        status = make_radiosity(radiosity, world, light, err);
    if (status != PP_OK) {
        pp_radiosity_destroy(radiosity);
        return status;
    }
    *result = radiosity;
    return PP_OK;
}

void pp_radiosity_destroy(struct pp_radiosity *radiosity)
{
    if (!radiosity)
        return;
    pp_radiosity_system_clear(&radiosity->system);
    pp_outside_cells_clear(&radiosity->cells);
    pp_element_receivers_clear(&radiosity->receivers);
    pp_outdoors_clear(&radiosity->outdoors);
    pp_element_tree_destroy(radiosity->tree);
    pp_element_sight_destroy(radiosity->sight);
    pp_facets_destroy(radiosity->facets);
    pp_thread_pool_destroy(radiosity->pool);
    free(radiosity->now);
    free(radiosity->before);
    free(radiosity);
}

/* ---- errors ---- */

/* Estimated error of a component at a point, from the change at the last level; NAN
 * before the second level. */
static double error_of(const struct pp_radiosity *radiosity, int index, int component)
{
    const double *now = radiosity->now[index], *before = radiosity->before[index];
    double finer = ldexp(1.0, radiosity->level - 2);
    double reflected = component >= PP_IRC ? LEAST_REFLECTED * now[PP_IRC] : 0.0;
    double direct = component == PP_DF   ? now[PP_SC] + now[PP_ERC]
                    : component < PP_IRC ? now[component]
                                         : 0.0;
    if (radiosity->level < 2)
        return NAN;
    double error = fmax(fabs(now[component] - before[component]),
                        SHARE_OF_MEAN * radiosity->off[component] * now[PP_DF]);
    double share = index == radiosity->asked ? LEAST_AVERAGE : LEAST_DIRECT;
    return fmax(error, (reflected + share * direct) / finer);
}

double pp_radiosity_error(const struct pp_radiosity *radiosity)
{
    double most = radiosity->level < 2 ? NAN : 0.0;
    for (int i = 0; radiosity->level >= 2 && i < radiosity->asked; i++) {
        double df = fmax(radiosity->now[i][PP_DF], LEAST_FACTOR);
        most = fmax(most, error_of(radiosity, i, PP_DF) / df);
    }
    return most;
}

bool pp_radiosity_done(const struct pp_radiosity *radiosity)
{
    return radiosity->level >= MOST_LEVELS || radiosity->tree->count > MOST_ELEMENTS
           || (radiosity->level >= 2
               && (!(radiosity->options.error > 0.0)
                   || pp_radiosity_error(radiosity) <= radiosity->options.error
                   || pp_radiosity_size(radiosity).terms > MOST_TERMS));
}

double pp_radiosity_progress(const struct pp_radiosity *radiosity)
{
    return pp_radiosity_done(radiosity) ? 1.0 : (double)radiosity->level / MOST_LEVELS;
}

void pp_radiosity_read(const struct pp_radiosity *radiosity, int index,
                       struct pp_reading readings[PP_COMPONENT_COUNT])
{
    int at = index < 0 ? radiosity->asked : index;
    for (int c = 0; c < PP_COMPONENT_COUNT; c++)
        readings[c] = radiosity->level == 0
                          ? pp_reading_none("no refinement level is complete yet")
                          : (struct pp_reading){radiosity->now[at][c],
                                                error_of(radiosity, at, c), NULL, 0};
}

struct pp_radiosity_size pp_radiosity_size(const struct pp_radiosity *radiosity)
{
    struct pp_radiosity_size size = {.level = radiosity->level,
                                     .cells = radiosity->cells.count};
    for (int i = 0; i < radiosity->tree->count; i++) {
        bool divided = radiosity->tree->list[i].part_count > 0;
        size.divided += divided;
        size.elements += !divided;
    }
    for (int i = 0; i < radiosity->system.row_count; i++)
        size.terms += radiosity->system.rows[i].elements.term_count
                      + radiosity->system.rows[i].openings.term_count;
    for (int i = 0; i < radiosity->cells.count; i++)
        size.terms += radiosity->cells.list[i].taken.term_count;
    return size;
}
