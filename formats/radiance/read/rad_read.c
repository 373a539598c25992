/* rad_read.c - reads files, their primitives, and lines that begin with "!". The
 * commands in these lines are evaluated here and never executed.
 *
 * In a pipe, evaluation begins with the last command. An xform without a file evaluates
 * the command before it, once for each of its copies, with the transform of the copy in
 * the context. An xform with files reads the files in the same way.
 */
#include "formats/radiance/read/rad_read.h"

#include <stdlib.h>
#include <string.h>

#include "formats/radiance/read/rad_genbox.h"
#include "formats/radiance/read/rad_primitive.h"
#include "formats/radiance/read/rad_reader.h"
#include "formats/radiance/read/rad_sky.h"
#include "formats/radiance/read/rad_xform.h"
#include "model/base/read_file.h"

/* The text of a file; bytes is NULL until it is read. */
struct scene_text {
    char *bytes;
    size_t length;
};

/* named: true if another scene names the file, which must then be a regular file. */
static enum pp_status read_scene_text(struct scene_text *text, const char *path,
                                      bool named, struct pp_error *err);
static enum pp_status read_text(struct pp_rad_reader *reader,
                                const struct scene_text *text, const char *path,
                                const struct pp_rad_context *context,
                                struct pp_error *err);
static enum pp_status run_command(struct pp_rad_reader *reader,
                                  struct pp_rad_pipe *pipe, int which,
                                  const struct pp_rad_context *context,
                                  struct pp_error *err);

/* ---- commands ---- */

/* Reads the files of an xform for one copy; their text is loaded for the first copy
 * only. */
static enum pp_status read_files(struct pp_rad_reader *reader,
                                 const struct pp_rad_pipe *pipe,
                                 const struct pp_rad_xform *xform,
                                 struct scene_text *texts,
                                 struct pp_rad_context context, struct pp_error *err)
{
    enum pp_status status = PP_OK;
    context.depth++;
    for (int i = 0; i < xform->file_count && status == PP_OK; i++) {
        if (context.depth > PP_RAD_DEPTH_MOST) {
            reader->too_deep = true;
            return pp_rad_pipe_fail(
                pipe, err, "files are nested too deeply; a file may include itself: ",
                xform->files[i]);
        }
        if (!texts[i].bytes) {
            struct pp_error own = {PP_OK, ""};
            status = read_scene_text(&texts[i], xform->files[i], true, &own);
            status = pp_rad_words_locate(pipe->words, pipe->line, status, &own, err);
        }
        if (status == PP_OK)
            status = read_text(reader, &texts[i], xform->files[i], &context, err);
        if (status == PP_OK && reader->bytes > PP_RAD_BYTES_MOST)
            return pp_rad_pipe_fail(
                pipe, err,
                "this xform and those before it read more than 4 GiB of files", "");
        if (status == PP_OK && reader->copied_bytes > PP_RAD_COPIED_BYTES_MOST)
            return pp_rad_words_fail(pipe->words, pipe->line, err,
                                     "this xform and those before it read more than %d "
                                     "MiB of files for copies",
                                     PP_RAD_COPIED_BYTES_MOST >> 20);
    }
    return status;
}

/* Context of one copy, nested in the context of its command. */
static struct pp_rad_context context_of(const struct pp_rad_xform *xform, long copy,
                                        long copies,
                                        const struct pp_rad_context *context)
{
    struct pp_rad_transform own = pp_rad_xform_copy(xform, copy);
    struct pp_rad_context next = *context;
    next.transform = pp_rad_transform_compose(&context->transform, &own);
    next.inverted = context->inverted != xform->inverted;
    next.copied = context->copied || copies > 1;
    if (!context->replaced && xform->replaced) {
        next.replaced = true;
        next.modifier = xform->modifier;
    }
    return next;
}

/* Finds the parsed xform of a command. An xform is parsed only once, even if it is
 * piped into a second xform and evaluated for each copy that the second one makes. */
static enum pp_status find_xform(const struct pp_rad_xform **found,
                                 const struct pp_rad_reader *reader,
                                 struct pp_rad_pipe *pipe, int which,
                                 struct pp_error *err)
{
    struct pp_rad_xform **xform = &pipe->xforms[which];
    enum pp_status status = PP_OK;
    if (!*xform) {
        *xform = malloc(sizeof **xform);
        if (!*xform)
            return pp_fail_memory(err);
        status = pp_rad_xform_read(*xform, &reader->names, pipe, &pipe->commands[which],
                                   err);
        if (status == PP_OK)
            pp_rad_xform_fold(*xform);
    }
    *found = *xform;
    return status;
}

