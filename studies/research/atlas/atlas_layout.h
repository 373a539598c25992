/* atlas_layout.h - a room of the sweep during its layout, and the numbers of the
 * sequence that it uses. Inside studies/research/atlas/ only. */
#ifndef PP_STUDIES_RESEARCH_ATLAS_ATLAS_LAYOUT_H
#define PP_STUDIES_RESEARCH_ATLAS_ATLAS_LAYOUT_H

#include <math.h>

#include "model/base/text.h"
#include "studies/research/atlas/atlas_design.h"
#include "studies/research/atlas/atlas_ranges.h"

/* Groups of coordinates of a room, up to six in each. Every point has two further
 * coordinates. */
enum pp_atlas_group {
    PP_ATLAS_SHAPE,
    PP_ATLAS_FINISHES,
    PP_ATLAS_OPENINGS,
    PP_ATLAS_WALL_1,
    PP_ATLAS_WALL_2,
    PP_ATLAS_ROOF,
    PP_ATLAS_OUTSIDE,
    PP_ATLAS_PLACE,
    PP_ATLAS_SKY,
    PP_ATLAS_POINT
};

enum pp_atlas_wall {
    PP_ATLAS_SOUTH,
    PP_ATLAS_EAST,
    PP_ATLAS_NORTH,
    PP_ATLAS_WEST,
    PP_ATLAS_WALLS
};

/* A room that is being laid out. Lengths in m; the south wall lies along y = 0. */
struct pp_atlas_layout {
    const struct pp_atlas_design *design;
    uint32_t index;
    const struct pp_atlas_ranges *ranges;
    char *xml;

    enum pp_atlas_roof roof;
    double width, depth;
    double eaves;  /* height of the walls; under a sloping ceiling, of the lowest
                    * wall */
    double slope;  /* rise of the ceiling divided by its horizontal run */
    double plane;  /* height of the working plane */
    double ground; /* z of the ground outside */
    double lowest[PP_ATLAS_WALLS]; /* height available for windows, by wall */
    double head;                   /* head of the highest window in the south wall */
};

static inline void pp_atlas_draw(const struct pp_atlas_layout *room,
                                 enum pp_atlas_group group, double u[6])
{
    pp_sobol_sequence_draw(&room->design->sequence, room->index, group, 6, u);
}

static inline double pp_between(double low, double high, double u)
{
    return low + (high - low) * u;
}

/* Value between low and high, u in 0 to 1, uniform in the logarithm. */
static inline double pp_scaled(double low, double high, double u)
{
    return low * pow(high / low, u);
}

static inline double pp_between_ends(const double ends[2], double u)
{
    return pp_between(ends[0], ends[1], u);
}

static inline double pp_scaled_ends(const double ends[2], double u)
{
    return pp_scaled(ends[0], ends[1], u);
}

/* Chooses an index with the probabilities `shares`, which sum to 1. u becomes a new
 * uniform number in (0, 1). */
static inline int pp_one_of(const double *shares, int count, double *u)
{
    int chosen = 0;
    while (chosen < count - 1 && *u >= shares[chosen])
        *u -= shares[chosen++];
    *u /= shares[chosen];
    return chosen;
}

#define PP_ONE_OF(shares, u) pp_one_of(shares, sizeof shares / sizeof shares[0], u)

#define PP_SAY(room, ...) pp_text_append((room)->xml, PP_ATLAS_XML, __VA_ARGS__)

#endif
