/* rad_command.c - lines that begin with "!": worked out here, never executed.
 *
 * A line is one command or several piped together, "genbox ... | xform ...". The last
 * is evaluated; an xform without a file has what stands before it evaluated, once for
 * each copy that it makes, with its transform on the way.
 */
#include <stdlib.h>
#include <string.h>

#include "model/base/text.h"
#include "formats/radiance/rad_gensky.h"
#include "formats/radiance/rad_reader.h"

enum { WORDS_MOST = 1000, COMMANDS_MOST = 100, ARRAYS_MOST = 16 };

/* One command of a line. */
struct piped_command {
    char **words;
    int count;
};

struct piped_line {
    const struct pp_rad_words *words; /* where it stands */
    int number;
    char *list[WORDS_MOST];
    struct piped_command commands[COMMANDS_MOST];
    int command_count;
};

static enum pp_status fail(const struct piped_line *line, struct pp_error *err,
                           const char *what, const char *word)
{
    return pp_rad_words_fail(line->words, line->number, err, "%s%.60s", what, word);
}

/* A pipe, or the end of the line, ends the command of the words from `begin` on. */
static enum pp_status end_command(struct piped_line *line, int begin, int count,
                                  struct pp_error *err)
{
    if (count == begin)
        return fail(line, err, "expected a command: gensky, genbox or xform", "");
    if (line->command_count == COMMANDS_MOST)
        return fail(line, err, "more than 100 commands in one line", "");
    line->commands[line->command_count++] =
        (struct piped_command){line->list + begin, count - begin};
    return PP_OK;
}

/* Splits text, which it changes, at blanks and pipes; words may stand in quotes. What a
 * shell would do more than that is refused. */
static enum pp_status split(struct piped_line *line, char *text, struct pp_error *err)
{
    int count = 0, begin = 0;
    for (char *at = text;;) {
        at += strspn(at, " ");
        bool ended = *at == '\0';
        if (ended || *at == '|') {
            enum pp_status status = end_command(line, begin, count, err);
            if (ended || status != PP_OK)
                return status;
            begin = count;
            *at++ = '\0'; /* of the word right before it too */
            continue;
        }
        if (count == WORDS_MOST)
            return fail(line, err, "a command of more than 1000 words", "");
        char quote = *at == '\'' || *at == '"' ? *at++ : '\0';
        line->list[count++] = at;
        at += quote ? strcspn(at, (char[]){quote, '\0'})
                    : strcspn(at, " |'\"`$;&<>()*?\\");
        if (quote && *at == '\0')
            return fail(line, err,
                        "a quote that is not closed: ", line->list[count - 1]);
        if (quote)
            *at++ = '\0';
        if (!strchr(" |", *at)) /* which has the end among them */
            return fail(line, err,
                        "expected words with blanks between, or in quotes; not ", at);
        if (*at == ' ')
            *at++ = '\0';
    }
}

static enum pp_status run(struct pp_rad_reader *reader, const struct piped_line *line,
                          int which, const struct pp_rad_context *way,
                          struct pp_error *err);

/* ---- xform ---- */

/* The options between one -i or -a and the next. */
struct xform_stage {
    struct pp_rad_transform transform;
    int count;  /* how often it is applied */
    bool array; /* ... or 0 to count - 1 times, a copy each */
};

struct xform {
    struct xform_stage stages[ARRAYS_MOST];
    int stage_count;
    bool inverted, replaced;
    struct pp_rad_meaning modifier;
    char **files;
    int file_count;
};

static enum pp_status start_stage(struct xform *xform, const struct piped_line *line,
                                  char *const *words, int left, struct pp_error *err)
{
    double number;
    bool array = strcmp(words[0], "-a") == 0;
    if (left < 2 || !pp_text_parse_number(words[1], &number)
        || !(number >= (array ? 1.0 : 0.0)) || !(number <= PP_RAD_COPIES_MOST)
        || number != (int)number)
        return fail(line, err, "expected a whole number behind xform's ", words[0]);
    if (xform->stage_count == ARRAYS_MOST)
        return fail(line, err, "more than 15 of -i and -a in one xform", "");
    xform->stages[xform->stage_count++] =
        (struct xform_stage){pp_rad_transform_identity(), (int)number, array};
    return PP_OK;
}

