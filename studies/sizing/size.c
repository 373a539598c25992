/* cmd_size.c - see size.h. */
#include "studies/sizing/size.h"

#include <math.h>

#include "model/room/building.h"

enum {
    SIGHTS = 9,         /* sizes over the whole range, both ends included */
    SIGHTS_SAMPLED = 4, /* of a value that takes long */
    REFINED_MOST = 3,   /* down to a micrometre */
};

/* How near above the target a value that is not counted shall come. */
static const double near_share = 0.0025;

/* How near, in standard errors, one that was sampled shall come. */
static const double near_errors = 0.5;

/* What rounding may have taken from a value that is the target on paper. */
static const double rounding_share = 1e-9;

/* A value at one size. */
struct size_trial {
    int step;
    struct pp_reading reading;
};

struct search {
    const struct pp_size_task *task;
    struct pp_window_sizes *sizes;
    struct pp_size_answer *answer;
};

static enum pp_status world_of(struct pp_world **world, const struct pp_room *room,
                               struct pp_error *err)
{
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, "the changed room");
    enum pp_status status = pp_world_create(world, room, &mistakes, err);
    if (status == PP_BAD_INPUT && mistakes.count > 0)
        pp_fail(err, status, "with another size of window: %s", mistakes.list[0].text);
    pp_mistakes_clear(&mistakes);
    return status;
}

static enum pp_status look(const struct search *search, int step,
                           struct size_trial *sight, struct pp_error *err)
{
    struct pp_room *room = NULL;
    struct pp_world *world = NULL;
    sight->step = step;
    enum pp_status status = pp_window_sizes_room(&room, search->sizes, step, err);
    if (status == PP_OK)
        status = world_of(&world, room, err);
    if (status == PP_OK)
        status = search->task->value(search->task->data, world, &sight->reading, err);
    search->answer->evaluations++;
    pp_world_destroy(world);
    pp_room_destroy(room);
    return status;
}

static bool has_value(const struct size_trial *sight)
{
    return isfinite(sight->reading.value);
}

static bool is_sampled(const struct size_trial *sight)
{
    return isfinite(sight->reading.std_error);
}

static bool reaches(const struct search *search, const struct size_trial *sight)
{
    return sight->reading.value >= (1.0 - rounding_share) * search->task->target;
}

/* Is a sampled value as near to the target as its error lets one tell? */
static bool is_near(const struct search *search, const struct size_trial *sight)
{
    return is_sampled(sight)
           && fabs(sight->reading.value - search->task->target)
                  <= near_errors * sight->reading.std_error;
}

/* The next size to look at between two: the middle, or, of sampled values, where a
 * straight line meets the target, not too near either. */
