/* size.c - the search described in size.h: a scan of the whole range, bisection between
 * the two sizes that enclose the target, and finer steps at the end.
 */
#include "studies/sizing/size.h"

#include <math.h>

#include "model/room/building.h"

/* The numbers of sizes, and all tolerances below except the one for rounding, were
 * chosen by trial. */
enum {
    SCANNED = 9,         /* number of sizes in the scan of the whole range, including
                          * both ends */
    SCANNED_SAMPLED = 4, /* the same for sampled values, which take more time */
    REFINED_MOST = 3,    /* maximum number of grid refinements: down to a micrometre */
};

/* The search ends if the value exceeds the target by at most this fraction, unless it
 * is a count or sampled. */
static const double near_share = 0.0025;

/* The search ends if the difference between a sampled value and the target is at most
 * this number of standard errors. */
static const double near_errors = 0.5;

/* The search ends if the lower limit of a sampled value exceeds the target by at most
 * this fraction. */
static const double near_limit = 0.01;

/* A value that is below the target by at most this fraction is treated as equal to it,
 * since the difference is due to rounding. */
static const double rounding_share = 1e-9;

/* A size that was tried, and its value. */
struct size_trial {
    int step;
    struct pp_reading reading;
};

struct search {
    const struct pp_size_task *task;
    struct pp_window_sizes *sizes;
    struct pp_size_answer *answer;
};

/* Makes the world of a changed room. If the room is invalid, the first error found in
 * it becomes the error message. */
static enum pp_status world_of(struct pp_world **world, const struct pp_room *room,
                               struct pp_error *err)
{
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, "the changed room");
    enum pp_status status = pp_world_create(world, room, &mistakes, err);
    if (status == PP_BAD_INPUT && mistakes.count > 0)
        pp_fail(err, status, "the room with the changed window is not valid: %s",
                mistakes.list[0].text);
    pp_mistakes_clear(&mistakes);
    return status;
}

static enum pp_status evaluate_size(const struct search *search, int step,
                                    struct size_trial *trial, struct pp_error *err)
{
    struct pp_room *room = NULL;
    struct pp_world *world = NULL;
    trial->step = step;
    enum pp_status status = pp_window_sizes_room(&room, search->sizes, step, err);
    if (status == PP_OK)
        status = world_of(&world, room, err);
    if (status == PP_OK)
        status = search->task->value(search->task->data, world, &trial->reading, err);
    search->answer->evaluations++;
    pp_world_destroy(world);
    pp_room_destroy(room);
    return status;
}

static bool has_value(const struct size_trial *trial)
{
    return isfinite(trial->reading.value);
}

static bool is_sampled(const struct search *search, const struct size_trial *trial)
{
    return search->task->sampled || isfinite(trial->reading.std_error);
}

static bool reaches(const struct search *search, const struct size_trial *trial)
{
    return trial->reading.value >= (1.0 - rounding_share) * search->task->target;
}

/* True if the value is near enough to the target for the search to end. */
static bool is_near(const struct search *search, const struct size_trial *trial)
{
    if (search->task->sampled)
        return reaches(search, trial)
               && trial->reading.value <= (1.0 + near_limit) * search->task->target;
    return isfinite(trial->reading.std_error)
           && fabs(trial->reading.value - search->task->target)
                  <= near_errors * trial->reading.std_error;
}

/* Next size to be evaluated between two sizes: the middle one. For sampled values, the
 * size where a straight line through both values reaches the target, but at least a
 * tenth of the interval from either end. */
static int size_between(const struct search *search, const struct size_trial *below,
                        const struct size_trial *above)
{
    int steps = above->step - below->step;
    double share = 0.5;
    if (is_sampled(search, above)) {
        double rise = above->reading.value - below->reading.value;
        if (rise > 0.0)
            share = (search->task->target - below->reading.value) / rise;
        share = fmin(fmax(share, 0.1), 0.9);
    }
    int step = below->step + (int)round(share * steps);
    return step <= below->step   ? below->step + 1
           : step >= above->step ? above->step - 1
                                 : step;
}

/* Narrows the interval until its ends are neighbouring sizes, or until the value of a
 * size is near the target; `above` is then that size. */
static enum pp_status narrow(const struct search *search, struct size_trial *below,
                             struct size_trial *above, struct pp_error *err)
{
    if (is_near(search, below))
        *above = *below;
    while (above->step - below->step > 1 && !is_near(search, above)) {
        struct size_trial trial = {0};
        enum pp_status status =
            evaluate_size(search, size_between(search, below, above), &trial, err);
        if (status != PP_OK)
            return status;
        if (is_near(search, &trial) || reaches(search, &trial))
            *above = trial;
        else
            *below = trial;
    }
    return PP_OK;
}

/* Repeats the bisection on a finer grid until the value is near the target. Values that
 * are counts or sampled are not refined. */
static enum pp_status refine(const struct search *search, struct size_trial *below,
                             struct size_trial *above, struct pp_error *err)
{
    const struct pp_size_task *task = search->task;
    enum pp_status status = PP_OK;
    for (int i = 0; i < REFINED_MOST && status == PP_OK; i++) {
        if (task->by_counts || is_sampled(search, above)
            || task->change == PP_CHANGE_NUMBER
            || above->reading.value <= (1.0 + near_share) * task->target)
            break;
        pp_window_sizes_refine(search->sizes);
        /* A finer grid rounds edges less, so that a window is slightly larger at the
         * same size. `below` may therefore reach the target on the finer grid. */
        above->step *= 10;
        below->step *= 10;
        for (int back = 10;; back *= 10) {
            status = evaluate_size(search, below->step, below, err);
            if (status != PP_OK || !reaches(search, below) || below->step == 0)
                break;
            *above = *below;
            below->step = below->step > back ? below->step - back : 0;
        }
        if (status == PP_OK)
            status = narrow(search, below, above, err);
    }
    return status;
}