static enum pp_status read_xform(struct xform *xform,
                                 const struct pp_rad_reader *reader,
                                 const struct piped_line *line,
                                 const struct piped_command *command,
                                 struct pp_error *err)
{
    *xform = (struct xform){.stages = {{pp_rad_transform_identity(), 1, false}},
                            .stage_count = 1};
    int i = 1;
    while (i < command->count && command->words[i][0] == '-') {
        char **word = command->words + i;
        int left = command->count - i;
        int taken = pp_rad_transform_read_option(
            &xform->stages[xform->stage_count - 1].transform, word, left);
        if (taken < 0)
            return fail(line, err, "no good numbers behind xform's ", *word);
        if (taken > 0) {
            i += taken;
        } else if (strcmp(*word, "-i") == 0 || strcmp(*word, "-a") == 0) {
            enum pp_status status = start_stage(xform, line, word, left, err);
            if (status != PP_OK)
                return status;
            i += 2;
        } else if (strcmp(*word, "-I") == 0) {
            xform->inverted = !xform->inverted;
            i++;
        } else if (strcmp(*word, "-e") == 0 || strcmp(*word, "-c") == 0) {
            i++;
        } else if (strcmp(*word, "-n") == 0 && left > 1) {
            i += 2; /* names of shapes play no part */
        } else if (strcmp(*word, "-m") == 0 && left > 1) {
            if (!pp_rad_names_find(&reader->names, word[1], strlen(word[1]),
                                   &xform->modifier))
                return fail(line, err, "there is no material ", word[1]);
            xform->replaced = true;
            i += 2;
        } else {
            return fail(line, err, "xform has no option ", *word);
        }
    }
    xform->files = command->words + i;
    xform->file_count = command->count - i;
    return PP_OK;
}

/* The same so many times over: by squares, so that a million are twenty. */
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