static int between(const struct search *search, const struct size_trial *below,
                   const struct size_trial *above)
{
    int steps = above->step - below->step;
    double share = 0.5;
    if (is_sampled(above)) {
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

/* Narrows the two down to neighbours, or until one is near; that is then `above`. */
static enum pp_status narrow(const struct search *search, struct size_trial *below,
                             struct size_trial *above, struct pp_error *err)
{
    if (is_near(search, below))
        *above = *below;
    while (above->step - below->step > 1 && !is_near(search, above)) {
        struct size_trial sight = {0};
        enum pp_status status =
            look(search, between(search, below, above), &sight, err);
        if (status != PP_OK)
            return status;
        if (is_near(search, &sight) || reaches(search, &sight))
            *above = sight;
        else
            *below = sight;
    }
    return PP_OK;
}

/* A size that is not counted shall come close: finer steps where these are too coarse.
 */
static enum pp_status refine(const struct search *search, struct size_trial *below,
                             struct size_trial *above, struct pp_error *err)
{
    const struct pp_size_task *task = search->task;
    enum pp_status status = PP_OK;
    for (int i = 0; i < REFINED_MOST && status == PP_OK; i++) {
        if (task->by_counts || is_sampled(above) || task->change == PP_CHANGE_NUMBER
            || above->reading.value <= (1.0 + near_share) * task->target)
            break;
        pp_window_sizes_refine(search->sizes);
        /* Edges on the finer grid stand a little farther out than they did. */
        above->step *= 10;
        below->step *= 10;
        for (int back = 10;; back *= 10) {
            status = look(search, below->step, below, err);
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

/* Sights over the whole range, and of the room as it is, in order. */
static enum pp_status look_over(const struct search *search, struct size_trial *sights,
                                int *count, struct pp_error *err)
{
    int last = pp_window_sizes_count(search->sizes) - 1;
    int now = pp_window_sizes_now(search->sizes), wanted = SIGHTS;
    enum pp_status status = look(search, now, &sights[0], err);
    *count = 1;
    if (status != PP_OK || !has_value(&sights[0]))
        return status;
    search->answer->now = sights[0].reading;
    if (is_sampled(&sights[0]))
        wanted = SIGHTS_SAMPLED;

    for (int i = 0; i < wanted && status == PP_OK; i++) {
        int step = (int)round((double)last * i / (wanted - 1));
        int at = 0;
        while (at < *count && sights[at].step < step)
            at++;
        if (at < *count && sights[at].step == step)
            continue;
        for (int k = *count; k > at; k--)
            sights[k] = sights[k - 1];
        ++*count;
        status = look(search, step, &sights[at], err);
    }
    return status;
}

/* Every number of windows, from the smallest on: there are few. */
static enum pp_status count_up(const struct search *search, struct size_trial *found,
                               struct pp_error *err)
{
    int count = pp_window_sizes_count(search->sizes);
    struct pp_size_answer *answer = search->answer;
    struct size_trial sight = {0};
    enum pp_status status =
        look(search, pp_window_sizes_now(search->sizes), &sight, err);
    answer->now = sight.reading;
    *found = sight;
    if (status != PP_OK || !has_value(&sight))
        return status;
    bool first = true;
    for (int step = 0; step < count; step++) {
        status = look(search, step, &sight, err);
        if (status != PP_OK)
            return status;
        if (step == 0)
            answer->smallest = sight.reading;
        if (first || sight.reading.value > found->reading.value)
            *found = sight;
        first = false;
        answer->largest = sight.reading;
        if (reaches(search, &sight))
            break;
    }
    answer->verdict = reaches(search, found) ? PP_SIZE_REACHED : PP_SIZE_OUT_OF_REACH;
    return PP_OK;
}

static enum pp_status narrow_down(const struct search *search, struct size_trial *found,
                                  struct pp_error *err)
{
    struct size_trial sights[SIGHTS + 1];
    struct pp_size_answer *answer = search->answer;
    int count, first = 0, best = 0;
    enum pp_status status = look_over(search, sights, &count, err);
    *found = sights[0];
    if (status != PP_OK || !has_value(found))
        return status;
    answer->smallest = sights[0].reading;
    answer->largest = sights[count - 1].reading;
    for (int i = 0; i < count; i++)
        if (sights[i].reading.value > sights[best].reading.value)
            best = i;
    while (first < count && !reaches(search, &sights[first])
           && !is_near(search, &sights[first]))
        first++;
    answer->verdict = first == count ? PP_SIZE_OUT_OF_REACH
                      : first == 0   ? PP_SIZE_SMALLEST_EXCEEDS
                                     : PP_SIZE_REACHED;
    *found = sights[first == count ? best : first];
    if (answer->verdict != PP_SIZE_REACHED)
        return PP_OK;
    struct size_trial below = sights[first - 1];
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
        status = task->change == PP_CHANGE_NUMBER ? count_up(&search, &found, err)
                                                  : narrow_down(&search, &found, err);
    answer->reading = found.reading;
    if (status == PP_OK && !has_value(&found)) {
        answer->verdict = PP_SIZE_NO_VALUE;
    } else if (status == PP_OK) {
        answer->is_largest = found.step == pp_window_sizes_count(search.sizes) - 1;
        status = pp_window_sizes_room(&answer->room, search.sizes, found.step, err);
    }
    pp_window_sizes_destroy(search.sizes);
    if (status != PP_OK)
        pp_size_answer_clear(answer);
    return status;
}

void pp_size_answer_clear(struct pp_size_answer *answer)
{
    pp_room_destroy(answer->room);
    answer->room = NULL;
}
