/* note_chart.h - a calculation as a design note: the given data with the room's plan
 * and section beside them, each method's formulae as printed, the inserted values,
 * results, and the sources. */
#ifndef PP_CHARTS_NOTE_NOTE_CHART_H
#define PP_CHARTS_NOTE_NOTE_CHART_H

#include "charts/sheet/canvas.h"
#include "model/results/report.h"

struct pp_note_chart {
    const struct pp_report *report; /* report of one point, with steps */
    const char *const *contents;    /* corrections already contained in a column's
                                     * figures, a sentence for each column; "": none */
    const char *const *sources;     /* the sources, a paragraph each */
    int source_count;
    const char *const *notes; /* notes on the methods, of the same form */
    int note_count;
};

/* Draws on as many sheets as needed. PP_BAD_INPUT if the format has one sheet only and
 * the note is longer, or the point is on no section. */
enum pp_status pp_note_chart_draw(struct pp_canvas *canvas,
                                  const struct pp_note_chart *note,
                                  struct pp_error *err);

#endif
