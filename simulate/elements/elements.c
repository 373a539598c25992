/* elements.c - levels, and what they changed. */
#include "simulate/elements/elements.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "simulate/elements/element_receivers.h"

enum {
    MOST_LEVELS = 5,
    ROUNDS = 4,            /* of dividing, a level */
    MOST_ELEMENTS = 20000, /* no more are divided */
    MOST_TERMS = 4000000, /* no level after one of more: it would have thrice as many */
};

/* An error is no smaller than this share of the RMS one over all points: a single point may
 * change little by chance. */
static const double SHARE_OF_MEAN = 0.7;
/* And no smaller than these shares of what is reflected and of what comes straight, at
 * the first level that has an error, half of that at each further one: several changes may
 * cancel. What is stated by all this holds what it says in 98 of 100 (docs/theory.md). */
static const double LEAST_REFLECTED = 0.004, LEAST_DIRECT = 0.003;
/* The latter of the average, which is a sum over points. */
static const double LEAST_AVERAGE = 0.005;
static const double LEAST_FACTOR = 0.002; /* below this the error wanted is of Eh */

struct pp_elements {
    struct pp_elements_options options;
    struct pp_outdoors outdoors;
    struct pp_facets *facets;
    struct pp_element_sight *sight;
    struct pp_element_tree *tree;
    struct pp_outside_cells cells;
    struct pp_light_room room;
    struct pp_balance balance;
    struct pp_thread_pool *pool;
    struct pp_element_receivers receivers;
    int asked;
    int level; /* how many are done */
    double (*now)[PP_COMPONENT_COUNT], (*before)[PP_COMPONENT_COUNT]; /* by receiver
                                                        * asked for; the plane last */
    double
        off[PP_COMPONENT_COUNT]; /* RMS of the last change, over the daylight factor */
    double decorations;
};

static double size_of(const struct pp_elements *elements)
{
    const struct pp_bounds3 *box = &elements->facets->room;
    return fmax(0.5 * pp_vec_length(pp_vec_sub(box->high, box->low)), 0.1);
}

/* ---- the accuracy of a level ---- */

static void set_accuracy(struct pp_elements *elements)
{
    double finer = ldexp(1.0, elements->level);
    struct pp_balance_accuracy *accuracy = &elements->balance.accuracy;
    accuracy->openings = (struct pp_opening_light_accuracy){.error = 0.02 / finer,
                                                            .most_factor = 0.2 / finer,
                                                            .least_depth = 0,
                                                            .stricter = 0.7};
    accuracy->elements = pp_element_receivers_accuracy(elements->level);
    accuracy->even = 0.0002 / finer;
    accuracy->directions = 512 << elements->level;
    pp_outside_cells_clear(&elements->cells);
    elements->cells =
        (struct pp_outside_cells){.size_m = size_of(elements),
                                  .width = 0.125 * pow(0.7, elements->level),
                                  .directions = 128 << elements->level};
}

/* ---- a level ---- */

/* Elements over which the light differs by more than a share of all that the room gives off,
 * and those that receivers want. */
