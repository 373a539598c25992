/* size_room.c - chooses method and openings, searches for the size, and lists the edits
 * to the room file. */
#include "studies/sizing/size_room.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "methods/default_methods.h"
#include "methods/evaluate.h"
#include "methods/method.h"
#include "studies/bands/report_bands.h"
#include "studies/room_value.h"
#include "studies/sizing/criterion_margin.h"
#include "studies/study_report.h"

const char *const pp_size_room_change_words[] = {"width", "height", "head",
                                                 "sill",  "number", NULL};

/* Data needed to compute the value of a room. */
struct valuation {
    const struct pp_size_request *request;
    const struct pp_study_room *room;
    struct pp_room_value by_hand;
    bool is_traced;    /* the search uses simulated values */
    int by_hand_count; /* number of values computed by hand in the present search */
};

enum pp_gives pp_size_room_gives(const char *by)
{
    const struct pp_method *method = pp_method_find(by);
    return method ? method->gives : PP_GIVES_WHOLE;
}

/* Simulated reading, at a point or (point -1) the average, of the components that the
 * method gives. The errors of two components are added, since they may be
 * correlated. */
static struct pp_reading traced_at(const struct pp_report *report, enum pp_gives gives,
                                   int point)
{
    static const enum pp_component of[] = {[PP_GIVES_DIRECT] = PP_SC,
                                           [PP_GIVES_INTERNAL] = PP_IRC,
                                           [PP_GIVES_WHOLE] = PP_DF};
    const struct pp_column *column = pp_report_find(report, of[gives], "traced");
    struct pp_reading reading = point < 0 ? column->average : column->points[point];
    if (gives == PP_GIVES_DIRECT) {
        column = pp_report_find(report, PP_ERC, "traced");
        struct pp_reading external =
            point < 0 ? column->average : column->points[point];
        reading.value += external.value;
        reading.std_error += external.std_error;
    }
    return reading;
}

static enum pp_status margin_of(struct valuation *valuation,
                                const struct pp_world *world,
                                const struct pp_study_options *traced,
                                struct pp_reading *reading, struct pp_error *err)
{
    return pp_criterion_margin(reading, valuation->by_hand.why,
                               sizeof valuation->by_hand.why,
                               valuation->request->criterion, valuation->room, world,
                               &valuation->request->grid, traced, err);
}

/* Simulates the average, the lowest value at the points, or the margin of a
 * criterion. */
static enum pp_status trace_sized_room(struct valuation *valuation,
                                       const struct pp_world *world,
                                       struct pp_reading *reading, struct pp_error *err)
{
    if (valuation->request->criterion)
        return margin_of(valuation, world, valuation->request->study, reading, err);
    int points = valuation->by_hand.point_count;
    struct pp_report report = {.world = world,
                               .light = valuation->room->light,
                               .receivers = valuation->by_hand.points,
                               .receiver_count = points,
                               .finished = true};
    bool by_clock = false;
    enum pp_status status =
        pp_study_report_traced(&report, valuation->request->study, &by_clock, err);
    if (status == PP_OK && !report.finished)
        status = pp_fail(err, PP_INTERRUPTED, "interrupted before a size was found");
    if (status == PP_OK) {
        enum pp_gives gives = pp_size_room_gives(valuation->by_hand.method);
        *reading = traced_at(&report, gives, points > 0 ? 0 : -1);
        for (int i = 1; i < points; i++) {
            struct pp_reading other = traced_at(&report, gives, i);
            if (other.value < reading->value)
                *reading = other;
        }
    }
    pp_report_clear(&report);
    return status;
}

static enum pp_status value_by_hand(struct valuation *valuation,
                                    const struct pp_world *world,
                                    struct pp_reading *reading, struct pp_error *err)
{
    return valuation->request->criterion
               ? margin_of(valuation, world, NULL, reading, err)
               : pp_room_value(&valuation->by_hand, world, reading, err);
}

