/* sweep_job.c - see sweep_job.h. */
#include "cli/sweep/sweep_job.h"

#include <stdlib.h>

#include "cli/job.h"
#include "cli/message.h"
#include "reports/sweep/sweep_output.h"

struct sweep_runs {
    const struct pp_sweep_job *job;
    char *list;
    int count;
};

static void *run_at(const struct sweep_runs *runs, int index)
{
    return runs->list + (size_t)index * runs->job->run_bytes;
}

static enum pp_status compute_runs(void *data, struct pp_error *err)
{
    const struct sweep_runs *runs = data;
    enum pp_status status = PP_OK;
    for (int i = 0; i < runs->count && status == PP_OK; i++)
        status = runs->job->compute(run_at(runs, i), err);
    return status;
}

static enum pp_status print_one_run(const void *data, int run, FILE *out,
                                    struct pp_error *err)
{
    const struct sweep_runs *runs = data;
    return runs->job->print(run_at(runs, run), out, err);
}

static enum pp_status print_runs(const void *data, FILE *out, struct pp_error *err)
{
    const struct sweep_runs *runs = data;
    const struct pp_sweep *sweep = &runs->job->room->sweep;
    switch (runs->job->format) {
    case PP_FORMAT_JSON:
        return pp_sweep_output_json(sweep, print_one_run, runs, out, err);
    case PP_FORMAT_CSV:
        return pp_sweep_output_csv(sweep, print_one_run, runs, out, err);
    case PP_FORMAT_TEXT:
        break;
    }
    return runs->job->print_text(runs->list, runs->job->data, out, err);
}

static bool runs_are_finished(const void *data)
{
    const struct sweep_runs *runs = data;
    for (int i = 0; i < runs->count; i++)
        if (!runs->job->is_finished(run_at(runs, i)))
            return false;
    return true;
}

static enum pp_exit load_runs(const struct sweep_runs *runs)
{
    struct pp_error err;
    enum pp_exit exit_status = PP_EXIT_DONE;
    for (int i = 0; i < runs->count && exit_status == PP_EXIT_DONE; i++) {
        if (pp_sweep_choose(&runs->job->room->sweep, i, &err) != PP_OK)
            return pp_message_error(&err);
        exit_status = runs->job->load(run_at(runs, i), runs->job->data);
    }
    return exit_status;
}

enum pp_exit pp_sweep_job_run(const struct pp_sweep_job *job)
{
    struct pp_error err;
    int count = pp_sweep_count(&job->room->sweep);
    struct sweep_runs runs = {job, calloc((size_t)count, job->run_bytes), count};
    if (!runs.list) {
        pp_fail_memory(&err);
        return pp_message_error(&err);
    }
    enum pp_exit exit_status = load_runs(&runs);
    if (exit_status == PP_EXIT_DONE)
        exit_status = pp_job_run(
            &(struct pp_job){job->room->output, compute_runs, print_runs,
                             job->is_finished ? runs_are_finished : NULL, &runs});
    for (int i = 0; i < count; i++)
        job->clear(run_at(&runs, i));
    free(runs.list);
    return exit_status;
}
