/* method.h - interface of the hand methods, and their list.
 *
 * A method gives the components of one opening, as in its source. The corrections for
 * glass, frame and dirt (methods/allowance.h) and the sum over openings are the same
 * for all methods and are made in methods/method_run.c. A method is evaluated for a
 * world and the light outside (light/outside_light.h); both must be the same in
 * `prepare` and in later calls. A new method is one file with one struct pp_method,
 * declared at the end of this header and entered in the list in method.c.
 */
#ifndef PP_METHODS_METHOD_H
#define PP_METHODS_METHOD_H

#include <stdbool.h>

#include "methods/allowance.h"
#include "model/base/stop.h"
#include "model/light/outside_light.h"
#include "model/results/reading.h"
#include "model/results/worksheet.h"
#include "model/room/world.h"

struct pp_beams; /* methods/fast/beams.h */

enum pp_gives {
    PP_GIVES_DIRECT,   /* sky and externally reflected component, at a point */
    PP_GIVES_INTERNAL, /* internally reflected component */
    PP_GIVES_WHOLE,    /* the daylight factor in one step */
};

enum pp_speaks_for {
    PP_FOR_POINT,
    PP_FOR_ROOM,    /* an average, used for each point of the room */
    PP_FOR_MINIMUM, /* the minimum in the room, used for each point; the room has no
                     * average by such a method */
};

/* The components that a method gives: of one opening or, after the corrections, of all
 * openings. The components are fractions of the open-sky horizontal illuminance: 0.02,
 * never 2. The texts of the method's formulae have the same figures in per cent
 * (results/formula.h). */
struct pp_amounts {
    double sky;      /* PP_GIVES_DIRECT */
    double external; /* PP_GIVES_DIRECT */
    double value;    /* PP_GIVES_INTERNAL and PP_GIVES_WHOLE */
};

/* The components of one opening (fractions), before the corrections for glass, frame
 * and dirt. A method that records its steps names the last step of each component "sc",
 * "erc", "irc" or "df", which later formulae refer to; for a method that does not,
 * methods/component_steps.c adds a step of that name. pp_steps.line is the line of the
 * opening that the steps belong to. */
struct pp_part {
    double sky;      /* PP_GIVES_DIRECT */
    double external; /* PP_GIVES_DIRECT */
    double value;    /* PP_GIVES_INTERNAL and PP_GIVES_WHOLE */
    const char *why; /* the reason, if there is no value, as the end of a sentence that
                      * begins with "window W1"; static, or valid as long
                      * as the tools */
    struct pp_worksheet
        sheet; /* where figures are recorded and formulae evaluated; sheet.steps, which
                * may be NULL, receives the steps */
};

/* A user's choices that change the figures of a method; all zero: none. */
struct pp_method_options {
    const struct pp_lumen_table *lumen_table; /* not owned; NULL: the program's own */
    const struct pp_variant_list
        *variants;    /* not owned; NULL: no formula is replaced */
    bool plain;       /* true: no tables, beams and other short cuts (methods/fast/) */
    bool points_only; /* true: direct methods have no average over the working plane */
    struct pp_stop stop;
};

struct pp_method {
    const char *name;    /* as typed on the command line */
    const char *summary; /* one line, without a full stop */
    const char *source;  /* key in docs/SOURCES.md */
    const struct pp_formula *const
        *formulae; /* evaluated by `evaluate`, in this order; ends with NULL. NULL:
                    * none */
    enum pp_gives gives;
    enum pp_speaks_for speaks_for;
    bool of_real_room; /* true: fitted to real rooms. Obstructions and ground have the
                        * room's own values, not those of a standard room */
    bool of_all_surfaces; /* true: the average is over the room's surfaces, and not
                           * comparable with averages over the working plane */
    unsigned allowances;  /* corrections that the method's figures already contain, enum
                           * pp_allowance */
    double own_ground;    /* ground reflectance built into the method's figures, used in
                           * place of the room's; 0: none */
    bool takes_blinds;    /* true: figures are multiplied by the mean transmittance of a
                           * blind; false: a window with a blind is refused */
    bool of_well;     /* true: for rooms nested in an atrium or well, also behind its
                           * glass, and only for these */
    bool by_name;     /* true: not included in "all", since few rooms have receivers
                           * of the kind required */
    bool counts;      /* true: squares or dots are counted, so that readings are
                       * multiples of the value of one square or dot */
    bool any_pane;    /* uses only the diffuse transmittance of glass, so that it also
                       * covers panes that scatter by direction */
    bool has_average; /* PP_FOR_POINT only: evaluate without a receiver gives the
                       * average over the working plane, which replaces an integral over
                       * points */

    /* Reason why the method does not apply to this room, or to this receiver in the
     * room (NULL: the room as a whole): a static sentence ("valid only for the CIE
     * overcast sky"), or NULL if the method applies. NULL function: it always does.
     * Called by pp_method_refuses_room. */
    const char *(*refuses_room)(const struct pp_world *world,
                                const struct pp_outside_light *light,
                                const struct pp_receiver *receiver);

    /* Reason why the method does not cover this opening for this receiver (NULL for the
     * room), as the static end of a sentence that begins with "window W1" ("is not
     * vertical, but the method covers only vertical windows"), or NULL if the method
     * covers the opening. NULL function: the method covers all openings. Called by
     * pp_method_refuses_opening. */
    const char *(*refuses)(const struct pp_world *world,
                           const struct pp_outside_light *light,
                           const struct pp_opening *opening,
                           const struct pp_receiver *receiver);

