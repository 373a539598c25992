/* rad_xform.c - see rad_xform.h. */
#include "formats/radiance/read/rad_xform.h"

#include <string.h>

#include "formats/radiance/read/rad_reader.h"
#include "model/base/text.h"

static enum pp_status start_stage(struct pp_rad_xform *xform,
                                  const struct pp_rad_pipe *pipe, char *const *words,
                                  int left, struct pp_error *err)
{
    double number;
    bool array = strcmp(words[0], "-a") == 0;
    if (left < 2 || !pp_text_parse_number(words[1], &number)
        || !(number >= (array ? 1.0 : 0.0)) || !(number <= PP_RAD_COPIES_MOST)
        || number != (int)number)
        return pp_rad_pipe_fail(pipe, err, "expected a whole number after xform's ",
                                words[0]);
    if (xform->stage_count == PP_RAD_XFORM_STAGES_MOST)
        return pp_rad_pipe_fail(pipe, err,
                                "an xform has more than 15 options -i and -a", "");
    xform->stages[xform->stage_count++] =
        (struct pp_rad_xform_stage){pp_rad_transform_identity(), (int)number, array};
    return PP_OK;
}

enum pp_status pp_rad_xform_read(struct pp_rad_xform *xform,
                                 const struct pp_rad_names *names,
                                 const struct pp_rad_pipe *pipe,
                                 const struct pp_rad_command *command,
                                 struct pp_error *err)
{
    *xform = (struct pp_rad_xform){.stages = {{pp_rad_transform_identity(), 1, false}},
                                   .stage_count = 1};
    int i = 1;
    while (i < command->count && command->words[i][0] == '-') {
        char **word = command->words + i;
        int left = command->count - i;
        int taken = pp_rad_transform_read_option(
            &xform->stages[xform->stage_count - 1].transform, word, left);
        if (taken < 0)
            return pp_rad_pipe_fail(pipe, err, "expected valid numbers after xform's ",
                                    *word);
        if (taken > 0) {
            i += taken;
        } else if (strcmp(*word, "-i") == 0 || strcmp(*word, "-a") == 0) {
            enum pp_status status = start_stage(xform, pipe, word, left, err);
            if (status != PP_OK)
                return status;
            i += 2;
        } else if (strcmp(*word, "-I") == 0) {
            xform->inverted = !xform->inverted;
            i++;
        } else if (strcmp(*word, "-e") == 0 || strcmp(*word, "-c") == 0) {
            i++;
        } else if (strcmp(*word, "-n") == 0 && left > 1) {
            i += 2; /* names of shapes are ignored */
        } else if (strcmp(*word, "-m") == 0 && left > 1) {
            if (!pp_rad_names_find(names, word[1], strlen(word[1]), &xform->modifier))
                return pp_rad_pipe_fail(pipe, err, "there is no material ", word[1]);
            xform->replaced = true;
            i += 2;
        } else {
            return pp_rad_pipe_fail(pipe, err, "xform has no option ", *word);
        }
    }
    xform->files = command->words + i;
    xform->file_count = command->count - i;
    return PP_OK;
}

/* Applies a step `times` times, by squaring: a million applications take twenty
 * rounds. */
static struct pp_rad_transform repeated(struct pp_rad_transform step, long times)
{
    struct pp_rad_transform all = pp_rad_transform_identity();
    for (; times > 0; times /= 2) {
        if (times % 2 == 1)
            all = pp_rad_transform_compose(&step, &all);
        step = pp_rad_transform_compose(&step, &step);
    }
    return all;
}

struct pp_rad_transform pp_rad_xform_copy(const struct pp_rad_xform *xform, long index)
{
    int times[PP_RAD_XFORM_STAGES_MOST];
    for (int i = xform->stage_count - 1; i >= 0; i--) {
        const struct pp_rad_xform_stage *stage = &xform->stages[i];
        times[i] = stage->array ? (int)(index % stage->count) : stage->count;
        if (stage->array)
            index /= stage->count;
    }
    struct pp_rad_transform all = pp_rad_transform_identity();
    for (int i = 0; i < xform->stage_count; i++) {
        struct pp_rad_transform stage = repeated(xform->stages[i].transform, times[i]);
        all = pp_rad_transform_compose(&stage, &all);
    }
    return all;
}

double pp_rad_xform_copies(const struct pp_rad_xform *xform)
{
    double copies = 1.0;
    for (int i = 0; i < xform->stage_count; i++)
        copies *= xform->stages[i].array ? xform->stages[i].count : 1;
    return copies;
}

void pp_rad_xform_fold(struct pp_rad_xform *xform)
{
    for (int i = 0; i < xform->stage_count; i++)
        if (!xform->stages[i].array) {
            struct pp_rad_xform_stage *stage = &xform->stages[i];
            stage->transform = repeated(stage->transform, stage->count);
            stage->count = 1;
        }
}