/* Checks the total number of shapes, assuming that each copy has as many as the
 * first. */
static enum pp_status check_first(const struct pp_rad_reader *reader,
                                  const struct pp_rad_pipe *pipe, int shapes_before,
                                  double copies, struct pp_error *err)
{
    double shapes = reader->scene->shape_count - shapes_before;
    if (shapes_before + shapes * copies <= PP_RAD_SHAPES_MOST
        && shapes * copies <= PP_RAD_COPIED_SHAPES_MOST)
        return PP_OK;
    return pp_rad_words_fail(pipe->words, pipe->line, err,
                             "there are %.0f copies of %.0f shapes; expected at most "
                             "%d shapes in the copies made by all xforms together",
                             copies, shapes, PP_RAD_COPIED_SHAPES_MOST);
}

static enum pp_status run_copies(struct pp_rad_reader *reader, struct pp_rad_pipe *pipe,
                                 int which, const struct pp_rad_xform *xform,
                                 long copies, const struct pp_rad_context *context,
                                 struct scene_text *texts, struct pp_error *err)
{
    int shapes_before = reader->scene->shape_count;
    enum pp_status status = PP_OK;
    for (long copy = 0; copy < copies && status == PP_OK; copy++) {
        struct pp_rad_context next = context_of(xform, copy, copies, context);
        if (!isfinite(pp_vec_length(next.transform.move))
            || !(next.transform.scale > 1e-12) || !(next.transform.scale < 1e12))
            return pp_rad_pipe_fail(
                pipe, err, "the copies are too large or too small, or too far away",
                "");
        status = xform->file_count > 0
                     ? read_files(reader, pipe, xform, texts, next, err)
                     : run_command(reader, pipe, which - 1, &next, err);
        if (status == PP_OK && copy == 0 && copies > 1)
            status = check_first(reader, pipe, shapes_before, (double)copies, err);
    }
    return status;
}

static enum pp_status run_xform(struct pp_rad_reader *reader, struct pp_rad_pipe *pipe,
                                int which, const struct pp_rad_context *context,
                                struct pp_error *err)
{
    const struct pp_rad_xform *xform = NULL;
    enum pp_status status = find_xform(&xform, reader, pipe, which, err);
    if (status != PP_OK)
        return status;
    if (xform->file_count == 0 && which == 0)
        return pp_rad_pipe_fail(pipe, err,
                                "xform has nothing to transform; expected a file", "");
    double copies = pp_rad_xform_copies(xform);
    if (copies > (double)(PP_RAD_COPIES_MOST - reader->copies))
        return pp_rad_words_fail(
            pipe->words, pipe->line, err,
            "this xform and those before it make more than %d copies",
            PP_RAD_COPIES_MOST);
    reader->copies += (long)copies;
    struct scene_text *texts = calloc((size_t)xform->file_count + 1, sizeof *texts);
    if (!texts)
        return pp_fail_memory(err);
    status = run_copies(reader, pipe, which, xform, (long)copies, context, texts, err);
    for (int i = 0; i < xform->file_count; i++)
        free(texts[i].bytes);
    free(texts);
    return status;
}

/* Adds to the scene the primitives that command `which` of the pipe would print. */
static enum pp_status run_command(struct pp_rad_reader *reader,
                                  struct pp_rad_pipe *pipe, int which,
                                  const struct pp_rad_context *context,
                                  struct pp_error *err)
{
    const struct pp_rad_command *command = &pipe->commands[which];
    const char *name = command->words[0];
    if (strcmp(name, "xform") == 0)
        return run_xform(reader, pipe, which, context, err);
    if (which > 0)
        return pp_rad_pipe_fail(pipe, err, "expected only xform after a pipe, not ",
                                name);
    if (strcmp(name, "genbox") == 0)
        return pp_rad_genbox(reader, pipe, command, context, err);
    if (strcmp(name, "gensky") == 0 || strcmp(name, "gendaylit") == 0)
        return pp_rad_sky_generate(reader, pipe, command, context, err);
    return pp_rad_pipe_fail(pipe, err,
                            "external programs are not run; expected the commands "
                            "gensky, gendaylit, genbox and xform, not ",
                            name);
}

static enum pp_status run_line(struct pp_rad_reader *reader,
                               const struct pp_rad_words *words, char *text, int line,
                               const struct pp_rad_context *context,
                               struct pp_error *err)
{
    struct pp_rad_pipe *pipe = calloc(1, sizeof *pipe);
    if (!pipe)
        return pp_fail_memory(err);
    pipe->words = words;
    pipe->line = line;
    enum pp_status status = pp_rad_pipe_split(pipe, text, err);
    if (status == PP_OK)
        status = run_command(reader, pipe, pipe->command_count - 1, context, err);
    pp_rad_pipe_clear(pipe);
    free(pipe);
    return status;
}

