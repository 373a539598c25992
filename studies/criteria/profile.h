/* profile.h - named sets of criteria, one for each kind of report. */
#ifndef PP_STUDIES_CRITERIA_PROFILE_H
#define PP_STUDIES_CRITERIA_PROFILE_H

#include "model/base/error.h"

struct pp_profile {
    const char *name;          /* as typed on the command line */
    const char *summary;       /* one line for the help, without a full stop */
    const char *criteria;      /* names separated by commas */
    const char *of_neighbours; /* criteria for rooms of a site that exist in its former
                                * state; NULL: `criteria` */
    const char *of_new;        /* criteria for rooms of a site that are new; NULL:
                                * `criteria` */
    const char *country;       /* country of the rules; "": no single one */
};

/* Profiles in the order shown; NULL past the last. */
const struct pp_profile *pp_profile_at(int index);

/* The profile of that name; NULL, with PP_BAD_INPUT in err, if there is none. */
const struct pp_profile *pp_profile_find(const char *name, struct pp_error *err);

#endif
