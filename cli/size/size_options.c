/* size_options.c - reads the options of the command size. */
#include "cli/size/size_options.h"

#include <string.h>

#include "methods/evaluate.h"
#include "methods/selection.h"

static enum pp_status read_change(const char *text, void *place, struct pp_error *err)
{
    for (int i = 0; pp_size_room_change_words[i]; i++)
        if (strcmp(text, pp_size_room_change_words[i]) == 0) {
            *(enum pp_size_change *)place = (enum pp_size_change)i;
            return PP_OK;
        }
    return pp_fail(err, PP_BAD_INPUT, "width, height, head, sill or number");
}

#define PLACE(member) offsetof(struct pp_size_options, member)

const struct pp_option pp_size_task_options[] = {
    {"target", 't', "DF%", "The daylight factor to reach: 2% or 2.",
     pp_options_read_per_cent, PLACE(request.target)},
    {"by", 'b', "METHOD",
     "The method that it is worked out by: a method, a pair, or \"traced\" for the "
     "simulation (default exact+bre, or exact+split-flux where that does not cover "
     "the room).",
     pp_options_read_text, PLACE(request.by)},
    {"change", 'c', "WHAT",
     "What may change: width (default), height, head, sill, or the number of windows.",
     read_change, PLACE(request.change)},
    {"wall", 0, "NAME", "Change the windows in that wall only.", pp_options_read_text,
     PLACE(request.wall)},
    {"window", 0, "LINE", "Change the window on that line of the room file only.",
     pp_options_read_count, PLACE(request.line)},
    {0},
};

const struct pp_option pp_size_write_option[] = {
    {"write", 'w', "FILE",
     "Write the room file with the sized windows to FILE, all else in it as it was.",
     pp_options_read_output, PLACE(write)},
    {0},
};

static enum pp_status check_method(const char *by, struct pp_error *err)
{
    if (strpbrk(by, ", ") || strcmp(by, "all") == 0 || strcmp(by, "default") == 0)
        return pp_fail(err, PP_BAD_INPUT,
                       "--by is \"%.200s\"; expected one method or pair, such as "
                       "exact+bre, or traced",
                       by);
    struct pp_error fault = {0};
    enum pp_status status = pp_selection_check(by, &fault);
    return status == PP_OK ? status : pp_fail(err, status, "--by: %s", fault.message);
}

enum pp_status pp_size_options_settle(struct pp_size_options *options,
                                      struct pp_error *err)
{
    if (!(options->request.target > 0.0))
        return pp_fail(err, PP_BAD_INPUT,
                       "expected --target, the daylight factor to reach, such as "
                       "--target 2%%");
    options->request.traced =
        options->request.by && strcmp(options->request.by, "traced") == 0;
    options->request.study = &options->room.study;
    if (options->request.traced && options->room.by_hand)
        return pp_fail(err, PP_BAD_INPUT,
                       "--by traced is the simulation, which --by-hand does without; "
                       "expected one of them");
    enum pp_status status = pp_room_options_settle_by_hand(&options->room, err);
    if (status == PP_OK)
        status = pp_room_options_settle(&options->room, err);
    if (status == PP_OK && options->request.by && !options->request.traced)
        status = check_method(options->request.by, err);
    return status;
}