/* Index of the first trial that reaches the target or is near it; count if there is
 * none. */
static int first_sufficient(const struct search *search,
                            const struct size_trial *trials, int count)
{
    int first = 0;
    while (first < count && !reaches(search, &trials[first])
           && !is_near(search, &trials[first]))
        first++;
    return first;
}

/* Evaluates the present room, and sizes over the whole range; between the first
 * sufficient size and the largest, none. *count is set to the number of trials, which
 * are sorted by size. */
static enum pp_status scan_range(const struct search *search, struct size_trial *trials,
                                 int *count, struct pp_error *err)
{
    int last = pp_window_sizes_count(search->sizes) - 1;
    int now = pp_window_sizes_now(search->sizes), wanted = SCANNED;
    enum pp_status status = evaluate_size(search, now, &trials[0], err);
    *count = 1;
    if (status != PP_OK || !has_value(&trials[0]))
        return status;
    search->answer->now = trials[0].reading;
    if (is_sampled(search, &trials[0]))
        wanted = SCANNED_SAMPLED;

    for (int i = 0; i < wanted && status == PP_OK; i++) {
        int step = (int)round((double)last * i / (wanted - 1));
        int at = 0, first = first_sufficient(search, trials, *count);
        if (i < wanted - 1 && first < *count && trials[first].step < step)
            continue;
        while (at < *count && trials[at].step < step)
            at++;
        if (at < *count && trials[at].step == step)
            continue;
        for (int k = *count; k > at; k--)
            trials[k] = trials[k - 1];
        ++*count;
        status = evaluate_size(search, step, &trials[at], err);
    }
    return status;
}

/* Searches for the smallest sufficient number of windows. Tries all numbers in
 * ascending order, since there are few. */
static enum pp_status search_numbers(const struct search *search,
                                     struct size_trial *found, struct pp_error *err)
{
    int count = pp_window_sizes_count(search->sizes);
    struct pp_size_answer *answer = search->answer;
    struct size_trial trial = {0};
    enum pp_status status =
        evaluate_size(search, pp_window_sizes_now(search->sizes), &trial, err);
    answer->now = trial.reading;
    *found = trial;
    if (status != PP_OK || !has_value(&trial))
        return status;
    bool first = true;
    for (int step = 0; step < count; step++) {
        status = evaluate_size(search, step, &trial, err);
        if (status != PP_OK)
            return status;
        if (step == 0)
            answer->smallest = trial.reading;
        if (first || trial.reading.value > found->reading.value)
            *found = trial;
        first = false;
        answer->largest = trial.reading;
        if (reaches(search, &trial))
            break;
    }
    answer->verdict = reaches(search, found) ? PP_SIZE_REACHED : PP_SIZE_OUT_OF_REACH;
    return PP_OK;
}

/* Searches for the smallest sufficient size. */
static enum pp_status search_sizes(const struct search *search,
                                   struct size_trial *found, struct pp_error *err)
{
    struct size_trial trials[SCANNED + 1];
    struct pp_size_answer *answer = search->answer;
    int count, best = 0;
    enum pp_status status = scan_range(search, trials, &count, err);
    *found = trials[0];
    if (status != PP_OK || !has_value(found))
        return status;
    answer->smallest = trials[0].reading;
    answer->largest = trials[count - 1].reading;
    for (int i = 0; i < count; i++)
        if (trials[i].reading.value > trials[best].reading.value)
            best = i;
    int first = first_sufficient(search, trials, count);
    answer->verdict = first == count ? PP_SIZE_OUT_OF_REACH
                      : first == 0   ? PP_SIZE_SMALLEST_EXCEEDS
                                     : PP_SIZE_REACHED;
    *found = trials[first == count ? best : first];
    if (answer->verdict != PP_SIZE_REACHED)
        return PP_OK;
    struct size_trial below = trials[first - 1];
    status = narrow(search, &below, found, err);
    if (status == PP_OK)
        status = refine(search, &below, found, err);
    return status;
}

enum pp_status pp_size_find(struct pp_size_answer *answer,
                            const struct pp_size_task *task, struct pp_error *err)
{
    *answer = (struct pp_size_answer){.now = pp_reading_none(NULL),
                                      .smallest = pp_reading_none(NULL),
                                      .largest = pp_reading_none(NULL)};
    struct search search = {.task = task, .answer = answer};
    struct size_trial found = {0};
    enum pp_status status =
        pp_window_sizes_create(&search.sizes, task->room, task->change, task->openings,
                               task->opening_count, err);
    if (status == PP_OK)
        status = task->change == PP_CHANGE_NUMBER ? search_numbers(&search, &found, err)
                                                  : search_sizes(&search, &found, err);
    answer->reading = found.reading;
    if (status == PP_OK && !has_value(&found)) {
        answer->verdict = PP_SIZE_NO_VALUE;
    } else if (status == PP_OK) {
        answer->is_largest = found.step == pp_window_sizes_count(search.sizes) - 1;
        status = pp_window_sizes_room(&answer->room, search.sizes, found.step, err);
        if (status == PP_OK)
            status = pp_window_sizes_room(&answer->largest_room, search.sizes,
                                          pp_window_sizes_count(search.sizes) - 1, err);
    }
    pp_window_sizes_destroy(search.sizes);
    if (status != PP_OK)
        pp_size_answer_clear(answer);
    return status;
}

void pp_size_answer_clear(struct pp_size_answer *answer)
{
    pp_room_destroy(answer->room);
    pp_room_destroy(answer->largest_room);
    answer->room = answer->largest_room = NULL;
}