    /* `refuses` does not depend on the receiver: it is called once for each opening of
     * a room, not again for each receiver. */
    bool refuses_alike;

    /* Makes the tools that serve for all points of one world under one light, such as a
     * diagram. Called only for a world that the method does not refuse. NULL function:
     * tools is NULL. On success *tools is freed by destroy_tools. */
    enum pp_status (*prepare)(void **tools, const struct pp_world *world,
                              const struct pp_outside_light *light,
                              struct pp_error *err);
    /* Replaces prepare, for a method whose figures depend on the options. */
    enum pp_status (*prepare_with_options)(void **tools, const struct pp_world *world,
                                           const struct pp_outside_light *light,
                                           const struct pp_method_options *options,
                                           struct pp_error *err);
    void (*destroy_tools)(void *tools); /* NULL tools are allowed */

    /* The components of one opening. Called only if neither refuses_room nor refuses
     * gives a reason, with all of `part` zero except its worksheet. May be called from
     * several threads at once. */
    enum pp_status (*evaluate)(const struct pp_world *world,
                               const struct pp_outside_light *light,
                               const struct pp_opening *opening,
                               const struct pp_receiver *receiver, const void *tools,
                               struct pp_part *part, struct pp_error *err);

    /* The mean of the components of one opening over the working plane of the beams'
     * world, for receivers that face up, in place of an integral over points; *known is
     * false if the method has no such mean for this opening. May be NULL. */
    enum pp_status (*average)(struct pp_beams *beams,
                              const struct pp_outside_light *light,
                              const struct pp_opening *opening, const void *tools,
                              struct pp_part *part, bool *known, struct pp_error *err);

    /* ---- fast ways to the same figures; not used with --plain; may be NULL ---- */

    /* Replaces prepare, for a method whose tools only save time. */
    enum pp_status (*prepare_fast)(void **tools, const struct pp_world *world,
                                   const struct pp_outside_light *light,
                                   struct pp_error *err);
    /* Replaces both `prepare` functions for many points of the working plane, facing
     * up, evaluated by evaluate_roughly; may take some milliseconds more. */
    enum pp_status (*prepare_for_plane)(void **tools, const struct pp_world *world,
                                        const struct pp_outside_light *light,
                                        struct pp_error *err);
    /* Replaces evaluate; faster, accurate to 1e-6 of the open sky or to a relative
     * error of about 1e-4. */
    enum pp_status (*evaluate_roughly)(const struct pp_world *world,
                                       const struct pp_outside_light *light,
                                       const struct pp_opening *opening,
                                       const struct pp_receiver *receiver,
                                       const void *tools, struct pp_part *part,
                                       struct pp_error *err);

    /* Returns a direct method that gives the same figures in this world, or NULL. */
    const struct pp_method *(*same_as)(const struct pp_world *world);
};

/* All methods, in the order in which results show them; ends with NULL. */
extern const struct pp_method *const pp_methods[];

/* pp_methods[index], for programs that link the shared library, which exports functions
 * but no data; NULL at the end of the list. index is at most one past the last method.
 */
const struct pp_method *pp_method_at(int index);

/* The method of that name, or NULL. */
const struct pp_method *pp_method_find(const char *name);

/* Reason why the method does not cover the room, as pp_method.refuses_room: also for
 * rooms that no method covers. NULL: it covers the room. */
const char *pp_method_refuses_room(const struct pp_method *method,
                                   const struct pp_world *world,
                                   const struct pp_outside_light *light,
                                   const struct pp_receiver *receiver);

/* Reason why the method does not cover an opening, as pp_method.refuses: also for
 * openings with a blind, unless the method takes them, and for panes that scatter by
 * direction, unless the method covers any pane. */
const char *pp_method_refuses_opening(const struct pp_method *method,
                                      const struct pp_world *world,
                                      const struct pp_outside_light *light,
                                      const struct pp_opening *opening,
                                      const struct pp_receiver *receiver);

/* The methods by name. Sky and externally reflected component: */
extern const struct pp_method pp_method_exact;
extern const struct pp_method pp_method_brs_table;
extern const struct pp_method pp_method_brs_rooflight;
extern const struct pp_method pp_method_waldram;
extern const struct pp_method pp_method_waldram_overlay;
extern const struct pp_method pp_method_pepper_pot;
extern const struct pp_method pp_method_pepper_pot_sky;
extern const struct pp_method pp_method_protractor;
extern const struct pp_method pp_method_protractor_upright;

/* Internally reflected component: */
extern const struct pp_method pp_method_bre;
extern const struct pp_method pp_method_bre_min;
extern const struct pp_method pp_method_bre_table;
extern const struct pp_method pp_method_split_flux;
extern const struct pp_method pp_method_sphere;
extern const struct pp_method pp_method_arndt;
extern const struct pp_method pp_method_dresler;
extern const struct pp_method pp_method_k_factor;
extern const struct pp_method pp_method_nomogram;

/* Internally reflected component by position, fitted to simulated rooms: */
extern const struct pp_method pp_method_irc_atlas;
extern const struct pp_method pp_method_bre_atlas;
extern const struct pp_method pp_method_split_flux_atlas;

/* The daylight factor as a whole: */
extern const struct pp_method pp_method_average_df;
extern const struct pp_method pp_method_average_df_above;
extern const struct pp_method pp_method_average_df_well;
extern const struct pp_method pp_method_average_df_lynes;
extern const struct pp_method pp_method_average_df_atlas;
extern const struct pp_method pp_method_efficiency;
extern const struct pp_method pp_method_lumen;
extern const struct pp_method pp_method_lumen_one;

#endif
