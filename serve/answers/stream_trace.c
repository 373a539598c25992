/* stream_trace.c - see stream_trace.h.
 *
 * An event "estimate" with the present values follows each slice of work. The last
 * event, "result", contains the JSON output of df.
 */
#include "serve/answers/stream_trace.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "serve/answers/asked_room.h"

/* Duration of a slice of work (s). After each slice an estimate is sent and the
 * connection is checked. The first slice is shorter, so that the first estimate is
 * early. */
static const double first_slice_s = 0.01, slice_s = 0.04;

struct trace {
    struct pp_asked_room asked;
    bool has_begun;
};

static void free_trace(void *state)
{
    struct trace *trace = state;
    pp_asked_room_clear(&trace->asked);
    free(trace);
}

/* Writes a daylight factor in per cent with 6 digits, far more than its standard error
 * requires. */
static void put_per_cent(FILE *out, double factor)
{
    if (isfinite(factor))
        fprintf(out, "%.6g", 100.0 * factor);
    else
        fputs("null", out);
}

static void put_readings(FILE *out, const struct pp_study *study, int column)
{
    fputs("\"points\": [", out);
    for (int i = -1; i < pp_study_point_count(study); i++) {
        struct pp_reading reading = pp_study_reading(study, column, i);
        fputs(i < 0 ? "" : i == 0 ? "[" : ", [", out);
        if (i < 0)
            continue;
        put_per_cent(out, reading.value);
        fputs(", ", out);
        put_per_cent(out, reading.std_error);
        fputc(']', out);
    }
    struct pp_reading average = pp_study_reading(study, column, -1);
    fputs("], \"average\": [", out);
    put_per_cent(out, average.value);
    fputs(", ", out);
    put_per_cent(out, average.std_error);
    fputc(']', out);
}

static void send_estimate(struct pp_task *task, const struct pp_study *study)
{
    char *text = NULL;
    size_t length;
    int column = pp_study_find(study, PP_DF, "traced");
    FILE *out = open_memstream(&text, &length);
    if (!out)
        return;
    double error = pp_study_error(study);
    fprintf(out, "{ \"progress\": %.4f, \"error\": ", pp_study_progress(study));
    put_per_cent(out, error);
    fputs(", ", out);
    put_readings(out, study, column);
    fputs(" }", out);
    if (fclose(out) == 0)
        pp_task_event(task, "estimate", text);
    free(text);
}

static bool begin_trace(struct trace *trace, struct pp_task *task)
{
    static const char *const names[] = {"error", "samples", "seed", "points",
                                        "sky",   "room",    NULL};
    struct pp_error err = {0};
    double error, samples, seed;
    if (!pp_asked_room_options(task, names)
        || !pp_asked_room_number(&error, task, "error", 1.0, 0.1, 100.0)
        || !pp_asked_room_number(&samples, task, "samples", 0.0, 0.0, 1e6)
        || !pp_asked_room_number(&seed, task, "seed", 1.0, 0.0, 9e15)
        || !pp_asked_room_open(&trace->asked, task))
        return false;
    struct pp_simulation_request request = pp_simulation_request_default();
    request.error = samples > 0.0 ? 0.0 : 0.01 * error;
    request.samples = (long)samples;
    request.seed = (uint64_t)seed;
    if (pp_study_simulate(trace->asked.study, &request, &err) == PP_OK)
        return true;
    pp_task_fail_with(task, &err);
    return false;
}

/* Sends the JSON output of df as the event "result". */
static void send_result(struct pp_task *task, const struct pp_study *study)
{
    char *bytes;
    size_t length;
    struct pp_error err = {0};
    if (pp_study_report(study, PP_FORMAT_JSON, &bytes, &length, &err) != PP_OK) {
        pp_task_fail_with(task, &err);
        return;
    }
    pp_task_event(task, "result", bytes);
    pp_free(bytes);
}

bool pp_stream_trace(struct pp_task *task)
{
    struct trace *trace = task->state;
    struct pp_error err = {0};
    if (!trace) {
        task->state = trace = calloc(1, sizeof *trace);
        task->free_state = free_trace;
        if (!trace) {
            pp_task_fail(task, MHD_HTTP_INTERNAL_SERVER_ERROR, "out of memory");
            return true;
        }
        if (!begin_trace(trace, task))
            return true;
    }
    struct pp_study *study = trace->asked.study;
    if (pp_study_advance(study, trace->has_begun ? slice_s : first_slice_s, &err)
        != PP_OK) {
        pp_task_fail_with(task, &err);
        return true;
    }
    trace->has_begun = true;
    send_estimate(task, study);
    if (!pp_study_done(study))
        return false;
    send_result(task, study);
    return true;
}
