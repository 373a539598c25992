/* note_chart.h - a calculation as a design note: the given data beside the room's plan
 * and section, each method's formulae with inserted values and results, and the
 * sources. */
#ifndef PP_CHARTS_NOTE_NOTE_CHART_H
#define PP_CHARTS_NOTE_NOTE_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/report.h"

struct pp_note_chart {
    const struct pp_report *report; /* report for one point, with the steps of the
                                     * calculation */
    const char *const *contents;    /* one sentence per column: corrections that its
                                     * figures already include; "": none */
    const char *const *sources;     /* sources, one paragraph each */
    int source_count;
    const char *const *notes; /* notes on the methods, one paragraph each */
    int note_count;
};

/* Draws on as many sheets as needed. PP_BAD_INPUT if the format has only one sheet and
 * the note is longer, or if no section contains the point. */
enum pp_status pp_note_chart_draw(struct pp_canvas *canvas,
                                  const struct pp_note_chart *note,
                                  struct pp_error *err);

#endif
