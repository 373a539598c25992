/* method.h - what every hand method is: one entry in one list.
 *
 * A method says what one opening gives, as its source has it; the sum over openings and
 * the settling of glass, frame and dirt (methods/allowance.h) are done once for all, in
 * methods/evaluate.c.
 */
#ifndef PP_METHODS_METHOD_H
#define PP_METHODS_METHOD_H

#include <stdbool.h>

#include "methods/allowance.h"
#include "model/results/reading.h"
#include "model/results/steps.h"
#include "model/room/world.h"

enum pp_gives {
    PP_GIVES_DIRECT,   /* sky and externally reflected component, at a point */
    PP_GIVES_INTERNAL, /* internally reflected component */
    PP_GIVES_WHOLE,    /* the daylight factor in one step */
};

enum pp_speaks_for {
    PP_FOR_POINT,
    PP_FOR_ROOM,    /* an average: a point's value by it is that average */
    PP_FOR_MINIMUM, /* the least in the room: it stands for each point, and tells no
                     * average */
};

/* What one opening gives, before allowances are settled. A method that sets down how
 * it comes to its figures calls the last of each "sc" and "erc", "irc", or "df", which
 * formulae further on take up; one that does not has a step of that name made for it.
 * Whose opening the steps are is known from pp_steps.line. */
struct pp_part {
    double sky;             /* of PP_GIVES_DIRECT */
    double external;        /* of PP_GIVES_DIRECT */
    double value;           /* of PP_GIVES_INTERNAL and PP_GIVES_WHOLE */
    const char *why;        /* set instead of a value: why there is none after all, as
                             * the end of a sentence that begins with "the opening on
                             * line 12"; static, or good as long as the tools */
    struct pp_steps *steps; /* where readings on the way are set down; NULL: nowhere */
};

/* What somebody asked for that changes a method's figures; all zero: nothing. */
struct pp_method_options {
    const struct pp_lumen_table *lumen_table; /* not owned; NULL: the program's own */
};

struct pp_method {
    const char *name;    /* as typed on the command line */
    const char *summary; /* one line, without a full stop */
    const char *source;  /* key in docs/SOURCES.md */
    enum pp_gives gives;
    enum pp_speaks_for speaks_for;
    bool of_all_surfaces; /* an average over the room's surfaces, not its working plane:
                           * not to be compared with one */
    unsigned allowances;  /* what its figures already contain, enum pp_allowance */
    bool counts;          /* squares or dots: no finer than one of them */
    bool has_average; /* of PP_FOR_POINT: evaluate without a receiver gives the average
                       * over the working plane, in place of an integral over points */

    /* Why the method says nothing of this room, or of this receiver in it (NULL: of the
     * room as a whole): a static sentence ("the table holds the overcast sky only"), or
     * NULL if it does say something. May be left out (NULL): it covers all. */
    const char *(*refuses_room)(const struct pp_world *world,
                                const struct pp_receiver *receiver);

    /* Why the method does not cover this opening for this receiver (NULL for the room),
     * as the static end of a sentence that begins with "the opening on line 12"
     * ("slopes; the table holds vertical openings only"), or NULL if it does. May be
     * left out. */
    const char *(*refuses)(const struct pp_world *world,
                           const struct pp_opening *opening,
                           const struct pp_receiver *receiver);

    /* Makes what the method works with all over one world that it does not refuse: a
     * diagram, drawn once. May be left out: then tools is NULL. On success *tools is
     * given back to put_away. */
    enum pp_status (*prepare)(void **tools, const struct pp_world *world,
                              struct pp_error *err);
    /* The same of a method whose figures the options bear on; in place of prepare. */
    enum pp_status (*prepare_by)(void **tools, const struct pp_world *world,
                                 const struct pp_method_options *options,
                                 struct pp_error *err);
    void (*put_away)(void *tools); /* NULL tools are allowed */

    /* What the opening gives; called only where nothing refuses, part zeroed but for
     * its steps. Several threads may be in it at once. */
    enum pp_status (*evaluate)(const struct pp_world *world,
                               const struct pp_opening *opening,
                               const struct pp_receiver *receiver, const void *tools,
                               struct pp_part *part, struct pp_error *err);

    /* The same to about 1e-4 and fast, where evaluate takes pains: for averages. May be
     * left out. */
    enum pp_status (*evaluate_roughly)(const struct pp_world *world,
                                       const struct pp_opening *opening,
                                       const struct pp_receiver *receiver,
                                       const void *tools, struct pp_part *part,
                                       struct pp_error *err);
};

/* All methods, in the order in which results show them; ends with NULL. */
extern const struct pp_method *const pp_methods[];

/* pp_methods[index], for programs that link the shared library, which exports functions
 * only; NULL at the end of the list. index is at most one past the last method. */
const struct pp_method *pp_method_at(int index);

/* The method of that name, or NULL. */
const struct pp_method *pp_method_find(const char *name);

#endif
