/* stream_annual.c - see stream_annual.h.
 *
 * Each pass runs pepperpot annual with more light paths than the pass before. The first
 * pass also has fewer sky patches. Passes end when the standard error of the annual
 * light of every point is at most the requested error, with the requested number of
 * paths, or after the last pass of `passes`. Each event "estimate" contains the results
 * with the illuminances of all hours; the last event, "result", is the JSON output of
 * annual. With the option "format" the endpoint runs the command once instead, and
 * answers with its output.
 */
#include "serve/answers/stream_annual.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "serve/answers/answer_program.h"
#include "serve/answers/asked_room.h"
#include "serve/work/program_words.h"

/* Paths per point and randomisation. From SURE paths on, the standard error of 16
 * randomisations is reliable enough to end the passes (studies/year/annual.c does not
 * end with fewer either). */
static const int passes[] = {2, 16, 128, 512, 2048, 8192};
enum { PASSES = sizeof passes / sizeof *passes, SURE = 128 };

struct annual_stream {
    int pass;
    double error; /* target, per cent */
    int samples;  /* paths of the last pass; 0: by error */
};

/* Reads and removes the options "error" and "samples". If they are invalid, returns
 * false and sets the error answer. */
static bool begin_annual(struct annual_stream *stream, struct pp_task *task)
{
    struct json_object *options = NULL;
    double samples;
    if (!pp_asked_room_number(&stream->error, task, "error", 2.0, 0.1, 100.0)
        || !pp_asked_room_number(&samples, task, "samples", 0.0, 0.0, 65536.0))
        return false;
    stream->samples = (int)samples;
    if (samples != stream->samples || (stream->samples & (stream->samples - 1)) != 0) {
        pp_task_fail(task, MHD_HTTP_BAD_REQUEST,
                     "samples is %g; expected a power of two up to 65536", samples);
        return false;
    }
    if (json_object_object_get_ex(task->body, "options", &options)) {
        json_object_object_del(options, "error");
        json_object_object_del(options, "samples");
    }
    return pp_asked_room_check(task);
}

/* Value or standard error of a figure in an object of the JSON output; NAN: none. */
static double year_part(struct json_object *object, const char *name, const char *part)
{
    struct json_object *figure = NULL, *number = NULL;
    if (!json_object_object_get_ex(object, name, &figure)
        || !json_object_object_get_ex(figure, part, &number) || !number)
        return NAN;
    return json_object_get_double(number);
}

/* Largest relative standard error of the annual light of a point of a room, per
 * cent. */
static double largest_error(struct json_object *annual)
{
    struct json_object *points = NULL;
    double largest = 0.0;
    if (!json_object_object_get_ex(annual, "points", &points))
        return 0.0;
    for (size_t i = 0; i < json_object_array_length(points); i++) {
        struct json_object *point = json_object_array_get_idx(points, i);
        double value = year_part(point, "year-klxh", "value");
        double error = year_part(point, "year-klxh", "se");
        if (value > 0.0 && isfinite(error))
            largest = fmax(largest, 100.0 * error / value);
    }
    return largest;
}

static void send_event(struct pp_task *task, const char *name,
                       struct json_object *object)
{
    const char *text =
        json_object_to_json_string_ext(object, JSON_C_TO_STRING_NOSLASHESCAPE);
    pp_task_event(task, name, text ? text : "{}");
}

/* Sends the results of a pass. Returns true if it is the last pass. */
static bool send_annual(struct annual_stream *stream, struct pp_task *task,
                        struct json_object *annual, int paths)
{
    double error = largest_error(annual), ratio = error / stream->error;
    bool is_last = stream->samples > 0
                       ? paths == stream->samples
                       : (paths >= SURE && ratio <= 1.0) || paths == passes[PASSES - 1];
    double expected = stream->samples > 0
                          ? stream->samples
                          : fmin(passes[PASSES - 1], fmax(SURE, paths * ratio * ratio));
    struct json_object *event = json_object_new_object();
    if (event) {
        json_object_object_add(
            event, "progress",
            json_object_new_double(is_last ? 1.0 : fmin(0.99, paths / expected)));
        json_object_object_add(event, "error", json_object_new_double(error));
        json_object_object_add(event, "paths", json_object_new_int(paths));
        json_object_object_add(event, "annual", json_object_get(annual));
        send_event(task, "estimate", event);
    }
    json_object_put(event);
    if (is_last) {
        json_object_object_del(annual, "hourly");
        send_event(task, "result", annual);
    }
    return is_last;
}

/* Runs one pass. Returns true if the stream is complete. */
static bool run_annual_pass(struct annual_stream *stream, struct pp_task *task,
                            struct pp_program_words *words)
{
    struct json_object *room = NULL, *annual = NULL;
    char samples[12];
    int paths = passes[stream->pass];
    bool is_last = true;
    if (stream->samples > 0 && (paths > stream->samples || stream->pass == PASSES - 1))
        paths = stream->samples;
    snprintf(samples, sizeof samples, "%d", paths);
    pp_program_words_add_option(words, "samples", samples);
    pp_program_words_add_option(words, "hourly", "json");
    if (stream->pass == 0)
        pp_program_words_add_option(words, "patches", "145");
    json_object_object_get_ex(task->body, "room", &room);
    struct pp_child_result result =
        pp_child_run(task, words->list, json_object_get_string(room),
                     (size_t)json_object_get_string_len(room));
    if (result.end == PP_CHILD_DONE && result.status == 0)
        annual = json_tokener_parse(result.output);
    if (json_object_is_type(annual, json_type_array)) { /* of a building: first room */
        struct json_object *list = annual;
        annual = json_object_get(json_object_array_get_idx(list, 0));
        json_object_put(list);
    }
    if (annual)
        is_last = send_annual(stream, task, annual, paths);
    else if (result.end != PP_CHILD_CANCELLED)
        pp_task_fail(task,
                     result.status == 2 ? MHD_HTTP_BAD_REQUEST
                                        : MHD_HTTP_UNPROCESSABLE_CONTENT,
                     "%s", pp_child_sentence(&result));
    json_object_put(annual);
    free(result.output);
    free(result.errors);
    stream->pass++;
    return is_last;
}

bool pp_stream_annual(struct pp_task *task)
{
    struct pp_program_words words = {0};
    struct json_object *format;
    struct annual_stream *stream = task->state;
    if (!stream) {
        if (!pp_asked_room_option(&format, task, "format", json_type_string))
            return true;
        if (format)
            return pp_answer_program(task);
        task->state = stream = calloc(1, sizeof *stream);
        task->free_state = free;
        if (!stream) {
            pp_task_fail(task, MHD_HTTP_INTERNAL_SERVER_ERROR, "out of memory");
            return true;
        }
        if (!begin_annual(stream, task))
            return true;
    }
    bool is_complete =
        !pp_program_words_make(&words, task) || run_annual_pass(stream, task, &words);
    pp_program_words_clear(&words);
    return is_complete;
}