/* Reports progress, since computing the value of a room with diffusing panes can take a
 * second. */
static enum pp_status look_on(struct valuation *valuation, struct pp_error *err)
{
    static const double USUAL_COUNT = 28.0, MOST_SHOWN = 0.95;
    const struct pp_watch *watch = &valuation->request->study->watch;
    double done = fmin(valuation->by_hand_count++ / USUAL_COUNT, MOST_SHOWN);
    return !watch->look || watch->look(watch->data, done, NAN)
               ? PP_OK
               : pp_fail(err, PP_INTERRUPTED, "interrupted before a size was found");
}

static enum pp_status sized_room_value(void *data, const struct pp_world *world,
                                       struct pp_reading *reading, struct pp_error *err)
{
    struct valuation *valuation = data;
    if (valuation->is_traced)
        return trace_sized_room(valuation, world, reading, err);
    enum pp_status status = look_on(valuation, err);
    return status == PP_OK ? value_by_hand(valuation, world, reading, err) : status;
}

/* True if the request allows changes to this opening. */
static bool is_chosen(const struct pp_size_request *request,
                      const struct pp_room_opening *opening, enum pp_opening_kind kind)
{
    if (request->line > 0)
        return opening->line == request->line;
    return opening->kind == kind
           && (!request->wall || strcmp(opening->wall, request->wall) == 0);
}

/* Lists the openings that change: those of the requested line, or else the windows (in
 * the requested wall), or else the rooflights. Fails if there are none. */
static enum pp_status choose_sized_openings(int *openings, int *count,
                                            const struct pp_size_request *request,
                                            const struct pp_room *room,
                                            struct pp_error *err)
{
    int all = pp_room_opening_count(room), windows = 0;
    for (int i = 0; i < all; i++)
        windows += pp_room_opening_at(room, i).kind == PP_WINDOW;
    enum pp_opening_kind kind = windows > 0 || request->wall ? PP_WINDOW : PP_ROOFLIGHT;
    *count = 0;
    for (int i = 0; i < all; i++) {
        struct pp_room_opening opening = pp_room_opening_at(room, i);
        if (is_chosen(request, &opening, kind))
            openings[(*count)++] = i;
    }
    if (*count > 0)
        return PP_OK;
    if (request->line > 0)
        return pp_fail(err, PP_BAD_INPUT, "there is no window on line %ld",
                       request->line);
    if (request->wall)
        return pp_fail(err, PP_BAD_INPUT, "there is no window in the wall \"%.200s\"",
                       request->wall);
    return pp_fail(
        err, PP_BAD_INPUT,
        "there is no window or rooflight to change%s; expected a window or rooflight "
        "of any size to start from",
        all > 0 ? ", because openings given by their corners keep their shape" : "");
}

static bool is_by_counts(const char *by)
{
    char name[64];
    snprintf(name, sizeof name, "%.*s", (int)strcspn(by, "+"), by);
    const struct pp_method *direct = pp_method_find(name);
    const char *plus = strchr(by, '+');
    const struct pp_method *internal = plus ? pp_method_find(plus + 1) : NULL;
    return (direct && direct->counts) || (internal && internal->counts);
}

/* ---- changes of the openings ---- */

static bool same_opening_place(struct pp_opening_place a, struct pp_opening_place b)
{
    return a.left_m == b.left_m && a.width_m == b.width_m && a.sill_m == b.sill_m
           && a.height_m == b.height_m;
}

/* Lists the differences between the openings of the sized room and the present room.
 * openings: indices of the openings that could change. */