/* The transform of copy `index`, the last array running fastest. */
static struct pp_rad_transform copy_of(const struct xform *xform, long index)
{
    int times[ARRAYS_MOST];
    for (int i = xform->stage_count - 1; i >= 0; i--) {
        const struct xform_stage *stage = &xform->stages[i];
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

static enum pp_status run_xform(struct pp_rad_reader *reader,
                                const struct piped_line *line, int which,
                                const struct pp_rad_context *way, struct pp_error *err)
{
    struct xform xform;
    enum pp_status status =
        read_xform(&xform, reader, line, &line->commands[which], err);
    if (status != PP_OK)
        return status;
    if (xform.file_count == 0 && which == 0)
        return fail(line, err, "xform has nothing to transform; expected a file", "");
    double copies = 1.0;
    for (int i = 0; i < xform.stage_count; i++)
        copies *= xform.stages[i].array ? xform.stages[i].count : 1;
    if (copies > (double)(PP_RAD_COPIES_MOST - reader->copies))
        return pp_rad_words_fail(
            line->words, line->number, err,
            "more than %d copies, by this xform and those before it",
            PP_RAD_COPIES_MOST);
    reader->copies += (long)copies;
    for (int i = 0; i < xform.stage_count; i++)
        if (!xform.stages[i].array) {
            struct xform_stage *stage = &xform.stages[i];
            stage->transform = repeated(stage->transform, stage->count);
            stage->count = 1;
        }
    for (long copy = 0; copy < (long)copies && status == PP_OK; copy++) {
        struct pp_rad_transform own = copy_of(&xform, copy);
        struct pp_rad_context next = *way;
        next.transform = pp_rad_transform_compose(&way->transform, &own);
        if (!isfinite(pp_vec_length(next.transform.move))
            || !(next.transform.scale > 1e-12) || !(next.transform.scale < 1e12))
            return fail(line, err, "copies that leave all bounds", "");
        next.inverted = way->inverted != xform.inverted;
        if (!way->replaced && xform.replaced) {
            next.replaced = true;
            next.modifier = xform.modifier;
        }
        for (int i = 0; i < xform.file_count && status == PP_OK; i++) {
            next.depth = way->depth + 1;
            if (next.depth > PP_RAD_DEPTH_MOST)
                return fail(line, err,
                            "files within files within files: does one name itself? ",
                            xform.files[i]);
            status = pp_rad_read_file(reader, xform.files[i], &next, err);
            if (status == PP_OK && reader->bytes > PP_RAD_BYTES_MOST)
                return fail(line, err,
                            "more than 4 GiB of files are read, by this xform and "
                            "those before it",
                            "");
        }
        if (xform.file_count == 0)
            status = run(reader, line, which - 1, &next, err);
    }
    return status;
}

/* ---- gensky ---- */

static bool define(struct pp_rad_reader *reader, const char *name,
                   enum pp_rad_kind kind, int index)
{
    return pp_rad_names_define(&reader->names, name, strlen(name),
                               (struct pp_rad_meaning){kind, index, -1});
}

/* "solar" and its source, and "skyfunc". */
static enum pp_status run_gensky(struct pp_rad_reader *reader,
                                 const struct piped_line *line,
                                 const struct piped_command *command,
                                 const struct pp_rad_context *way, struct pp_error *err)
{
    struct pp_gensky sky;
    char wrong[200];
    if (!pp_rad_gensky_evaluate(&sky, command->words, command->count, wrong,
                                sizeof wrong))
        return fail(line, err, "", wrong);
    struct pp_vec3 up =
        pp_rad_transform_direction(&way->transform, pp_vec(0.0, 0.0, 1.0));
    if (!(up.z > 1.0 - 1e-9))
        return fail(line, err,
                    "a sky that is tilted; expected it turned about the "
                    "vertical at most",
                    "");
    struct pp_vec3 sun = sky.pattern.sun;
    sky.pattern.sun = pp_rad_transform_direction(&way->transform, sun);
    int index;
    enum pp_status status =
        pp_rad_materials_check_count(reader, line->words, line->number, err);
    if (status == PP_OK)
        status =
            pp_scene_description_add_pattern(reader->scene, &sky.pattern, &index, err);
    if (status != PP_OK)
        return status;
    if (!define(reader, "skyfunc", PP_RAD_PATTERN, index))
        return pp_fail_memory(err);
    if (!sky.has_sun)
        return PP_OK;
    struct pp_material solar = pp_material_light(pp_rgb_grey(sky.sun_radiance));
    strcpy(solar.name, "solar");
    status = pp_scene_description_add_material(reader->scene, &solar, &index, err);
    if (status != PP_OK)
        return status;
    if (!define(reader, "solar", PP_RAD_MATERIAL, index))
        return pp_fail_memory(err);
    const struct pp_shape disc = {.kind = PP_SHAPE_DISTANT,
                                  .is.distant = {sun, 0.25 * PP_RAD}};
    return pp_rad_shapes_add(reader, line->words, line->number,
                             (struct pp_rad_meaning){PP_RAD_MATERIAL, index, -1}, disc,
                             way, err);
}

/* ---- the line ---- */

static enum pp_status run(struct pp_rad_reader *reader, const struct piped_line *line,
                          int which, const struct pp_rad_context *way,
                          struct pp_error *err)
{
    const struct piped_command *command = &line->commands[which];
    const char *name = command->words[0];
    if (strcmp(name, "xform") == 0)
        return run_xform(reader, line, which, way, err);
    if (which > 0)
        return fail(line, err, "only xform can stand behind a pipe, not ", name);
    if (strcmp(name, "genbox") == 0)
        return pp_rad_genbox(reader, line->words, line->number, command->words,
                             command->count, way, err);
    if (strcmp(name, "gensky") == 0)
        return run_gensky(reader, line, command, way, err);
    return fail(line, err,
                "nothing is executed here; of commands, gensky, genbox and xform are "
                "worked out, not ",
                name);
}

enum pp_status pp_rad_command_run(struct pp_rad_reader *reader,
                                  const struct pp_rad_words *words, char *command,
                                  int number, const struct pp_rad_context *way,
                                  struct pp_error *err)
{
    struct piped_line *line = calloc(1, sizeof *line);
    if (!line)
        return pp_fail_memory(err);
    line->words = words;
    line->number = number;
    enum pp_status status = split(line, command, err);
    if (status == PP_OK)
        status = run(reader, line, line->command_count - 1, way, err);
    free(line);
    return status;
}
