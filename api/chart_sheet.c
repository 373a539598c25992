/* chart_sheet.c - draws the chart, and prints program version, room file and seed on
 * the sheet. */
#include "api/chart_sheet.h"

#include <stdio.h>
#include <string.h>

#include "model/base/text.h"
#include "pepperpot.h"

enum pp_status pp_chart_sheet_draw(const struct pp_chart_kind *kind,
                                   struct pp_canvas *canvas, struct pp_study_room *room,
                                   const struct pp_study_options *study,
                                   const struct pp_chart_choice *choice, bool *finished,
                                   struct pp_error *err)
{
    char words[160];
    snprintf(words, sizeof words, "pepperpot %s", pp_version_text());
    if (room && room->file) {
        const char *slash = strrchr(room->file, '/');
        const char *name = slash ? slash + 1 : room->file;
        pp_text_append(words, sizeof words, " \u00b7 %s",
                       strcmp(name, "-") == 0 ? "standard input" : name);
    }
    if (study->simulate)
        pp_text_append(words, sizeof words, " \u00b7 seed %llu",
                       (unsigned long long)study->seed);
    pp_canvas_set_imprint(canvas, words);
    return kind->draw(canvas, room, study, choice, finished, err);
}
