/* rtrace_factors.c - exports the room, runs the Radiance script of the export, and
 * reads the output of the script. */
#include "cli/validate/rtrace_factors.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

#include "cli/interrupt.h"
#include "cli/program/program_place.h"
#include "cli/radiance/radiance_export.h"
#include "model/base/text.h"

bool pp_rtrace_is_there(void)
{
    char path[PATH_MAX];
    return pp_program_place_on_path("rtrace", path, sizeof path)
           && pp_program_place_on_path("oconv", path, sizeof path);
}

/* Runs the script. The output of the script is returned in *text, which the caller
 * frees. Messages go to standard error. */
static enum pp_status run_script(const char *directory, char **text,
                                 struct pp_error *err)
{
    int ends[2];
    *text = NULL;
    if (pipe(ends) != 0)
        return pp_fail(err, PP_SYSTEM, "rtrace cannot be run: %s", strerror(errno));
    pid_t child = fork();
    if (child == 0) {
        dup2(ends[1], STDOUT_FILENO);
        close(ends[0]);
        close(ends[1]);
        if (chdir(directory) == 0)
            execlp("sh", "sh", "./daylight_factors.sh", "-ab", "22", "-lr", "0", "-ad",
                   "1024", "-as", "0", "-aa", "0", "-lw", "1e-7", (char *)NULL);
        _exit(127);
    }
    close(ends[1]);
    size_t size = 0, count = 0;
    FILE *in = child > 0 ? fdopen(ends[0], "r") : NULL;
    if (in) {
        ssize_t got = getdelim(text, &size, '\0', in);
        count = got > 0 ? (size_t)got : 0;
        fclose(in);
    } else {
        close(ends[0]);
    }
    int state = -1;
    while (child > 0 && waitpid(child, &state, 0) < 0 && errno == EINTR)
        ;
    if (child > 0 && state == 0 && count > 0)
        return PP_OK;
    return pp_interrupt_came() ? pp_fail(err, PP_INTERRUPTED, "interrupted")
                               : pp_fail(err, PP_SYSTEM, "rtrace failed");
}

/* Reads the last word of each line, a daylight factor in per cent. There are
 * PP_RTRACE_REPEATS lines per point. PP_SYSTEM if there are too few lines. */
static enum pp_status read_factors(struct pp_reading *readings, int count, char *text,
                                   struct pp_error *err)
{
    char *rest = text;
    for (int i = 0; i < count; i++) {
        double values[PP_RTRACE_REPEATS], sum = 0.0, squares = 0.0;
        for (int k = 0; k < PP_RTRACE_REPEATS; k++) {
            char *line = strsep(&rest, "\n"), *word = line ? strrchr(line, ' ') : NULL;
            if (!word || !pp_text_parse_number(word, &values[k]))
                return pp_fail(err, PP_SYSTEM, "rtrace gave fewer factors than points");
            sum += values[k] / 100.0;
        }
        double mean = sum / PP_RTRACE_REPEATS;
        for (int k = 0; k < PP_RTRACE_REPEATS; k++)
            squares += (values[k] / 100.0 - mean) * (values[k] / 100.0 - mean);
        readings[i] = pp_reading_of(mean);
        readings[i].std_error =
            sqrt(squares / PP_RTRACE_REPEATS / (PP_RTRACE_REPEATS - 3));
    }
    return PP_OK;
}

/* Exports the room with each point repeated PP_RTRACE_REPEATS times. */
static enum pp_status export_repeated(const char *path,
                                      const struct pp_study_room *room,
                                      struct pp_error *err)
{
    struct pp_study_room many = *room;
    many.receiver_count = PP_RTRACE_REPEATS * room->receiver_count;
    many.receivers = calloc((size_t)many.receiver_count + 1, sizeof *many.receivers);
    if (!many.receivers)
        return pp_fail_memory(err);
    for (int i = 0; i < many.receiver_count; i++)
        many.receivers[i] = room->receivers[i / PP_RTRACE_REPEATS];
    struct pp_output_directory directory;
    enum pp_status status =
        pp_output_directory_open(&directory, path, false, pp_radiance_files, err);
    if (status == PP_OK)
        status = pp_radiance_export(&directory, NULL, &many, 10000.0, false, NULL, err);
    if (status == PP_OK)
        status = pp_output_directory_commit(&directory, err);
    else
        pp_output_directory_clear(&directory);
    free(many.receivers);
    return status;
}

enum pp_status pp_rtrace_factors(struct pp_reading *readings,
                                 const struct pp_study_room *room, struct pp_error *err)
{
    char *path, *text = NULL;
    if (asprintf(&path, "%s/pepperpot-XXXXXX", pp_program_place_temporary()) < 0)
        return pp_fail_memory(err);
    enum pp_status status = PP_OK;
    if (!mkdtemp(path)) {
        status =
            pp_fail(err, PP_SYSTEM, "%s cannot be created: %s", path, strerror(errno));
        free(path);
        return status;
    }
    status = export_repeated(path, room, err);
    if (status == PP_OK)
        status = run_script(path, &text, err);
    if (status == PP_OK)
        status = read_factors(readings, room->receiver_count, text, err);
    pp_output_directory_remove(path);
    free(text);
    free(path);
    return status;
}
