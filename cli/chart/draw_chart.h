/* draw_chart.h - from a room and options to a chart of a given kind on a canvas. */
#ifndef PP_CLI_CHART_DRAW_CHART_H
#define PP_CLI_CHART_DRAW_CHART_H

#include <stdbool.h>

#include "charts/sheet/canvas.h"
#include "charts/chart_kind.h"
#include "cli/availability/availability_options.h"
#include "cli/chart/board_options.h"
#include "cli/rooms.h"
#include "cli/chart/sheet_options.h"

struct pp_chart_options {
    const char *format; /* as typed; NULL: by the file's name */
    enum pp_paper paper;
    enum pp_orientation orientation;
    double dpi;       /* 0: the canvas's own choice */
    bool logarithmic; /* section: daylight factors */
    bool list;
    struct pp_board_options board; /* of kinds worked at the drawing board */
    struct pp_availability_options availability; /* of those of the light outside */
};

/* Does the kind look better on a sheet that lies on its side for this room (NULL: for
 * a blank)? */
bool pp_draw_chart_landscape(const struct pp_chart_kind *kind,
                             const struct pp_world *world);

/* Computes what the chart shows of the room (NULL: a blank) and draws it. A section of
 * a room without a line of points gets one of its own (section_line.h). *finished
 * becomes false where the simulation was interrupted. */
enum pp_status pp_draw_chart(const struct pp_chart_kind *kind, struct pp_canvas *canvas,
                             struct pp_study_room *room,
                             const struct pp_room_options *room_options,
                             const struct pp_chart_options *options, bool *finished,
                             struct pp_error *err);

#endif
