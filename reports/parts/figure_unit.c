/* figure_unit.c - see figure_unit.h. */
#include "reports/parts/figure_unit.h"

#include "model/geometry/vec.h"

static const struct {
    const char *unit;
    double scale;
} kinds[] = {
    [PP_FIGURE_FACTOR] = {"%", 100.0},
    [PP_FIGURE_SHARE] = {"%", 100.0},
    [PP_FIGURE_RATIO] = {"", 1.0},
    [PP_FIGURE_COUNT] = {"", 1.0},
    [PP_FIGURE_ANGLE] = {"degrees", 1.0 / PP_RAD},
    [PP_FIGURE_LENGTH] = {"m", 1.0},
    [PP_FIGURE_AREA] = {"m2", 1.0},
    [PP_FIGURE_HOURS] = {"h", 1.0},
    [PP_FIGURE_LUX] = {"lx", 1.0},
};

double pp_figure_scale(enum pp_figure kind)
{
    return kinds[kind].scale;
}

const char *pp_figure_unit(enum pp_figure kind)
{
    return kinds[kind].unit;
}
