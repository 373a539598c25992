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

const struct pp_option pp_size_block_options[] = {
    {"obstruction", 0, "NAME",
     "In place of a window: how high the block of that name may be so that every "
     "upright "
     "window keeps its share of the vertical sky component.",
     pp_options_read_text, PLACE(obstruction)},
    {"keep", 0, "SHARE%", "That share (default 80%).", pp_options_read_per_cent,
     PLACE(keep)},
    {"window-name", 0, "NAME", "Only the window of that name counts.",
     pp_options_read_text, PLACE(window_name)},
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

/* Nothing that is about windows to be sized goes with --obstruction. */
static enum pp_status settle_block(struct pp_size_options *options,
                                   struct pp_error *err)
{
    const struct pp_size_request *request = &options->request;
    const struct pp_room_options *room = &options->room;
    const char *other = request->target > 0.0          ? "target"
                        : request->by                  ? "by"
                        : request->wall                ? "wall"
                        : request->line > 0            ? "window"
                        : options->write               ? "write"
                        : room->study.points.count > 0 ? "points"
                        : room->study.simulate         ? "simulate"
                        : room->room                   ? "room"
                        : room->state != PP_STATE_BOTH ? "state"
                                                       : NULL;
    if (other)
        return pp_fail(err, PP_BAD_INPUT,
                       "--%s does not go with --obstruction; expected one of them",
                       other);
    if (options->keep == 0.0)
        options->keep = PP_SIZE_OPTIONS_KEEP;
    if (options->keep >= 1.0)
        return pp_fail(err, PP_BAD_INPUT,
                       "--keep is all of it; expected less than 100%%, such as 80%%");
    return PP_OK;
}

enum pp_status pp_size_options_settle(struct pp_size_options *options,
                                      struct pp_error *err)
{
    if (options->obstruction)
        return settle_block(options, err);
    if (options->keep > 0.0 || options->window_name)
        return pp_fail(err, PP_BAD_INPUT,
                       "--%s is for --obstruction; expected both or neither",
                       options->window_name ? "window-name" : "keep");
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
