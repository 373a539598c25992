/* elements.c - levels, receivers, and what they changed. */
#include "simulate/elements/elements.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "simulate/elements/balance.h"
#include "simulate/elements/plane_points.h"

enum {
    MOST_LEVELS = 5,
    ROUNDS = 4,            /* of dividing, a level */
    MOST_ELEMENTS = 20000, /* no more are divided */
    PLANE_POINTS = 600,    /* of the first level */
    PLANE_STRIDE = 6,      /* every so many of them take what is reflected */
};

/* An error is no smaller than this share of the RMS one over all points: a single point may
 * change little by chance. */
static const double SHARE_OF_MEAN = 0.7;
/* And no smaller than these shares of what is reflected and of what comes straight, at
 * the first level that has an error, half of that at each further one: several changes may
 * cancel. What is stated by all this holds what it says in 96 of 100 (docs/theory.md). */
static const double LEAST_REFLECTED = 0.004, LEAST_DIRECT = 0.003;
/* The latter of the average, which is a sum over points. */
static const double LEAST_AVERAGE = 0.005;
static const double LEAST_FACTOR = 0.002; /* below this the error wanted is of Eh */

/* What a receiver takes. */
struct receiver {
    struct pp_receiver at;
    struct pp_light_sum openings, elements;
    struct pp_wanted wanted;
    double openings_value[PP_LIGHT_PARTS], elements_value[PP_LIGHT_PARTS];
    double df; /* both, without an allowance for decorations */
};

