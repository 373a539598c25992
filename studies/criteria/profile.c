/* profile.c - the list of profiles. */
#include "studies/criteria/profile.h"

#include <stddef.h>
#include <string.h>

#include "model/base/text.h"

/* BR 209:2022: criteria for existing neighbours, and for new rooms. */
#define OF_NEIGHBOURS                                                                  \
    "vertical-sky,former-sky,obstruction,sunlight,gardens,no-sky-line,mirror-image"
#define OF_NEW "gardens,uk-annex,sun-exposure"

static const struct pp_profile profiles[] = {
    {.name = "uk-planning",
     .summary = "daylight and sunlight of neighbours and new rooms, by BR 209",
     .criteria = OF_NEIGHBOURS ",uk-annex,sun-exposure",
     .of_neighbours = OF_NEIGHBOURS,
     .of_new = OF_NEW,
     .country = "GB"},
    {.name = "br209-2022",
     .summary = "the same as uk-planning, by the name of its edition",
     .criteria = OF_NEIGHBOURS ",uk-annex,sun-exposure",
     .of_neighbours = OF_NEIGHBOURS,
     .of_new = OF_NEW,
     .country = "GB"},
    {.name = "en17037",
     .summary = "daylight provision, view out, sunlight and glare by EN 17037",
     .criteria = "en17037,en17037-hours,view-out,sun-exposure,glare",
     .country = ""},
    {.name = "uk-dwellings",
     .summary = "daylight in dwellings by the UK annex of EN 17037",
     .criteria = "uk-annex",
     .country = "GB"},
    {.name = "breeam",
     .summary = "average, uniformity and view of the sky, by BREEAM 2014 (superseded)",
     .criteria = "average,uniformity,sky-line",
     .country = ""},
    {.name = "leed-v4.1",
     .summary = "LEED v4.1, daylight, option 1: sDA and ASE; needs --weather",
     .criteria = "leed-v4.1",
     .country = ""},
    {.name = "rights-of-light",
     .summary = "adequately lit area for rights of light (English law)",
     .criteria = "rights-of-light",
     .country = "GB"},
    {.name = "de-dwelling",
     .summary = "window sizes by German building codes, and EN 17037",
     .criteria = "glazing-ratio,en17037",
     .country = "DE"},
};

enum { PROFILES = sizeof profiles / sizeof *profiles };

const struct pp_profile *pp_profile_at(int index)
{
    return index < PROFILES ? &profiles[index] : NULL;
}

const struct pp_profile *pp_profile_find(const char *name, struct pp_error *err)
{
    const char *names[PROFILES];
    for (int i = 0; i < PROFILES; i++) {
        names[i] = profiles[i].name;
        if (strcmp(name, names[i]) == 0)
            return &profiles[i];
    }
    pp_text_unknown(err, name, names, PROFILES, NULL, "there is no profile \"%.60s\"",
                    name);
    return NULL;
}