static enum pp_status set_down_edits(struct pp_size_room_result *result,
                                     const int *openings, int count,
                                     struct pp_error *err)
{
    const struct pp_room *before = result->room->room, *after = result->answer.room;
    int was = pp_room_opening_count(before), is = pp_room_opening_count(after);
    int kept = is < was ? count - (was - is) : count, added = is > was ? is - was : 0;
    result->edits = calloc((size_t)(count + added), sizeof *result->edits);
    if (!result->edits)
        return pp_fail_memory(err);
    for (int i = 0; i < count; i++) {
        struct pp_text_edit edit = {.kind = PP_TEXT_REMOVE, .opening = openings[i]};
        if (i < kept) {
            edit.kind = PP_TEXT_SET;
            edit.place = pp_room_opening_at(after, openings[i]).place;
            if (same_opening_place(edit.place,
                                   pp_room_opening_at(before, openings[i]).place))
                continue;
        }
        result->edits[result->edit_count++] = edit;
    }
    for (int i = 0; i < added; i++)
        result->edits[result->edit_count++] = (struct pp_text_edit){
            PP_TEXT_ADD, openings[count - 1], pp_room_opening_at(after, was + i).place};
    return PP_OK;
}

/* Stores a pointer to the text of the room's file. */
static void find_text(struct pp_size_room_result *result)
{
    struct pp_building *building = result->room->building;
    result->file_text = pp_building_text(building, &result->file_length);
    result->file_opening = pp_building_openings_before(building, result->room->index);
}

/* ---- the room ---- */

/* Determines whether the method's average for the present room is reliable. */
static enum pp_status find_reliability(struct pp_size_room_result *result,
                                       const struct valuation *valuation,
                                       struct pp_error *err)
{
    struct pp_report report = {.world = valuation->room->world,
                               .light = valuation->room->light,
                               .finished = true,
                               .threads = valuation->request->study->threads};
    enum pp_status status =
        pp_methods_evaluate(&report, valuation->by_hand.method, err);
    if (status == PP_OK)
        result->reliability = pp_reliability_of(&report);
    pp_report_clear(&report);
    return status;
}

/* Band of a daylight factor in the report: of the average, or of the lowest value at
 * the points. */
static struct pp_band_ends band_in(const struct pp_report *report, const char *method)
{
    const struct pp_column *column = pp_report_find(report, PP_DF, method);
    int lowest = 0;
    if (!column || report->receiver_count == 0)
        return column ? column->average_band : pp_band_none();
    for (int i = 1; column->points && i < report->receiver_count; i++)
        if (column->points[i].value < column->points[lowest].value)
            lowest = i;
    return column->bands ? column->bands[lowest] : pp_band_none();
}

static enum pp_status find_band(struct pp_size_room_result *result,
                                const struct valuation *valuation, struct pp_error *err)
{
    struct pp_world *world = NULL;
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, "the sized room");
    enum pp_status status =
        pp_world_create(&world, result->answer.room, &mistakes, err);
    struct pp_report report = {.world = world,
                               .light = valuation->room->light,
                               .receivers = valuation->by_hand.points,
                               .receiver_count = valuation->by_hand.point_count,
                               .finished = true,
                               .threads = valuation->request->study->threads};
    if (status == PP_OK)
        status = pp_methods_evaluate(&report, valuation->by_hand.method, err);
    if (status == PP_OK)
        status = pp_report_bands_fill(&report, err);
    if (status == PP_OK)
        result->band = band_in(&report, valuation->by_hand.method);
    pp_report_clear(&report);
    pp_world_destroy(world);
    pp_mistakes_clear(&mistakes);
    return status;
}

/* Chooses the requested method, or else the default pair for the room. */
static void choose_method(struct valuation *valuation)
{
    struct pp_room_value *by_hand = &valuation->by_hand;
    by_hand->light = &valuation->room->light;
    by_hand->method = valuation->request->by;
    if (!by_hand->method)
        by_hand->method =
            pp_default_methods(valuation->room->world, &valuation->room->light,
                               by_hand->points, by_hand->point_count)
                .name;
}

