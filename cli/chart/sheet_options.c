/* sheet_options.c - reads paper, orientation and resolution. */
#include "cli/chart/sheet_options.h"

#include <string.h>

#include "charts/sheet/canvas.h"
#include "model/base/text.h"

enum pp_status pp_sheet_options_read_paper(const char *text, void *place,
                                           struct pp_error *err)
{
    if (pp_canvas_paper_of(place, text, NULL) == PP_OK)
        return PP_OK;
    return pp_fail(err, PP_BAD_INPUT, "a5, a4, a3 or a2");
}

enum pp_status pp_sheet_options_read_orientation(const char *text, void *place,
                                                 struct pp_error *err)
{
    if (strcmp(text, "portrait") != 0 && strcmp(text, "landscape") != 0)
        return pp_fail(err, PP_BAD_INPUT, "portrait or landscape");
    *(enum pp_orientation *)place = text[0] == 'p' ? PP_PORTRAIT : PP_LANDSCAPE;
    return PP_OK;
}

enum pp_status pp_sheet_options_read_dpi(const char *text, void *place,
                                         struct pp_error *err)
{
    double dpi;
    if (!pp_text_parse_number(text, &dpi) || dpi < 20.0 || dpi > 1200.0)
        return pp_fail(err, PP_BAD_INPUT, "a number of dots per inch from 20 to 1200");
    *(double *)place = dpi;
    return PP_OK;
}