static enum pp_status divide(struct pp_elements *elements, int *divided,
                             struct pp_error *err)
{
    struct pp_element_tree *tree = elements->tree;
    double least = 1e-3 / ldexp(1.0, elements->level), all = 0.0;
    enum pp_status status = PP_OK;
    int count = tree->count;
    *divided = 0;
    if (count > MOST_ELEMENTS)
        return PP_OK;
    for (int i = 0; status == PP_OK && i < elements->asked; i++)
        status = pp_balance_divide(&elements->balance,
                                   &elements->receivers.list[i].wanted, divided, err);
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

static enum pp_status rounds(struct pp_elements *elements, struct pp_error *err)
{
    struct pp_element_receivers *receivers = &elements->receivers;
    enum pp_status status = PP_OK;
    int divided = 1;
    for (int round = 0; status == PP_OK && round <= ROUNDS && divided > 0; round++) {
        status = pp_balance_gather(&elements->balance, err);
        if (status == PP_OK)
            pp_balance_solve(&elements->balance);
        /* Illuminances are known from here on; before, nothing tells what is even. */
        if (status == PP_OK && elements->level == 0 && round == 0)
            status = pp_balance_gather(&elements->balance, err);
        if (status == PP_OK && round == 0)
            status = pp_element_receivers_by_openings(receivers, err);
        if (status == PP_OK)
            status = pp_element_receivers_by_elements(receivers, err);
        if (status == PP_OK && round < ROUNDS)
            status = divide(elements, &divided, err);
    }
    return status == PP_OK ? pp_element_receivers_on_plane(receivers, err) : status;
}

/* RMS of the change at the points, relative to their daylight factors. */
static void compare(struct pp_elements *elements)
{
    for (int c = 0; c < PP_COMPONENT_COUNT; c++) {
        double sum = 0.0;
        for (int i = 0; i < elements->asked; i++) {
            double off = elements->now[i][c] - elements->before[i][c];
            off /= fmax(elements->now[i][PP_DF], LEAST_FACTOR);
            sum += off * off / elements->asked;
        }
        elements->off[c] = sqrt(sum);
    }
}

enum pp_status pp_elements_advance(struct pp_elements *elements, struct pp_error *err)
{
    size_t kept = ((size_t)elements->asked + 1) * sizeof *elements->now;
    enum pp_status status = pp_element_receivers_begin(
        &elements->receivers, &elements->balance, elements->level, err);
    if (status != PP_OK)
        return status;
    pp_balance_clear(&elements->balance);
    set_accuracy(elements);
    status = rounds(elements, err);
    if (status != PP_OK)
        return status;
    memcpy(elements->before, elements->now, kept);
    for (int i = 0; i <= elements->asked; i++)
        pp_element_receivers_value(&elements->receivers, i < elements->asked ? i : -1,
                                   elements->decorations, elements->now[i]);
    if (elements->level > 0)
        compare(elements);
    elements->level++;
    return PP_OK;
}

/* ---- beginning and end ---- */

static enum pp_status make(struct pp_elements *elements, const struct pp_world *world,
                           const struct pp_outside_light *light, struct pp_error *err)
{
    enum pp_status status = pp_facets_create(&elements->facets, world, err);
    if (status == PP_OK)
        status = pp_element_sight_create(&elements->sight, elements->facets, err);
    if (status == PP_OK)
        status = pp_element_tree_create(&elements->tree, elements->facets,
                                        pp_facets_element_m(elements->facets), err);
    if (status == PP_OK)
        status = pp_outdoors_init(&elements->outdoors, world, light,
                                  elements->facets->reach_m, err);
    if (status == PP_OK)
        status = pp_thread_pool_create(&elements->pool, elements->options.threads, err);
    if (status != PP_OK)
        return status;
    elements->decorations = world->decorations;
    elements->room = (struct pp_light_room){elements->facets, elements->tree,
                                            &elements->outdoors, elements->sight};
    elements->balance = (struct pp_balance){.tree = elements->tree,
                                            .room = &elements->room,
                                            .cells = &elements->cells,
                                            .pool = elements->pool};
    return PP_OK;
}

enum pp_status pp_elements_create(
    struct pp_elements **result, const struct pp_world *world,
    const struct pp_outside_light *light, const struct pp_receiver *receivers,
    int receiver_count, const struct pp_elements_options *options, struct pp_error *err)
{
    *result = NULL;
    struct pp_elements *elements = calloc(1, sizeof *elements);
    if (!elements)
        return pp_fail_memory(err);
    size_t count = (size_t)receiver_count;
    elements->options = *options;
    elements->asked = receiver_count;
    elements->now = calloc(count + 1, sizeof *elements->now);
    elements->before = calloc(count + 1, sizeof *elements->before);
    enum pp_status status =
        elements->now && elements->before ? pp_element_receivers_init(
            &elements->receivers, receivers, receiver_count, err)
                                          : pp_fail_memory(err);
    if (status == PP_OK)
        status = make(elements, world, light, err);
    if (status != PP_OK) {
        pp_elements_destroy(elements);
        return status;
    }
    *result = elements;
    return PP_OK;
}

void pp_elements_destroy(struct pp_elements *elements)
{
    if (!elements)
        return;
    pp_balance_clear(&elements->balance);
    pp_outside_cells_clear(&elements->cells);
    pp_element_receivers_clear(&elements->receivers);
    pp_outdoors_clear(&elements->outdoors);
    pp_element_tree_destroy(elements->tree);
    pp_element_sight_destroy(elements->sight);
    pp_facets_destroy(elements->facets);
    pp_thread_pool_destroy(elements->pool);
    free(elements->now);
    free(elements->before);
    free(elements);
}

/* ---- what is known ---- */

/* The error of a component at a point, by what the last level has changed. */
static double error_of(const struct pp_elements *elements, int index, int component)
{
    const double *now = elements->now[index], *before = elements->before[index];
    double finer = ldexp(1.0, elements->level - 2);
    double reflected = component >= PP_IRC ? LEAST_REFLECTED * now[PP_IRC] : 0.0;
    double direct = component == PP_DF   ? now[PP_SC] + now[PP_ERC]
                    : component < PP_IRC ? now[component]
                                         : 0.0;
    if (elements->level < 2)
        return NAN;
    double error = fmax(fabs(now[component] - before[component]),
                        SHARE_OF_MEAN * elements->off[component] * now[PP_DF]);
    double share = index == elements->asked ? LEAST_AVERAGE : LEAST_DIRECT;
    return fmax(error, (reflected + share * direct) / finer);
}

double pp_elements_error(const struct pp_elements *elements)
{
    double most = elements->level < 2 ? NAN : 0.0;
    for (int i = 0; elements->level >= 2 && i < elements->asked; i++) {
        double df = fmax(elements->now[i][PP_DF], LEAST_FACTOR);
        most = fmax(most, error_of(elements, i, PP_DF) / df);
    }
    return most;
}

bool pp_elements_done(const struct pp_elements *elements)
{
    return elements->level >= MOST_LEVELS || elements->tree->count > MOST_ELEMENTS
           || (elements->level >= 2
               && (!(elements->options.error > 0.0)
                   || pp_elements_error(elements) <= elements->options.error
                   || pp_elements_size(elements).terms > MOST_TERMS));
}

double pp_elements_progress(const struct pp_elements *elements)
{
    return pp_elements_done(elements) ? 1.0 : (double)elements->level / MOST_LEVELS;
}

void pp_elements_read(const struct pp_elements *elements, int index,
                      struct pp_reading readings[PP_COMPONENT_COUNT])
{
    int at = index < 0 ? elements->asked : index;
    for (int c = 0; c < PP_COMPONENT_COUNT; c++)
        readings[c] = elements->level == 0
                          ? pp_reading_none("no level of elements is done yet")
                          : (struct pp_reading){elements->now[at][c],
                                                error_of(elements, at, c), NULL, 0};
}

struct pp_elements_size pp_elements_size(const struct pp_elements *elements)
{
    struct pp_elements_size size = {.level = elements->level,
                                    .cells = elements->cells.count};
    for (int i = 0; i < elements->tree->count; i++) {
        bool divided = elements->tree->list[i].part_count > 0;
        size.divided += divided;
        size.elements += !divided;
    }
    for (int i = 0; i < elements->balance.row_count; i++)
        size.terms += elements->balance.rows[i].elements.term_count
                      + elements->balance.rows[i].openings.term_count;
    for (int i = 0; i < elements->cells.count; i++)
        size.terms += elements->cells.list[i].taken.term_count;
    return size;
}
