/* year_method.h - interface of the hand methods for the year, and their list.
 *
 * A method calculates the illuminance of a point in every hour from illuminances
 * outside and from factors of the room: its daylight factor, or its factors under other
 * skies (reference_skies.h). The method's formulae are evaluated from their texts
 * (worksheet.h). A new method is one file with one struct pp_year_method, declared at
 * the end of this header and entered in the list in year_method.c.
 */
#ifndef PP_STUDIES_YEAR_HAND_YEAR_METHOD_H
#define PP_STUDIES_YEAR_HAND_YEAR_METHOD_H

#include "model/results/worksheet.h"
#include "studies/year/hand/hand_case.h"

enum { PP_YEAR_STATES_MOST = 2, PP_YEAR_METHODS_MOST = 16 };

/* Illuminances of a point in one hour; a method with several states of the sky gives the
 * probability of each. */
struct pp_year_states {
    int count;
    struct {
        double share, lx;
    } list[PP_YEAR_STATES_MOST];
};

struct pp_year_method {
    const char *name;        /* as typed on the command line */
    const char *summary;     /* one line, without a full stop */
    const char *source;      /* key in docs/SOURCES.md */
    const char *assumptions; /* choices where the sources leave room; sentences */
    const struct pp_formula *const *formulae; /* all that `evaluate` uses; ends with
                                               * NULL */

    /* Reason why the method does not apply to the room and the weather file, as a
     * static sentence; NULL if the method applies. NULL function: the method always
     * applies. */
    const char *(*refuses)(const struct pp_hand_case *of);

    /* Prepares data (tools) for all points and hours, and adds the skies that these
     * data need. NULL function: tools is NULL. On success *tools is freed by free. */
    enum pp_status (*prepare)(void **tools, struct pp_hand_case *of,
                              struct pp_error *err);

    /* Evaluates one hour; called from several threads at once. */
    void (*evaluate)(const struct pp_hand_case *of, const void *tools, int point,
                     const struct pp_hand_hour *hour, struct pp_worksheet *sheet,
                     struct pp_year_states *states);
};

/* All methods, in the order in which results show them; ends with NULL. */
extern const struct pp_year_method *const pp_year_methods[];

/* Selected methods, in the order of the list. */
struct pp_year_methods_choice {
    int count;
    const struct pp_year_method *list[PP_YEAR_METHODS_MOST];
};

/* Reads "all", or names separated by commas. PP_BAD_INPUT with the valid names. */
enum pp_status pp_year_method_choose(struct pp_year_methods_choice *choice,
                                     const char *text, struct pp_error *err);

extern const struct pp_year_method pp_year_method_df_diffuse;
extern const struct pp_year_method pp_year_method_df_global;
extern const struct pp_year_method pp_year_method_df_orientation;
extern const struct pp_year_method pp_year_method_df_rule;
extern const struct pp_year_method pp_year_method_doe2;
extern const struct pp_year_method pp_year_method_adeline;
extern const struct pp_year_method pp_year_method_adeline_mean;
extern const struct pp_year_method pp_year_method_four_skies;
extern const struct pp_year_method pp_year_method_classes;
extern const struct pp_year_method pp_year_method_classes_scaled;

#endif
