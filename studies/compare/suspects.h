/* suspects.h - what another program may have taken otherwise: the list, each a switch of
 * ours that imitates it (as_if.h), with its words for people.
 *
 * Suspects of one kind exclude each other. A common factor has no value of its own: it is
 * whatever fits best. */
#ifndef PP_STUDIES_COMPARE_SUSPECTS_H
#define PP_STUDIES_COMPARE_SUSPECTS_H

#include "studies/compare/compare_subject.h"

struct pp_suspect {
    const char *word;  /* "bounces=2"; of a common factor "factor" */
    const char *kind;  /* those of one kind exclude each other */
    const char *cause; /* what the other program did, as a sentence's end */
    const char *cure;  /* what to set right there */
    bool is_factor;
    bool is_alone; /* is there nothing left for others to do? */
    /* Can it be told there at all? NULL: anywhere. */
    bool (*applies)(const struct pp_compare_subject *subject);
};

enum { PP_SUSPECTS_MOST = 32 };

/* Those that apply, in the order of the list; returns how many. */
int pp_suspects_of(const struct pp_suspect *list[PP_SUSPECTS_MOST],
                   const struct pp_compare_subject *subject);

/* All of them; NULL behind the last. */
const struct pp_suspect *pp_suspects_at(int index);

#endif
