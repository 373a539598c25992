/* study_judge.c - implementation of pepperpot.h: assesses a study by criteria, and
 * sizes its windows. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "api/study.h"
#include "model/room/text/room_text.h"
#include "studies/sizing/size_room.h"

/* Copies the simulated daylight factors of the study's grid into the report of the
 * assessment. */
static enum pp_status take_simulated(struct pp_report *to, const struct pp_report *from,
                                     struct pp_error *err)
{
    for (int component = PP_SC; component < PP_COMPONENT_COUNT; component++) {
        const struct pp_column *column = pp_report_find(from, component, "traced");
        if (!column)
            return PP_OK;
        struct pp_column *copy = pp_report_add(to, component, "traced", true);
        if (!copy)
            return pp_fail_memory(err);
        copy->average = column->average;
        for (int i = 0; i < to->receiver_count; i++)
            copy->points[i] = column->points[i];
    }
    return PP_OK;
}

enum pp_status pp_study_judge(struct pp_study *study, const char *criteria,
                              double median_diffuse_lux, struct pp_error *err)
{
    const struct pp_assess_options options = {.study = &study->options,
                                              .criteria = criteria,
                                              .grid = study->grid,
                                              .median_lux = median_diffuse_lux};
    struct pp_assessment *assessment = &study->assessment;
    if (study->has_assessment)
        pp_assessment_clear(assessment);
    enum pp_status status =
        pp_assessment_begin(assessment, &study->room, 1, NULL, &options, err);
    study->has_assessment = true;
    if (status == PP_OK && study->grid.spacing_m > 0.0 && assessment->has_factors)
        status = take_simulated(&assessment->report, &study->report, err);
    return status == PP_OK ? pp_assessment_judge(assessment, &options, err) : status;
}

int pp_study_judgement_count(const struct pp_study *study)
{
    int count = 0;
    for (int i = 0; study->has_assessment && i < study->assessment.answers.count; i++)
        count += study->assessment.answers.list[i].findings.count;
    return count;
}

struct pp_judgement pp_study_judgement(const struct pp_study *study, int index)
{
    const struct pp_answer *answer = study->assessment.answers.list;
    for (; index >= answer->findings.count; answer++)
        index -= answer->findings.count;
    const struct pp_finding *finding = &answer->findings.list[index];
    return (struct pp_judgement){.criterion = answer->criterion->name,
                                 .what = finding->what,
                                 .figure = finding->figure,
                                 .std_error = finding->std_error,
                                 .wanted = finding->wanted,
                                 .at_most = finding->at_most,
                                 .verdict = finding->verdict,
                                 .confidence = finding->confidence,
                                 .basis = answer->findings.basis,
                                 .note = finding->note};
}

/* Makes the text of the room file with the windows that were found. The caller frees
 * *file. */
static enum pp_status write_sized_room_text(char **file,
                                            struct pp_size_room_result *result,
                                            struct pp_error *err)
{
    size_t length;
    for (int i = 0; i < result->edit_count; i++)
        result->edits[i].opening += result->file_opening;
    return pp_room_text_edit(file, &length, result->file_text, result->file_length,
                             result->edits, result->edit_count, err);
}

enum pp_status pp_study_size(const struct pp_study *study, double target,
                             enum pp_size_change change, const char *method,
                             struct pp_size_found *found, char **file,
                             struct pp_error *err)
{
    *found = (struct pp_size_found){.now = NAN, .value = NAN};
    if (file)
        *file = NULL;
    if (!(target > 0.0 && target <= 1.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "the target is %g; expected a fraction above 0 and up to 1",
                       target);
    struct pp_study_options options = PP_STUDY_OPTIONS_NONE;
    const struct pp_size_request request = {
        .study = &options, .target = target, .by = method, .change = change};
    struct pp_size_room_result result;
    enum pp_status status = pp_size_room(&result, &study->room, &request, err);
    if (status == PP_OK) {
        found->verdict = result.answer.verdict;
        found->now = result.answer.now.value;
        found->value = result.answer.reading.value;
        snprintf(found->method, sizeof found->method, "%s", result.method);
        snprintf(found->why, sizeof found->why, "%s", result.why ? result.why : "");
        if (file && found->verdict == PP_SIZE_REACHED)
            status = write_sized_room_text(file, &result, err);
    }
    pp_size_room_result_clear(&result);
    return status;
}