/* Simulates the room. If by_hand is not NULL, also computes its value by hand. */
static enum pp_status trace_room(struct pp_reading *reading, struct pp_reading *by_hand,
                                 const struct pp_room *room,
                                 struct valuation *valuation, struct pp_error *err)
{
    struct pp_world *world = NULL;
    struct pp_mistakes mistakes;
    pp_mistakes_init(&mistakes, "the sized room");
    enum pp_status status = pp_world_create(&world, room, &mistakes, err);
    if (status == PP_OK)
        status = trace_sized_room(valuation, world, reading, err);
    if (status == PP_OK && by_hand)
        status = value_by_hand(valuation, world, by_hand, err);
    pp_world_destroy(world);
    pp_mistakes_clear(&mistakes);
    return status;
}

/* True if the value is below the target by more than two standard errors. */
static bool falls_short(const struct pp_reading *traced, double target)
{
    double noise = traced->std_error > 0.0 ? 2.0 * traced->std_error : 0.0;
    return traced->value + noise < target;
}

static enum pp_status find_size(struct pp_size_answer *answer,
                                const struct pp_size_task *task,
                                struct valuation *valuation, struct pp_error *err)
{
    const struct pp_watch *watch = &valuation->request->study->watch;
    bool shown =
        !valuation->is_traced && pp_watch_begin(watch, valuation->room->world->name);
    valuation->by_hand_count = 0;
    enum pp_status status = pp_size_find(answer, task, err);
    pp_watch_end(watch, shown);
    return status;
}

/* Repeats the search with simulated values, after simulation did not confirm a result
 * by hand. */
static enum pp_status search_traced(struct pp_size_room_result *result,
                                    struct pp_size_task *task,
                                    struct valuation *valuation, struct pp_error *err)
{
    valuation->is_traced = true;
    task->sampled = true;
    pp_size_answer_clear(&result->answer);
    enum pp_status status = find_size(&result->answer, task, valuation, err);
    if (status == PP_OK)
        result->traced = result->answer.reading;
    return status;
}

/* Searches again by hand with a corrected target: the margin by hand of the last size
 * over its simulated margin, plus 0.5 %. Ends when the simulated margin exceeds the
 * requirement by at most 2 % or, after some tries, by any amount. If this fails,
 * searches by simulation only. */
static enum pp_status repeat_until_it_holds(struct pp_size_room_result *result,
                                            struct pp_size_task *task,
                                            struct valuation *valuation,
                                            struct pp_error *err)
{
    enum { TRIES = 6, PATIENCE = 3 };
    static const double near = 1.02, beyond = 1.005;
    struct pp_size_answer *answer = &result->answer;
    for (int i = 0; i < TRIES; i++) {
        double traced = result->traced.value;
        bool met = traced >= 1.0;
        if (met && answer->verdict == PP_SIZE_OUT_OF_REACH)
            answer->verdict = PP_SIZE_REACHED;
        if (met
            && (i >= PATIENCE || traced <= near
                || answer->verdict == PP_SIZE_SMALLEST_EXCEEDS))
            return PP_OK;
        if (!met && (answer->verdict == PP_SIZE_OUT_OF_REACH || !(traced > 0.0)))
            break;
        task->target = answer->reading.value / traced * beyond;
        pp_size_answer_clear(answer);
        enum pp_status status = find_size(answer, task, valuation, err);
        if (status == PP_OK && answer->room)
            status = trace_room(&result->traced, NULL, answer->room, valuation, err);
        if (status != PP_OK || !answer->room)
            return status;
    }
    task->target = 1.0;
    return result->traced.value >= 1.0 ? PP_OK
                                       : search_traced(result, task, valuation, err);
}

/* Checks a result by simulation. If it is not confirmed, the largest size is also
 * simulated. If the largest size misses the target, the target is out of reach, and the
 * largest size becomes the result. For a criterion the search is repeated instead,
 * until the result is confirmed. */
