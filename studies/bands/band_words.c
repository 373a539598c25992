/* band_words.c - the words for each feature, and the bounds behind them. */
#include "studies/bands/band_words.h"

#include <math.h>
#include <stdio.h>

#include "model/base/text.h"

static const char *const words[PP_BAND_FEATURES] = {
    [PP_ROOM_GLASS_FLOOR] = "glass over floor",
    [PP_ROOM_GLASS_INSIDE] = "glass over all surfaces",
    [PP_ROOM_REFLECTANCE] = "mean reflectance",
    [PP_ROOM_FLOOR] = "the floor's reflectance",
    [PP_ROOM_CEILING] = "the ceiling's reflectance",
    [PP_ROOM_DEPTH_HEAD] = "the room's depth over the window head",
    [PP_ROOM_DEPTH_WIDTH] = "the room's depth over its width",
    [PP_ROOM_BELOW] = "the glass's share below the plane",
    [PP_ROOM_UPRIGHT] = "the glass's upright share",
    [PP_ROOM_WALLS] = "faces with openings",
    [PP_ROOM_SPREAD] = "the largest opening's share",
    [PP_ROOM_REVEAL] = "the reveal over the opening's size",
    [PP_ROOM_PANE] = "the glass's diffuse over normal transmittance",
    [PP_ROOM_OBSTRUCTION] = "degrees of obstruction",
    [PP_ROOM_THINGS] = "blocks or surfaces outside (0 no, 1 yes)",
    [PP_ROOM_GROUND] = "the ground's reflectance",
    [PP_ROOM_FACING] = "the open sky's illuminance on the openings",
    [PP_ROOM_OPPOSITE] = "that on planes which face the openings",
    [PP_ROOM_ORDINARY] = "whether the room is ordinary",
    [PP_ROOM_DEPTH] = "the point's depth over the window head",
    [PP_ROOM_SIDE] = "the wall's distance over the room's height",
    [PP_ROOM_VIEW] = "the windows' configuration factor",
    [PP_BAND_FIGURE] = "the figure in per cent",
    [PP_BAND_SKY] = "the sky component's share",
    [PP_BAND_OUTSIDE] = "the externally reflected share",
    [PP_BAND_INSIDE] = "the internally reflected share",
};

const char *pp_band_words_feature(int feature)
{
    return words[feature];
}

static void add_condition(char *text, size_t size,
                          const struct pp_band_condition *condition)
{
    const char *comma = text[0] ? ", " : "";
    if (condition->feature == PP_ROOM_ORDINARY) {
        pp_text_append(text, size, "%s%s rooms", comma,
                       isinf(condition->to) ? "ordinary" : "unusual");
        return;
    }
    pp_text_append(text, size, "%s%s ", comma, words[condition->feature]);
    if (isinf(condition->from))
        pp_text_append(text, size, "under %g", condition->to);
    else if (isinf(condition->to))
        pp_text_append(text, size, "%g or more", condition->from);
    else
        pp_text_append(text, size, "%g to %g", condition->from, condition->to);
}

void pp_band_words_regime(char *text, size_t size, const struct pp_band_regime *regime)
{
    text[0] = '\0';
    for (int i = 0; i < regime->condition_count; i++)
        add_condition(text, size, &regime->conditions[i]);
    if (regime->condition_count == 0)
        snprintf(text, size, "all");
}