/* ---- files ---- */

static enum pp_status read_words(struct pp_rad_reader *reader,
                                 struct pp_rad_words *words,
                                 const struct pp_rad_context *context,
                                 struct pp_error *err)
{
    enum pp_status status = PP_OK;
    for (bool ended = false; !ended && status == PP_OK;) {
        char *command;
        int line;
        status = pp_rad_words_next_command(words, &command, &line, err);
        if (status == PP_OK && command)
            status = run_line(reader, words, command, line, context, err);
        else if (status == PP_OK)
            status = pp_rad_primitive_read(reader, words, context, &ended, err);
        free(command);
    }
    return status;
}

static enum pp_status read_scene_text(struct scene_text *text, const char *path,
                                      bool named, struct pp_error *err)
{
    enum pp_status status = (named ? pp_read_file_regular : pp_read_file)(
        &text->bytes, &text->length, path, PP_RAD_BYTES_MOST, err);
    if (status == PP_OK && text->length > PP_RAD_BYTES_MOST)
        return pp_fail(err, PP_BAD_INPUT, "%s: the file is larger than 4 GiB",
                       pp_read_file_title(path));
    return status;
}

/* If an error occurs within this number of lines, and nothing before it was understood,
 * the file is probably not a Radiance scene. */
static const int first_lines = 5;

static enum pp_status read_text(struct pp_rad_reader *reader,
                                const struct scene_text *text, const char *path,
                                const struct pp_rad_context *context,
                                struct pp_error *err)
{
    const bool marked =
        text->length >= 3 && memcmp(text->bytes, "\xef\xbb\xbf", 3) == 0;
    struct pp_rad_words words = {pp_read_file_title(path), text->bytes, text->length,
                                 marked ? 3 : 0, 1};
    const int shapes = reader->scene->shape_count,
              materials = reader->scene->material_count;
    reader->bytes += text->length;
    reader->copied_bytes += context->copied ? text->length : 0;
    enum pp_status status = read_words(reader, &words, context, err);
    /* A file named by a scene can be any file of the user, so its text must not be
     * quoted. */
    if (status == PP_BAD_INPUT && context->depth > 0 && !reader->too_deep
        && shapes == reader->scene->shape_count
        && materials == reader->scene->material_count && words.line <= first_lines)
        return pp_fail(err, status, "%.200s:%d: this is not a Radiance scene",
                       words.file, words.line);
    return status;
}

static enum pp_status read_scene_file(struct pp_rad_reader *reader, const char *path,
                                      const struct pp_rad_context *context,
                                      struct pp_error *err)
{
    struct scene_text text = {0};
    if (path[0] == '!') {
        struct pp_rad_words words = {"command line", path, strlen(path), 0, 1};
        return read_words(reader, &words, context, err);
    }
    enum pp_status status = read_scene_text(&text, path, false, err);
    if (status == PP_OK)
        status = read_text(reader, &text, path, context, err);
    free(text.bytes);
    return status;
}

static enum pp_status finish(struct pp_rad_reader *reader, enum pp_status status)
{
    pp_rad_names_clear(&reader->names);
    free(reader->strings);
    free(reader->numbers);
    free(reader->corners);
    if (status != PP_OK)
        pp_scene_description_clear(reader->scene);
    return status;
}

/* Context outside all xforms. */
static const struct pp_rad_context identity = {
    .transform = {.rows = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}},
                  .scale = 1.0}};

enum pp_status pp_rad_read(struct pp_scene_description *scene,
                           struct pp_rad_summary *summary, const char *const *paths,
                           int count, struct pp_error *err)
{
    struct pp_rad_reader reader = {.scene = scene, .summary = summary};
    pp_scene_description_init(scene);
    *summary = (struct pp_rad_summary){0};
    enum pp_status status = PP_OK;
    for (int i = 0; i < count && status == PP_OK; i++)
        status = read_scene_file(&reader, paths[i], &identity, err);
    return finish(&reader, status);
}

enum pp_status pp_rad_read_bytes(struct pp_scene_description *scene,
                                 struct pp_rad_summary *summary, const char *bytes,
                                 size_t length, const char *file, struct pp_error *err)
{
    struct pp_rad_reader reader = {.scene = scene, .summary = summary};
    struct pp_rad_words words = {file, bytes, length, 0, 1};
    pp_scene_description_init(scene);
    *summary = (struct pp_rad_summary){0};
    return finish(&reader, read_words(&reader, &words, &identity, err));
}
