/* finding_cells.c - see finding_cells.h. */
#include "reports/assess/finding_cells.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "model/base/text.h"
#include "model/geometry/vec.h"
#include "reports/parts/figure_unit.h"

static const char *unit_of(enum pp_figure kind, bool utf8)
{
    switch (kind) {
    case PP_FIGURE_FACTOR:
    case PP_FIGURE_SHARE:
        return " %";
    case PP_FIGURE_ANGLE:
        return utf8 ? "\xc2\xb0" : " deg";
    case PP_FIGURE_LENGTH:
        return " m";
    case PP_FIGURE_AREA:
        return utf8 ? " m\xc2\xb2" : " m2";
    case PP_FIGURE_HOURS:
        return " h";
    case PP_FIGURE_LUX:
        return " lx";
    case PP_FIGURE_RATIO:
    case PP_FIGURE_COUNT:
        break;
    }
    return "";
}

enum { DECIMALS_MORE = 4 }; /* maximum number of extra decimals */

/* Number of additional decimals that are necessary for the printed figure and bound to
 * compare like their exact values. For example, 0.2963 is less than 0.3, but 0.30 is
 * not. */
static int decimals_more(const struct pp_finding *finding, int decimals)
{
    double scale = pp_figure_scale(finding->kind);
    double off = finding->figure - finding->wanted;
    if (!isfinite(off) || fabs(off) <= 1e-9 * fabs(finding->wanted))
        return 0;
    for (int more = 0; more < DECIMALS_MORE; more++) {
        char figure[PP_FINDING_CELL], wanted[PP_FINDING_CELL];
        snprintf(figure, PP_FINDING_CELL, "%.*f", decimals + more,
                 scale * finding->figure);
        snprintf(wanted, PP_FINDING_CELL, "%.*g", 3 + more, scale * finding->wanted);
        double shown = atof(figure) - atof(wanted);
        if (off < 0.0 ? shown < 0.0 : shown > 0.0)
            return more;
    }
    return DECIMALS_MORE;
}

/* Number of decimals of the figure. *significant is set to the number of significant
 * digits of the bound. */
static int decimals_of(const struct pp_finding *finding, int *significant)
{
    bool one = finding->kind == PP_FIGURE_ANGLE || finding->kind == PP_FIGURE_SHARE;
    bool none = finding->kind == PP_FIGURE_COUNT || finding->kind == PP_FIGURE_LUX;
    int usual = none ? 0 : one ? 1 : 2;
    int more = decimals_more(finding, usual);
    double bound = fabs(pp_figure_scale(finding->kind) * finding->wanted);
    int digits = bound >= 1000.0 ? (int)log10(bound) + 1 : 3;
    *significant = digits + more;
    return usual + more;
}

void pp_finding_cells_figure(char cell[PP_FINDING_CELL],
                             const struct pp_finding *finding, bool utf8)
{
    double scale = pp_figure_scale(finding->kind);
    int significant, decimals = decimals_of(finding, &significant);
    cell[0] = '\0';
    if (isnan(finding->figure))
        return;
    pp_text_append(cell, PP_FINDING_CELL, "%.*f", decimals,
                   scale * finding->figure + 0.0);
    if (isfinite(finding->std_error)) {
        int places = decimals > 2 ? decimals : 2;
        double unit = pow(10.0, places);
        pp_text_append(cell, PP_FINDING_CELL, " %s%.*f", utf8 ? "\xc2\xb1" : "+-",
                       places,
                       ceil(unit * scale * finding->std_error - 1e-7) / unit + 0.0);
    }
    if (pp_band_is_known(finding->band))
        pp_text_append(cell, PP_FINDING_CELL, " (%.*f%s%.*f)", decimals,
                       scale * finding->band.low, utf8 ? "\xe2\x80\x93" : "-", decimals,
                       scale * finding->band.high);
    pp_text_append(cell, PP_FINDING_CELL, "%s", unit_of(finding->kind, utf8));
}

void pp_finding_cells_wanted(char cell[PP_FINDING_CELL],
                             const struct pp_finding *finding, bool utf8)
{
    int significant;
    decimals_of(finding, &significant);
    cell[0] = '\0';
    if (isnan(finding->figure) || isnan(finding->wanted))
        return;
    const char *sign = finding->at_most  ? utf8 ? "\xe2\x89\xa4" : "<="
                       : finding->strict ? ">"
                       : utf8            ? "\xe2\x89\xa5"
                                         : ">=";
    snprintf(cell, PP_FINDING_CELL, "%s %.*g%s", sign, significant,
             pp_figure_scale(finding->kind) * finding->wanted,
             unit_of(finding->kind, utf8));
}
