/* chart_run.h - draws one kind of chart for the rooms of a command line, and writes the
 * files. */
#ifndef PP_CLI_CHART_CHART_RUN_H
#define PP_CLI_CHART_CHART_RUN_H

#include "api/chart_kind.h"
#include "cli/exit_status.h"
#include "cli/room_options.h"

/* Sheet options as typed. */
struct pp_chart_words {
    const char *format; /* as typed; NULL: by the file's name */
    enum pp_paper paper;
    enum pp_orientation orientation;
    double dpi; /* 0: the canvas's own choice */
    bool list, logarithmic, linear;
    const char *before;   /* a file with the former state of the rooms, or "existing";
                           * NULL: none */
    bool before_is_state; /* the former rooms are those of the same file in its existing
                           * state */
    struct pp_project project; /* facts that replace those in the file */
    struct pp_chart_choice choice;
};

/* Reads the room files, draws the chart and reports errors. Without files the chart is
 * blank. */
enum pp_exit pp_chart_run(const struct pp_chart_kind *kind,
                          const struct pp_room_options *room_options,
                          const struct pp_chart_words *options, char **files,
                          int file_count);

#endif
