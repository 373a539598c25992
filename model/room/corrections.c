/* corrections.c - see corrections.h. */
#include "model/room/corrections.h"

#include <assert.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

static const struct pp_named_factor frames[] = {
#include "tables/frames.inc"
};

static const struct pp_named_factor curtains[] = {
#include "tables/curtains.inc"
};

const struct pp_named_factors pp_frames = {frames, sizeof frames / sizeof *frames};
const struct pp_named_factors pp_curtains = {curtains,
                                             sizeof curtains / sizeof *curtains};

const struct pp_named_factor *pp_corrections_find(
    const struct pp_named_factors *factors, const char *name)
{
    for (int i = 0; i < factors->count; i++)
        if (strcmp(factors->list[i].name, name) == 0)
            return &factors->list[i];
    return NULL;
}

static const struct {
    const char *edition, *surroundings, *work;
    double vertical, sloping, horizontal;
} maintenance[] = {
#include "tables/maintenance.inc"
};

static const struct {
    const char *surroundings, *work;
    double factor;
} decorations[] = {
#include "tables/decorations.inc"
};

static const char *const surroundings_words[] = {
    [PP_RURAL] = "rural", [PP_URBAN] = "urban", [PP_INDUSTRIAL] = "industrial"};
static const char *const edition_words[] = {
    [PP_DIRT_BRE309] = "bre309", [PP_DIRT_BS8206] = "bs8206"};
static const char *const work_words[] = {[PP_CLEAN] = "clean", [PP_DIRTY] = "dirty"};

const char *const pp_corrections_editions[] = {
    [PP_DIRT_BRE309] = "BRE309", [PP_DIRT_BS8206] = "BS8206"};

double pp_corrections_maintenance(enum pp_dirt edition,
                                  enum pp_surroundings surroundings, enum pp_work work,
                                  double slope_rad)
{
    size_t row = 0, count = sizeof maintenance / sizeof *maintenance;
    while (
        row < count
        && (strcmp(maintenance[row].edition, edition_words[edition])
            || strcmp(maintenance[row].surroundings, surroundings_words[surroundings])
            || strcmp(maintenance[row].work, work_words[work])))
        row++;
    if (row == count)
        return NAN;
    /* Vertical from 75 degrees, horizontal below 15; the small term absorbs
     * rounding. */
    double slope_deg = slope_rad / PP_RAD + 1e-6;
    if (slope_deg >= 75.0)
        return maintenance[row].vertical;
    return slope_deg >= 15.0 ? maintenance[row].sloping : maintenance[row].horizontal;
}

double pp_corrections_decorations(enum pp_surroundings surroundings, enum pp_work work)
{
    size_t row = 0, count = sizeof decorations / sizeof *decorations;
    while (row < count
           && (strcmp(decorations[row].surroundings, surroundings_words[surroundings])
               || strcmp(decorations[row].work, work_words[work])))
        row++;
    assert(row < count);
    return decorations[row].factor;
}
