/* en17037_level.h - the level of EN 17037 that findings reach. */
#ifndef PP_STUDIES_CRITERIA_EN17037_EN17037_LEVEL_H
#define PP_STUDIES_CRITERIA_EN17037_EN17037_LEVEL_H

#include "model/room/world.h"
#include "studies/criteria/finding.h"

enum { PP_EN17037_NONE, PP_EN17037_MINIMUM, PP_EN17037_MEDIUM, PP_EN17037_HIGH };

/* "none", "minimum", "medium", "high". */
extern const char *const pp_en17037_level_names[PP_EN17037_HIGH + 1];

/* Illuminances (lx) of each level: the target, over half of the plane or, under
 * rooflights, over 95 %; and the minimum over 95 %, for windows. 0 for no level. */
extern const double pp_en17037_level_target_lx[PP_EN17037_HIGH + 1];
extern const double pp_en17037_level_minimum_lx[PP_EN17037_HIGH + 1];
extern const double pp_en17037_level_half, pp_en17037_level_nearly_all;

struct pp_en17037_level {
    int reached; /* highest level for which all findings of that level and of all lower
                  * levels are met */
    int perhaps; /* highest level that undecided findings do not exclude; >= reached */
    bool judged; /* false: no finding of a level has a verdict */
};

/* The level that the findings reach. A level without findings is not reached. */
struct pp_en17037_level pp_en17037_level_of(const struct pp_finding_list *findings);

/* The level in words: "minimum, perhaps medium". */
enum { PP_EN17037_LEVEL_WORDS = 48 };
void pp_en17037_level_words(char words[PP_EN17037_LEVEL_WORDS],
                            const struct pp_finding_list *findings);

/* True if all glass is within 15 degrees of level, so that the targets of rooflights
 * apply. */
bool pp_en17037_level_of_rooflights(const struct pp_world *world);

#endif
