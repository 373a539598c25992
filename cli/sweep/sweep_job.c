/* sweep_job.c - see sweep_job.h. */
#include "cli/sweep/sweep_job.h"

#include "cli/job.h"
#include "cli/message.h"
#include "reports/sweep/sweep_output.h"

static enum pp_status compute_runs(void *data, struct pp_error *err)
{
    const struct pp_sweep_job *job = *(const struct pp_sweep_job **)data;
    enum pp_status status = PP_OK;
    for (int i = 0; i < pp_sweep_count(&job->room->sweep) && status == PP_OK; i++)
        status = job->compute(job->data, i, err);
    return status;
}

static enum pp_status print_runs(const void *data, FILE *out, struct pp_error *err)
{
    const struct pp_sweep_job *job = *(const struct pp_sweep_job *const *)data;
    switch (job->format) {
    case PP_FORMAT_JSON:
        return pp_sweep_output_json(&job->room->sweep, job->print, job->data, out, err);
    case PP_FORMAT_CSV:
        return pp_sweep_output_csv(&job->room->sweep, job->print, job->data, out, err);
    case PP_FORMAT_TEXT:
        break;
    }
    return job->print_text(job->data, out, err);
}

static bool runs_are_finished(const void *data)
{
    const struct pp_sweep_job *job = *(const struct pp_sweep_job *const *)data;
    for (int i = 0; i < pp_sweep_count(&job->room->sweep); i++)
        if (!job->is_finished(job->data, i))
            return false;
    return true;
}

enum pp_exit pp_sweep_job_run(const struct pp_sweep_job *job)
{
    struct pp_error err;
    for (int i = 0; i < pp_sweep_count(&job->room->sweep); i++) {
        if (pp_sweep_choose(&job->room->sweep, i, &err) != PP_OK)
            return pp_message_error(&err);
        enum pp_exit exit_status = job->load(job->data, i);
        if (exit_status != PP_EXIT_DONE)
            return exit_status;
    }
    return pp_job_run(&(struct pp_job){job->room->output, compute_runs, print_runs,
                                       job->is_finished ? runs_are_finished : NULL,
                                       &job});
}