struct pp_elements {
    struct pp_elements_options options;
    struct pp_outdoors outdoors;
    struct pp_facets *facets;
    struct pp_element_sight *sight;
    struct pp_element_tree *tree;
    struct pp_outside_cells cells;
    struct pp_light_room room;
    struct pp_balance balance;
    struct pp_crew *crew;
    struct receiver *receivers; /* those asked for, then points of the plane */
    int asked, count;
    struct pp_plane_points plane;
    bool has_room, has_scattering; /* a pane that scatters? */
    int level;                     /* how many are done */
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

static struct pp_opening_light_accuracy of_openings(int level)
{
    double finer = ldexp(1.0, level);
    return (struct pp_opening_light_accuracy){.error = 0.004 / finer,
                                              .most_factor = 0.03 / finer,
                                              .least_depth = level > 0,
                                              .stricter = 0.5};
}

static struct pp_element_light_accuracy of_elements(int level)
{
    double finer = ldexp(1.0, level);
    return (struct pp_element_light_accuracy){.most_factor = 0.05 / finer,
                                              .least_factor = 1e-3 / finer};
}

static void set_accuracy(struct pp_elements *elements)
{
    double finer = ldexp(1.0, elements->level);
    struct pp_balance_accuracy *accuracy = &elements->balance.accuracy;
    accuracy->openings = (struct pp_opening_light_accuracy){.error = 0.03 / finer,
                                                            .most_factor = 0.1 / finer,
                                                            .least_depth = 0,
                                                            .stricter = 0.7};
    accuracy->elements = of_elements(elements->level);
    accuracy->even = 0.0002 / finer;
    accuracy->directions = 512 << elements->level;
    pp_outside_cells_clear(&elements->cells);
    elements->cells = pp_outside_cells_of(
        size_of(elements), 0.125 * pow(0.7, elements->level), 128 << elements->level);
}

/* ---- receivers ---- */

static void clear_receiver(struct receiver *receiver)
{
    pp_light_sum_clear(&receiver->openings);
    pp_light_sum_clear(&receiver->elements);
    free(receiver->wanted.list);
    receiver->wanted = (struct pp_wanted){NULL, 0, 0};
}

static bool take_by_openings(void *data, int member, int index)
{
    struct pp_elements *elements = data;
    struct receiver *receiver = &elements->receivers[index];
    struct pp_taker taker = {receiver->at.position, receiver->at.normal, -1};
    struct pp_opening_light_accuracy accuracy = of_openings(elements->level);
    (void)member;
    pp_light_sum_clear(&receiver->openings);
    if (elements->has_room) {
        pp_opening_light_add(&elements->room, elements->sight, &taker, &accuracy,
                             &receiver->openings);
        return true;
    }
    struct pp_light_ray_start place = {taker.point, taker.normal, -1, false};
    pp_outside_cells_hemisphere(&elements->room, &place, 4096 << 2 * elements->level,
                                (unsigned)index, 1.0, PP_DF, &receiver->openings);
    return true;
}

/* What is reflected changes slowly over the plane: a part of its points is enough, unless a
 * pane shines as a surface does. */
static bool takes_by_elements(const struct pp_elements *elements, int index)
{
    return elements->has_room
           && (index < elements->asked || elements->has_scattering
               || (index - elements->asked) % PLANE_STRIDE == 0);
}

static bool take_by_elements(void *data, int member, int index)
{
    struct pp_elements *elements = data;
    struct receiver *receiver = &elements->receivers[index];
    struct pp_taker taker = {receiver->at.position, receiver->at.normal, -1};
    struct pp_element_light_accuracy accuracy = of_elements(elements->level);
    (void)member;
    accuracy.tolerance = 0.5 * elements->balance.accuracy.even * receiver->df;
    accuracy.divided = 0.008 / ldexp(1.0, elements->level) * receiver->df;
    pp_light_sum_clear(&receiver->elements);
    receiver->wanted.count = 0;
    if (takes_by_elements(elements, index))
        pp_element_light_add(&elements->room, elements->sight, &taker, &accuracy,
                             &receiver->elements, &receiver->wanted);
    return true;
}

static void set_value(struct pp_elements *elements, struct receiver *receiver)
{
    memset(receiver->openings_value, 0, sizeof receiver->openings_value);
    memset(receiver->elements_value, 0, sizeof receiver->elements_value);
    pp_balance_value(&elements->balance, &receiver->openings, false,
                     receiver->openings_value);
    pp_balance_value(&elements->balance, &receiver->elements, true,
                     receiver->elements_value);
    receiver->df = 0.0;
    for (int i = 0; i < PP_LIGHT_PARTS; i++)
        receiver->df += receiver->openings_value[i] + receiver->elements_value[i];
}

/* What receivers from `first` up to `end` take; what comes by openings is kept from one
 * round to the next. */
static enum pp_status receive(struct pp_elements *elements, int first, int end,
                              bool openings, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    if (openings) {
        pp_crew_run(elements->crew, first, end, take_by_openings, elements);
        for (int i = first; status == PP_OK && i < end; i++)
            status = pp_outside_cells_resolve(&elements->cells, &elements->room,
                                              &elements->receivers[i].openings, err);
        if (status == PP_OK)
            status = pp_outside_cells_gather(&elements->cells, &elements->room,
                                             elements->crew, err);
        if (status == PP_OK)
            pp_balance_solve(&elements->balance);
    }
    pp_crew_run(elements->crew, first, end, take_by_elements, elements);
    for (int i = first; status == PP_OK && i < end; i++) {
        set_value(elements, &elements->receivers[i]);
        if (elements->receivers[i].elements.failed)
            status = pp_fail_memory(err);
    }
    return status;
}

/* ---- a level ---- */

/* Elements over which the light differs by more than a share of all that the room gives off,
 * and those that receivers want. */
static enum pp_status divide(struct pp_elements *elements, int *divided,
                             struct pp_error *err)
{
    struct pp_element_tree *tree = elements->tree;
    double least = 6e-4 / ldexp(1.0, elements->level), all = 0.0;
    enum pp_status status = PP_OK;
    int count = tree->count;
    *divided = 0;
    if (count > MOST_ELEMENTS)
        return PP_OK;
    for (int i = 0; status == PP_OK && i < elements->asked; i++)
        status = pp_balance_divide(&elements->balance, &elements->receivers[i].wanted,
                                   divided, err);
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
    enum pp_status status = PP_OK;
    int divided = 1;
    for (int round = 0; status == PP_OK && round <= ROUNDS && divided > 0; round++) {
        status = pp_balance_gather(&elements->balance, err);
        if (status == PP_OK)
            pp_balance_solve(&elements->balance);
        /* Illuminances are known from here on; before, nothing tells what is even. */
        if (status == PP_OK && elements->level == 0 && round == 0)
            status = pp_balance_gather(&elements->balance, err);
        if (status == PP_OK)
            status = receive(elements, 0, elements->asked, round == 0, err);
        if (status == PP_OK && round < ROUNDS)
            status = divide(elements, &divided, err);
    }
    if (status == PP_OK)
        status = receive(elements, elements->asked, elements->count, true, err);
    return status;
}

/* Adds a share of a receiver's light to readings now. */
static void add(const struct pp_elements *elements, double *now,
                const double value[PP_LIGHT_PARTS], double share)
{
    for (int i = 0; i < PP_LIGHT_PARTS; i++) {
        double part = share * value[i] * (i == PP_IRC ? elements->decorations : 1.0);
        now[i] += part;
        now[PP_DF] += part;
    }
}

/* The daylight factors now; the plane's from its points. */
static void keep(struct pp_elements *elements)
{
    const struct pp_plane_points *plane = &elements->plane;
    double *average = elements->now[elements->asked], taking = 0.0;
    memset(elements->now, 0, ((size_t)elements->asked + 1) * sizeof *elements->now);
    for (int i = 0; i < elements->asked; i++) {
        const struct receiver *receiver = &elements->receivers[i];
        add(elements, elements->now[i], receiver->openings_value, 1.0);
        add(elements, elements->now[i], receiver->elements_value, 1.0);
    }
    for (int i = 0; i < plane->count; i++)
        taking +=
            takes_by_elements(elements, elements->asked + i) ? plane->shares[i] : 0.0;
    for (int i = 0; i < plane->count; i++) {
        const struct receiver *receiver = &elements->receivers[elements->asked + i];
        add(elements, average, receiver->openings_value, plane->shares[i]);
        add(elements, average, receiver->elements_value, plane->shares[i] / taking);
    }
    for (int c = 0; plane->count == 0 && c < PP_COMPONENT_COUNT; c++)
        average[c] = NAN;
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

/* The plane's points of this level, behind the receivers asked for. */
static enum pp_status set_plane(struct pp_elements *elements, struct pp_error *err)
{
    for (int i = 0; i < elements->count; i++)
        clear_receiver(&elements->receivers[i]);
    elements->count = elements->asked;
    pp_plane_points_clear(&elements->plane);
    enum pp_status status = PP_OK;
    if (elements->has_room)
        status =
            pp_plane_points_of(&elements->plane, elements->balance.tree->facets->world,
                               PLANE_POINTS << elements->level, err);
    if (status != PP_OK)
        return status;
    size_t count = (size_t)elements->asked + (size_t)elements->plane.count;
    struct receiver *more =
        realloc(elements->receivers, (count + 1) * sizeof *elements->receivers);
    if (!more)
        return pp_fail_memory(err);
    elements->receivers = more;
    for (int i = 0; i < elements->plane.count; i++)
        more[elements->asked + i] = (struct receiver){
            .at = {.position = elements->plane.list[i], .normal = {0.0, 0.0, 1.0}}};
    elements->count = (int)count;
    return PP_OK;
}

enum pp_status pp_elements_advance(struct pp_elements *elements, struct pp_error *err)
{
    size_t kept = ((size_t)elements->asked + 1) * sizeof *elements->now;
    enum pp_status status = set_plane(elements, err);
    if (status != PP_OK)
        return status;
    pp_balance_clear(&elements->balance);
    set_accuracy(elements);
    status = rounds(elements, err);
    if (status != PP_OK)
        return status;
    memcpy(elements->before, elements->now, kept);
    keep(elements);
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
        status = pp_crew_create(&elements->crew, elements->options.threads, err);
    if (status != PP_OK)
        return status;
    elements->has_room = world->face_count > 0;
    elements->decorations = world->decorations;
    for (int i = 0; i < elements->facets->count; i++)
        elements->has_scattering |= elements->facets->list[i].through > 0.0;
    elements->room =
        (struct pp_light_room){elements->facets, elements->tree, &elements->outdoors};
    elements->balance = (struct pp_balance){.tree = elements->tree,
                                            .room = &elements->room,
                                            .sight = elements->sight,
                                            .cells = &elements->cells,
                                            .crew = elements->crew};
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
    elements->asked = elements->count = receiver_count;
    elements->receivers = calloc(count + 1, sizeof *elements->receivers);
    elements->now = calloc(count + 1, sizeof *elements->now);
    elements->before = calloc(count + 1, sizeof *elements->before);
    enum pp_status status = elements->receivers && elements->now && elements->before
                                ? make(elements, world, light, err)
                                : pp_fail_memory(err);
    for (size_t i = 0; status == PP_OK && i < count; i++)
        elements->receivers[i].at = receivers[i];
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
    for (int i = 0; elements->receivers && i < elements->count; i++)
        clear_receiver(&elements->receivers[i]);
    pp_plane_points_clear(&elements->plane);
    pp_outdoors_clear(&elements->outdoors);
    pp_element_tree_destroy(elements->tree);
    pp_element_sight_destroy(elements->sight);
    pp_facets_destroy(elements->facets);
    pp_crew_destroy(elements->crew);
    free(elements->receivers);
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
                   || pp_elements_error(elements) <= elements->options.error));
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
