/* causes.h - list of possible mistakes in another program's input or settings. Each
 * mistake has a description, and a switch of our own simulation that imitates it
 * (room_variant.h).
 *
 * Causes of one kind exclude each other. Two causes have no given value, but the
 * best-fitting one: a common factor of all values, and the reflectance of the ground.
 */
#ifndef PP_STUDIES_RESEARCH_COMPARE_CAUSES_H
#define PP_STUDIES_RESEARCH_COMPARE_CAUSES_H

#include "studies/research/compare/compare_subject.h"

struct pp_cause {
    const char *word;   /* "bounces=2"; "ground" if the value is fitted */
    const char *kind;   /* causes of one kind exclude each other */
    const char *action; /* what the other program does, as the end of a sentence */
    const char *remedy; /* how to correct it in the other program */
    bool is_factor;
    bool is_alone; /* true if no other cause can be present with it */
    /* True if the cause can be detected in this room or scene; NULL: in any. */
    bool (*applies)(const struct pp_compare_subject *subject);
};

enum { PP_CAUSES_MOST = 32 };

/* Lists the causes that apply, in the order of the list; returns their number. */
int pp_causes_of(const struct pp_cause *list[PP_CAUSES_MOST],
                 const struct pp_compare_subject *subject);

/* All causes; NULL after the last. */
const struct pp_cause *pp_causes_at(int index);

/* Kinds of mistake that are not in the list, as parts of a sentence; NULL after the
 * last. */
const char *pp_causes_missing_at(int index);

/* True if the cause has a fitted reflectance, from 0 to PP_CAUSES_VALUE_MOST. */
#define PP_CAUSES_VALUE_MOST 0.8
bool pp_causes_is_fitted(const struct pp_cause *cause);

/* Adds the cause's switch to those already set. value: value of a fitted cause. Not for
 * a common factor. */
enum pp_status pp_causes_set_variant(struct pp_room_variant *variant,
                                     const struct pp_cause *cause, double value,
                                     struct pp_error *err);

#endif