static enum pp_status check_by_simulation(struct pp_size_room_result *result,
                                          struct pp_size_task *task,
                                          struct valuation *valuation,
                                          struct pp_error *err)
{
    struct pp_size_answer *answer = &result->answer;
    double target = valuation->request->target;
    enum pp_status status =
        trace_room(&result->traced, NULL, answer->room, valuation, err);
    if (status == PP_OK && valuation->request->criterion
        && isfinite(result->traced.value))
        return repeat_until_it_holds(result, task, valuation, err);
    if (status != PP_OK || answer->verdict == PP_SIZE_OUT_OF_REACH)
        return status;
    result->holds = !falls_short(&result->traced, target);
    if (result->holds)
        return PP_OK;
    struct pp_reading most = result->traced, by_hand = answer->reading;
    if (!answer->is_largest)
        status = trace_room(&most, &by_hand, answer->largest_room, valuation, err);
    if (status != PP_OK || !falls_short(&most, target))
        return status;
    struct pp_room *largest = answer->largest_room;
    answer->largest_room = answer->room;
    answer->room = largest;
    answer->verdict = PP_SIZE_OUT_OF_REACH;
    answer->is_largest = true;
    answer->reading = by_hand;
    result->traced = most;
    return PP_OK;
}

enum pp_status pp_size_room(struct pp_size_room_result *result,
                            const struct pp_study_room *room,
                            const struct pp_size_request *request, struct pp_error *err)
{
    bool points = request->study->points.count > 0;
    struct valuation valuation = {
        .request = request,
        .room = room,
        .is_traced = request->traced,
        .by_hand = {.points = points ? room->receivers : NULL,
                    .point_count = points ? room->receiver_count : 0,
                    .threads = request->study->threads}};
    *result = (struct pp_size_room_result){.room = room,
                                           .traced = pp_reading_none(NULL),
                                           .holds = true,
                                           .band = pp_band_none()};
    find_text(result);
    int all = pp_room_opening_count(room->room);
    int *openings = malloc(((size_t)all + 1) * sizeof *openings);
    if (!openings)
        return pp_fail_memory(err);
    struct pp_size_task task = {.room = room->room,
                                .change = request->change,
                                .openings = openings,
                                .target = request->target,
                                .sampled = request->criterion && request->traced,
                                .value = sized_room_value,
                                .data = &valuation};
    bool by_method = !request->criterion;
    if (by_method) {
        choose_method(&valuation);
        result->method = valuation.by_hand.method;
        task.by_counts = is_by_counts(result->method);
    }
    enum pp_status status =
        choose_sized_openings(openings, &task.opening_count, request, room->room, err);
    if (status == PP_OK && by_method && !request->traced)
        status = find_reliability(result, &valuation, err);
    if (status == PP_OK)
        status = find_size(&result->answer, &task, &valuation, err);
    if (status == PP_OK && request->study->simulate && !request->traced
        && result->answer.room)
        status = check_by_simulation(result, &task, &valuation, err);
    if (status == PP_OK && result->answer.room && by_method && !request->traced)
        status = find_band(result, &valuation, err);
    if (status == PP_OK && result->answer.room)
        status = set_down_edits(result, openings, task.opening_count, err);
    free(openings);
    if (status == PP_OK && result->answer.verdict == PP_SIZE_NO_VALUE) {
        snprintf(result->text, sizeof result->text, "%s", valuation.by_hand.why);
        result->why = result->text;
    }
    return status;
}

void pp_size_room_result_refuse(struct pp_size_room_result *result, const char *why)
{
    pp_size_room_result_clear(result);
    result->answer = (struct pp_size_answer){.verdict = PP_SIZE_NO_VALUE,
                                             .now = pp_reading_none(NULL),
                                             .reading = pp_reading_none(NULL)};
    result->band = pp_band_none();
    result->edits = NULL;
    result->edit_count = 0;
    snprintf(result->text, sizeof result->text, "%s", why);
    result->why = result->text;
}

void pp_size_room_result_clear(struct pp_size_room_result *result)
{
    pp_size_answer_clear(&result->answer);
    free(result->edits);
}
