/* study_vectors.c - implementation of pepperpot.h: geometry and contours of a study,
 * for programs that draw them. */
#include <stdio.h>
#include <stdlib.h>

#include "api/study.h"
#include "reports/vectors/plan_json.h"
#include "reports/vectors/scene_json.h"
#include "studies/plan_study.h"

/* Closes the stream. After a failure, its bytes are discarded. */
static enum pp_status finish_vectors(FILE *out, enum pp_status status, char **bytes,
                                     size_t *length, struct pp_error *err)
{
    if (fclose(out) != 0 && status == PP_OK)
        status = pp_fail_memory(err);
    if (status != PP_OK) {
        free(*bytes);
        *bytes = NULL;
        *length = 0;
    }
    return status;
}

enum pp_status pp_study_scene(const struct pp_study *study, char **bytes,
                              size_t *length, struct pp_error *err)
{
    *bytes = NULL;
    *length = 0;
    FILE *out = open_memstream(bytes, length);
    if (!out)
        return pp_fail_memory(err);
    return finish_vectors(out,
                          pp_scene_json(study->room.world, study->room.receivers,
                                        study->room.receiver_count, out, err),
                          bytes, length, err);
}

void pp_study_plan_without_average(struct pp_study *study, bool without)
{
    study->has_plan_without_average = without;
}

enum pp_status pp_study_plan(const struct pp_study *study, const char *methods,
                             double tolerance, char **bytes, size_t *length,
                             struct pp_error *err)
{
    struct pp_study_options options = PP_STUDY_OPTIONS_NONE;
    struct pp_plan_study plan;
    *bytes = NULL;
    *length = 0;
    options.methods = methods;
    options.method_options.stop = study->options.method_options.stop;
    options.method_options.points_only = study->has_plan_without_average;
    if (!(tolerance > 0.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "the tolerance is %g m; expected a length above 0", tolerance);
    enum pp_status status =
        pp_plan_study_sketch(&plan, &study->room, &options, tolerance, err);
    if (status != PP_OK)
        return status;
    FILE *out = open_memstream(bytes, length);
    status =
        out ? finish_vectors(out, pp_plan_json(&plan, out, err), bytes, length, err)
            : pp_fail_memory(err);
    pp_plan_study_clear(&plan);
    return status;
}
