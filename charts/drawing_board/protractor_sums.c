/* protractor_sums.c - see protractor_sums.h. */
#include "charts/drawing_board/protractor_sums.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "charts/sheet/page.h"
#include "model/geometry/vec.h"

void pp_protractor_sums_percent(char *text, size_t room, double fraction)
{
    snprintf(text, room, "%.2f\u00a0%%", 100.0 * fabs(fraction));
}

static void say_reading(char *text, size_t room,
                        const struct pp_protractor_reading *reading)
{
    char a[32], b[32], c[32], d[32];
    pp_protractor_sums_percent(a, sizeof a, reading->share[1]);
    pp_protractor_sums_percent(b, sizeof b, reading->share[0]);
    pp_protractor_sums_percent(c, sizeof c, reading->initial);
    pp_protractor_sums_percent(d, sizeof d, reading->component);
    double left = reading->correction[0], right = reading->correction[1];
    bool apart = left < 0.0 && right > 0.0;
    double first = left < 0.0 ? fabs(left) : right;
    double second = left < 0.0 ? fabs(right) : left;
    pp_page_say(text, room,
                "%s: initial sky component %s \u2212 %s = %s; average altitude "
                "%.1f\u00b0; correction %.3f %s %.3f = %.3f;",
                reading->hidden ? "Obstruction" : "Opening", a, b, c,
                reading->average_rad / PP_RAD, first, apart ? "+" : "\u2212", second,
                reading->width_factor);
    char factor[32] = "";
    if (reading->hidden)
        snprintf(factor, sizeof factor, " \u00d7 %.3g", reading->factor);
    pp_page_say(text, room, "%s \u00d7 %.3f%s = %s.", c, reading->width_factor, factor,
                d);
}

/* Appends a line break to the text. */
static void new_line(char **text, size_t *room)
{
    size_t used = strlen(*text);
    if (used + 2 > *room)
        return;
    memcpy(*text + used, "\n", 2);
    *text += used + 1;
    *room -= used + 1;
}

static void say_result(char *text, size_t room, const struct pp_protractor_sheet *sheet)
{
    if (sheet->read.less_hidden)
        pp_page_say(text, room,
                    "The sky component of the obstruction is subtracted from that of "
                    "the opening.");
    char sky[32], external[32];
    if (sheet->allowance < 0.9995 || sheet->allowance > 1.0005)
        pp_page_say(text, room,
                    "Multiply by %.3g for the frame, dirt, and glass other than clear "
                    "single glass.",
                    sheet->allowance);
    pp_protractor_sums_percent(sky, sizeof sky, sheet->allowance * sheet->read.sky);
    pp_protractor_sums_percent(external, sizeof external,
                               sheet->allowance * sheet->read.external);
    pp_page_say(text, room, "Sky component %s, externally reflected component %s.", sky,
                external);
}

void pp_protractor_sums_say(char *text, size_t room,
                            const struct pp_protractor_sheet *sheet,
                            const struct pp_protractor_sums *sums)
{
    int behind = sums->first + sheet->read.count;
    for (int i = 0; i < sheet->read.count; i++) {
        if (sums->all > PP_PROTRACTOR_SUMS_MOST)
            pp_page_say(text, room, "%d.", sums->first + i + 1);
        say_reading(text, room, &sheet->read.list[i]);
        new_line(&text, &room);
    }
    if (behind < sums->all)
        pp_page_say(text, room,
                    sums->last
                        ? "Read the remaining parts (%d) in the same way; a PDF shows "
                          "them on further sheets."
                        : "Read the remaining parts (%d) in the same way; see the "
                          "next sheets.",
                    sums->all - behind);
    if (sums->last)
        say_result(text, room, sheet);
}
