/* band_words.c - names of features, and the limits of regimes in words. */
#include "studies/bands/band_words.h"

#include <math.h>
#include <stdio.h>

#include "model/base/text.h"

static const char *const words[PP_BAND_FEATURES] = {
    [PP_ROOM_GLASS_FLOOR] = "ratio of glass area to floor area",
    [PP_ROOM_GLASS_INSIDE] = "ratio of glass area to the area of all interior surfaces",
    [PP_ROOM_REFLECTANCE] = "mean reflectance",
    [PP_ROOM_FLOOR] = "floor reflectance",
    [PP_ROOM_CEILING] = "ceiling reflectance",
    [PP_ROOM_DEPTH_HEAD] = "ratio of room depth to window head height",
    [PP_ROOM_DEPTH_WIDTH] = "ratio of room depth to room width",
    [PP_ROOM_BELOW] = "share of the glass below the working plane",
    [PP_ROOM_UPRIGHT] = "share of the glass that is vertical",
    [PP_ROOM_WALLS] = "number of faces with openings",
    [PP_ROOM_SPREAD] = "largest opening as a share of the glass area",
    [PP_ROOM_REVEAL] = "ratio of reveal depth to opening size",
    [PP_ROOM_PANE] = "ratio of diffuse to normal transmittance of the glass",
    [PP_ROOM_OBSTRUCTION] = "obstruction angle (degrees)",
    [PP_ROOM_THINGS] = "external blocks or surfaces (0 no, 1 yes)",
    [PP_ROOM_GROUND] = "ground reflectance",
    [PP_ROOM_FACING] = "illuminance on the openings from the open sky",
    [PP_ROOM_OPPOSITE] = "illuminance from the open sky on planes facing the openings",
    [PP_ROOM_ORDINARY] = "ordinary room",
    [PP_ROOM_DEPTH] =
        ("ratio of the distance from the window to the height of its head "
         "above the point"),
    [PP_ROOM_SIDE] = "ratio of the distance from the wall to the room height",
    [PP_ROOM_VIEW] = "configuration factor of the windows",
    [PP_BAND_FIGURE] = "value by the hand method (%)",
    [PP_BAND_SKY] = "share of the sky component",
    [PP_BAND_OUTSIDE] = "share of the externally reflected component",
    [PP_BAND_INSIDE] = "share of the internally reflected component",
};

const char *pp_band_words_feature(int feature)
{
    return words[feature];
}

/* Words and unit of features that are printed with a unit, as in "obstruction angle
 * under 23 degrees". */
static const struct {
    const char *words, *unit;
} with_unit[PP_BAND_FEATURES] = {
    [PP_ROOM_OBSTRUCTION] = {"obstruction angle", " degrees"},
    [PP_BAND_FIGURE] = {"value by the hand method", " %"},
};

static void add_condition(char *text, size_t size,
                          const struct pp_band_condition *condition)
{
    const char *comma = text[0] ? ", " : "";
    if (condition->feature == PP_ROOM_ORDINARY) {
        pp_text_append(text, size, "%s%s rooms", comma,
                       isinf(condition->to) ? "ordinary" : "unusual");
        return;
    }
    if (condition->feature == PP_ROOM_THINGS) {
        pp_text_append(text, size, "%s%s external blocks or surfaces", comma,
                       isinf(condition->to) ? "with" : "without");
        return;
    }
    const int feature = condition->feature;
    const char *unit = with_unit[feature].unit ? with_unit[feature].unit : "";
    pp_text_append(text, size, "%s%s ", comma,
                   with_unit[feature].words ? with_unit[feature].words
                                            : words[feature]);
    if (isinf(condition->from))
        pp_text_append(text, size, "under %g%s", condition->to, unit);
    else if (isinf(condition->to))
        pp_text_append(text, size, "%g%s or more", condition->from, unit);
    else
        pp_text_append(text, size, "%g to %g%s", condition->from, condition->to, unit);
}

void pp_band_words_regime(char *text, size_t size, const struct pp_band_regime *regime)
{
    text[0] = '\0';
    for (int i = 0; i < regime->condition_count; i++)
        add_condition(text, size, &regime->conditions[i]);
    if (regime->condition_count == 0)
        snprintf(text, size, "all");
}
