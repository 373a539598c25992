/* job.c - see job.h. */
#include "cli/job.h"

#include "cli/message.h"
#include "cli/output.h"

enum pp_exit pp_job_run(const struct pp_job *job)
{
    struct pp_error err = {0};
    struct pp_output output;
    enum pp_status status = pp_output_open(&output, job->output, &err);
    if (status == PP_OK)
        status = job->compute(job->data, &err);
    if (status == PP_OK)
        status = job->print(job->data, output.stream, &err);
    status = pp_output_close(&output, status, &err);
    if (status != PP_OK)
        return pp_message_error(&err);
    return job->is_finished && !job->is_finished(job->data) ? pp_message_unfinished()
                                                            : PP_EXIT_DONE;
}
