/* br209_count.h - number of windows and rooms that keep their light according to
 * [BR209], each counted once.
 *
 * A window meets the guide if its vertical sky component is at least 27 % or 0.8 of its
 * former value. A room meets the guide if the area that sees sky is at least 0.8 of its
 * former area. A window or room that is not assessed is not counted, nor are proposed
 * rooms beside existing ones.
 */
#ifndef PP_STUDIES_CRITERIA_BR209_COUNT_H
#define PP_STUDIES_CRITERIA_BR209_COUNT_H

#include "model/base/error.h"
#include "studies/criteria/assessment.h"

/* Bands of the loss of a window's vertical sky component, as used by consultants: below
 * 20 %, 20 % or more (minor), 30 % or more (moderate), 40 % or more (major). */
enum { PP_LOSS_BANDS = 4 };
extern const double pp_loss_bands[PP_LOSS_BANDS]; /* lower ends, fractions */

struct pp_br209_count {
    int windows, windows_met;
    int rooms, rooms_met;
    int losses[PP_LOSS_BANDS]; /* windows whose loss is in each band */
    int compared;              /* windows with a former value */
};

struct pp_br209_count pp_br209_count_of(const struct pp_assessment *rooms, int count);

/* The count of the rooms of one floor of a house, or of a whole house. */
struct pp_br209_group {
    const char *house; /* address, else the file; not owned */
    bool is_house;     /* true: a whole house, which follows its floors in the list */
    double level_m;    /* level of the floor, in the axes of the building; NAN for a
                        * house */
    struct pp_br209_count count;
};

/* *groups: floors and houses in the order in which they appear, floors from below; a
 * house of one floor has one group. Rooms on floors less than 0.5 m apart are on one
 * floor. The caller frees *groups. Fails only if memory runs out. */
enum pp_status pp_br209_count_groups(struct pp_br209_group **groups, int *group_count,
                                     const struct pp_assessment *rooms, int count,
                                     struct pp_error *err);

/* Puts the counts into words: "11 of 12 windows and 5 of 6 rooms meet BR 209"; empty if
 * nothing was assessed. */
enum { PP_BR209_WORDS = 96 };
void pp_br209_count_words(char words[PP_BR209_WORDS],
                          const struct pp_br209_count *count);

/* Words for group `index` of a list: "12 Mill Lane, floor at +3.00 m", "12 Mill Lane,
 * all floors"; without the house if all groups belong to one house. */
void pp_br209_count_group_words(char words[PP_BR209_WORDS],
                                const struct pp_br209_group *groups, int count,
                                int index);

#endif
