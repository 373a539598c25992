/* run_suite.c - computes the cases of a suite, prints them and reports failures. */
#include "cli/validate/run_suite.h"

#include "cli/job.h"
#include "cli/message.h"
#include "cli/output.h"
#include "cli/terminal.h"
#include "reports/validate/validate_known.h"
#include "reports/validate/validate_page.h"

struct suite_run {
    const struct pp_suite_source *source;
    const struct pp_room_options *options;
    enum pp_format format;
    struct pp_known_result result;
};

static enum pp_status compute_suite(void *data, struct pp_error *err)
{
    struct suite_run *run = data;
    struct pp_known_cases *cases = &run->result.cases;
    enum pp_status status = run->source->find(run->source->data, cases, err);
    return status == PP_OK && !cases->whole ? pp_fail_memory(err) : status;
}

static enum pp_status print_suite(const void *data, FILE *out, struct pp_error *err)
{
    const struct suite_run *run = data;
    if (run->format == PP_FORMAT_JSON)
        return pp_validate_known_json(&run->result, out, err);
    if (run->format == PP_FORMAT_CSV)
        pp_validate_known_csv(&run->result, out);
    else
        pp_validate_known_text(&run->result, pp_terminal_width(run->options->output),
                               out);
    return PP_OK;
}

static bool suite_is_finished(const void *data)
{
    const struct pp_suite_source *source = ((const struct suite_run *)data)->source;
    return !source->is_finished || source->is_finished(source->data);
}

static enum pp_exit write_page(const struct pp_known_result *result, const char *path)
{
    struct pp_error err = {0};
    struct pp_output output;
    enum pp_status status = pp_output_open(&output, path, &err);
    if (status == PP_OK)
        pp_validate_page(result, output.stream);
    status = pp_output_close(&output, status, &err);
    return status == PP_OK ? PP_EXIT_DONE : pp_message_error(&err);
}

/* Reports the number of cases outside their limits, if it exceeds the permitted
 * number. */
static enum pp_exit judge_suite(const struct pp_known_result *result)
{
    struct pp_suite_score score = pp_suite_score(result->suite, &result->cases);
    if (score.passes)
        return PP_EXIT_DONE;
    pp_message("%d of %d answers are outside their limits%s",
               score.wrong + score.traced_wrong, score.count + score.traced,
               result->suite == &pp_suite_quick ? "; do not use this build" : "");
    return result->suite == &pp_suite_quick ? PP_EXIT_MACHINE : PP_EXIT_INPUT;
}

enum pp_exit pp_run_suite(const struct pp_suite_source *source,
                          const struct pp_room_options *options, enum pp_format format,
                          const char *page)
{
    struct suite_run run = {.source = source,
                            .options = options,
                            .format = format,
                            .result = {source->suite, pp_known_case_none()}};
    struct pp_error err = {0};
    if (page && pp_output_try(page, &err) != PP_OK)
        return pp_message_error(&err);
    enum pp_exit result = pp_job_run(&(struct pp_job){
        options->output, compute_suite, print_suite, suite_is_finished, &run});
    if (result == PP_EXIT_DONE && page)
        result = write_page(&run.result, page);
    if (result == PP_EXIT_DONE)
        result = judge_suite(&run.result);
    pp_known_case_clear(&run.result.cases);
    return result;
}

/* ---- suites with their own rooms ---- */

struct known_suite {
    const struct pp_suite *suite;
    const struct pp_study_options *study;
};

static enum pp_status find_known(void *data, struct pp_known_cases *cases,
                                 struct pp_error *err)
{
    const struct known_suite *known = data;
    const struct pp_known_trace how = {.seed = known->study->seed,
                                       .threads = known->study->threads,
                                       .samples = known->suite->samples};
    return known->suite->run(cases, &how, err);
}

enum pp_exit pp_run_suite_known(const struct pp_suite *suite,
                                const struct pp_room_options *options,
                                enum pp_format format, const char *page)
{
    struct known_suite known = {suite, &options->study};
    return pp_run_suite(&(struct pp_suite_source){suite, find_known, NULL, &known},
                        options, format, page);
}
